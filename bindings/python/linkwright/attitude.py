"""Attitudes and screws: what ``linkwright attitude`` computes, as dicts of numpy arrays.

Angles are in degrees, ``_deg`` in the name; quaternions are [w, x, y, z]; matrices have the axes of the moving frame in
their columns. What goes in and comes out is that of the files (``schema/attitude.schema.json``), ``"linkwright": 1`` may
be left out. Theory and sources: ``docs/theory/attitude.md``.
"""

from __future__ import annotations

import json
from typing import Any, Mapping, Sequence

import numpy as np
import numpy.typing as npt

from . import _linkwright
from .records import Record, record_of
from .tasks import orientation as _orientation
from .tasks import to_json

Vectors = Sequence[Sequence[float]]


def convert(orientation: Any, vectors: Vectors | None = None) -> Record:
    """An orientation in every representation.

    Args:
        orientation: scipy's ``Rotation``, a unit quaternion [w, x, y, z], a 3×3 matrix, or a dict with one of
            ``matrix``, ``axis`` and ``angle_deg``, ``quaternion``, ``rotation_vector``, ``rodrigues``, ``mrp``,
            ``euler_deg`` and ``sequence``, ``turns``, ``triads``.
        vectors: (n, 3), to be rotated.

    Returns:
        ``matrix`` (3, 3), ``quaternion`` (4,), ``axis``, ``angle_deg``, ``rotation_vector``, ``rodrigues`` (None for a
        half-turn), ``mrp``, ``euler_deg`` (twelve sequences), ``locked``, ``lock_distance``, …, and ``images`` of the
        vectors; ``_repr_svg_()`` draws it.
    """
    text = _text({"orientation": _orientation(orientation), "vectors": vectors})
    return _record(_linkwright.attitude.convert(text), _linkwright.attitude.convert_svg, text)


def screw(
    displacement: Mapping[str, Any] | npt.ArrayLike, points: Vectors | None = None, directions: Vectors | None = None
) -> Record:
    """The screw of a displacement (Chasles): one rotation about and one translation along an axis.

    Args:
        displacement: a 4×4 matrix, or a dict as in files: ``orientation`` and ``translation``, ``screw``, or ``from``
            and ``to``.
        points, directions: (n, 3), to be displaced.
    """
    given = displacement if isinstance(displacement, Mapping) else {"matrix": np.asarray(displacement, dtype=float)}
    text = _text({"displacement": _with_orientations(given), "points": points, "directions": directions})
    return _record(_linkwright.attitude.screw(text), _linkwright.attitude.screw_svg, text)


def twist(twist: Mapping[str, Any], points: Vectors | None = None) -> Record:
    """The instantaneous screw of a twist, and the velocities of points.

    Args:
        twist: ``angular_velocity`` and ``velocity`` of the point ``at`` (what is missing being 0), or ``screw``.
        points: (n, 3), fixed frame.
    """
    return _record(_linkwright.attitude.twist(_text({"twist": twist, "points": points})))


def rates(
    orientation: Any,
    motion: Mapping[str, Any],
    *,
    origin: Mapping[str, Any] | None = None,
    points: Sequence[Mapping[str, Any]] | None = None,
    step: float | None = None,
) -> Record:
    """An angular motion in every representation: angular velocity and acceleration, derivatives of matrix, quaternion
    and angles, velocities and accelerations of points.

    Args:
        orientation: as of :func:`convert`.
        motion: ``velocity`` and ``acceleration`` (radians by time; ``frame`` "fixed" or "moving"), or derivatives of
            matrix, quaternion or angles, as in files.
        origin, points: ``position``, ``velocity``, ``acceleration``.
        step: a time after which the attitude is asked for, at constant angular velocity.
    """
    members = {"motion": motion, "origin": origin, "points": points, "step": step}
    return _record(_linkwright.attitude.rates(_text({"orientation": _orientation(orientation), **members})))


def dh(
    links: Sequence[Mapping[str, float]] | None = None,
    *,
    form: str = "classic",
    points: Vectors | None = None,
    displacement: Mapping[str, Any] | None = None,
) -> Record:
    """A chain of links by Hartenberg–Denavit parameters; or the four parameters of a displacement.

    Args:
        links: each with ``theta_deg``, ``d``, ``a``, ``alpha_deg``; what is missing is 0.
        form: "classic" or "modified".
        points: (n, 3), in the frame of the last link.
        displacement: instead of links, as of :func:`screw`.
    """
    members: dict[str, Any] = {"form": form, "links": links, "points": points}
    if displacement is not None:
        members["displacement"] = _with_orientations(displacement)
    return _record(_linkwright.attitude.dh(_text(members)))


def _with_orientations(displacement: Mapping[str, Any]) -> dict[str, Any]:
    given = dict(displacement)
    if "orientation" in given:
        given["orientation"] = _orientation(given["orientation"])
    for end in ("from", "to"):
        if isinstance(given.get(end), Mapping):
            given[end] = _with_orientations(given[end])
    return given


def _text(members: Mapping[str, Any]) -> str:
    return to_json({"linkwright": 1, **{key: value for key, value in members.items() if value is not None}})


def _record(text: str, draw: Any = None, question: str = "") -> Record:
    return record_of(json.loads(text), lambda: draw(question) if draw else None)
