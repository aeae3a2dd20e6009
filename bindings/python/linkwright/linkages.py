"""One linkage: what it is, what it does, and the files that it makes."""

from __future__ import annotations

import json
import os
import warnings
from typing import Any, Mapping, Sequence

import numpy as np

from . import _linkwright
from .errors import ProblemError
from .records import Record, read_only, record_of
from .region import Array
from .tasks import is_json, to_json


class Linkage:
    """A linkage as it lies in position 1, and what is known of it.

    ``properties`` has all of it; what is asked for most often has a name of its own. Lengths are in the user's unit,
    angles in degrees. Made of a file's text or dict by :meth:`read`, or found in an answer.
    """

    def __init__(self, native: _linkwright.Linkage, number: int = 0) -> None:
        self._native = native
        self.number = number
        """Place among the answer's linkages, from 1; 0 for one that was not in an answer."""
        self._properties: Record | None = None

    @staticmethod
    def read(linkage: Mapping[str, Any] | str | "os.PathLike[str]") -> Linkage:
        """A linkage from a dict, JSON text or file: lengths, pivots, axes, angles, or what ``export`` wrote.

        Raises:
            ProblemError: it has mistakes.
        """
        file = ""
        if isinstance(linkage, (str, os.PathLike)) and not is_json(linkage):
            file = os.fspath(linkage)
            text = _file_text(file)
        else:
            text = linkage if isinstance(linkage, str) else json.dumps(linkage, default=_plain_number)
        try:
            return linkage_of(_linkwright.Linkage(text), 0)
        except ProblemError as error:
            raise ProblemError(error.mistakes, file) from None

    @property
    def properties(self) -> Record:
        """Everything that the result file says of it."""
        if self._properties is None:
            record = self._native.record()
            if not record:
                stored = json.loads(self._native.exported("json"))
                self._properties = record_of(stored.get("linkage", stored))
            else:
                self._properties = record_of(json.loads(record))
        return self._properties

    def __getitem__(self, name: str) -> Any:
        return self.properties[name]

    @property
    def title(self) -> str:
        """As pictures and files have it."""
        return self._native.title()

    @property
    def length_unit(self) -> str:
        """Echoed from the problem; empty where it does not say."""
        return self._native.length_unit()

    @property
    def type(self) -> str | None:
        """Linkage type, one of :data:`linkwright.linkage_types`; None where it is not known without analyze()."""
        return self.properties.get("type")

    @property
    def defects(self) -> Record | None:
        """``order``, ``branch`` and ``circuit``, bool; None where there are no positions."""
        return self.properties.get("defects")

    @property
    def drive(self) -> str | None:
        """Which way the input turns through the positions: ``ccw``, ``cw`` or ``either``; None where it cannot."""
        return self.properties.get("drive")

    @property
    def min_transmission_angle_deg(self) -> float | None:
        """The least transmission angle over the task, degrees in [0, 90]."""
        return self.properties.get("min_transmission_angle_deg")

    @property
    def residual(self) -> float | None:
        """How far it is from doing the task: the largest relative change of a grounded link's length (planar)."""
        return self.properties.get("residual")

    @property
    def verified(self) -> bool | None:
        """Its motion through the task was simulated, by a method that shares nothing with the one that found it."""
        return self.properties.get("verified_by_driving")

    def motion(self) -> Array:
        """Its motion from position 1 on, as ``export --format csv`` tells it, to the last bit.

        Returns:
            A read-only structured array, a row a degree of the input link and one at each position exactly; fields are
            the columns of the CSV table, float64, NaN where the table has nothing; ``position`` is 0 between positions.
            pandas' DataFrame takes it as it is.
        """
        names, values = self._native.motion()
        table = np.empty(len(values), dtype=[(name, np.int64 if name == "position" else np.float64) for name in names])
        for column, name in enumerate(names):
            table[name] = np.nan_to_num(values[:, column]) if name == "position" else values[:, column]
        return read_only(table)

    def analyze(self, drive: str = "input") -> Record:
        """What it can do: type, dead points, transmission angles, velocities and the path over its cycle.

        Args:
            drive: ``"input"`` or ``"output"``: which of its grounded links drives it.

        Returns:
            What ``linkwright analyze -o`` writes: columns of the motion as arrays.
        """
        return record_of(json.loads(self._native.analysis(drive)))

    def compare(
        self,
        points: Any,
        *,
        input_deg: Any = None,
        closed: bool = False,
        timing: str = "relative",
        point: Sequence[float] | None = None,
        body: Sequence[float] | None = None,
        turning_length: float | None = None,
    ) -> Record:
        """How near the path of its coupler point comes to points, or its body to poses, on the circuit in which it
        lies: what ``linkwright analyze --compare`` writes. Planar four-bars only.

        Args:
            points: n × 2, in the order in which they are passed, three or more; user's unit. Or poses, n × 3: x, y and
                theta_deg.
            input_deg: the angle of the input link at each point, degrees; None: whatever the timing.
            closed: the path goes on from the last point to the first.
            timing: of ``input_deg``: ``"relative"``, from any datum and in either sense, or ``"absolute"``, from the x axis.
            point: of the coupler as the linkage lies, (x, y), instead of its own.
            body: with poses: where the body is as the linkage lies, (x, y, theta_deg); None: in the first of the poses
                that it passes.
            turning_length: with poses: by it an error of angle weighs as one of position; None: the characteristic
                length of the poses.

        Raises:
            ProblemError: fewer than three different points or poses, no coupler point, nothing that says where the body
                is, angles that its input does not reach, ….
        """
        if timing not in ("relative", "absolute"):
            raise ValueError(f"timing is 'relative' or 'absolute', not {timing!r}")
        rows = [tuple(float(number) for number in row) for row in points]
        says_poses = bool(rows) or body is not None or turning_length is not None
        if says_poses and all(len(row) == 3 for row in rows):
            if input_deg is not None or closed or point is not None:
                raise ValueError("input_deg, closed and point go with points, not with poses")
            return self._compare_poses(rows, body, turning_length)
        if body is not None or turning_length is not None:
            raise ValueError("body and turning_length go with poses, not with points")
        places = [(x, y) for x, y in rows]
        angles = [] if input_deg is None else [float(angle) for angle in input_deg]
        if angles and len(angles) != len(places):
            raise ValueError(f"{len(angles)} angles are given for {len(places)} points")
        pair = None if point is None else (float(point[0]), float(point[1]))
        text, svg = self._native.comparison(places, angles, closed, timing == "absolute", pair)
        return record_of(json.loads(text)["comparison"], lambda: svg)

    def _compare_poses(self, poses: list[Any], body: Sequence[float] | None, turning_length: float | None) -> Record:
        lies = None
        if body is not None:
            x, y, theta_deg = body
            lies = (float(x), float(y), float(theta_deg))
        text, svg = self._native.pose_comparison(poses, lies, turning_length)
        return record_of(json.loads(text)["pose_comparison"], lambda: svg)

    def instant(
        self,
        point: Sequence[float] | None = None,
        *,
        input_deg: float | None = None,
        input_acceleration: float = 0,
    ) -> Record:
        """What one instant of the coupler's motion tells: pole, inflection circle, Bresse circle, stationary curvature,
        Ball's point, Burmester points (sources: ``docs/theory/infinitesimal.md``). Planar four-bars only.

        Args:
            point: of the coupler as the linkage lies, (x, y), whose path is asked about.
            input_deg: angle of the input link from the ground link, degrees; None: as it lies.
            input_acceleration: of the input's turn over its squared velocity; 0 where it turns evenly.

        Raises:
            ProblemError: the linkage is not a planar four-bar, or its input cannot be there.
        """
        pair = None if point is None else (float(point[0]), float(point[1]))
        text, svg = self._native.instant(pair, input_deg, input_acceleration)
        return record_of(json.loads(text)["instant"], lambda: svg or None)

    def export(self, format: str = "json") -> str:
        """As text, as ``linkwright export`` writes it.

        Args:
            format: ``svg``, ``dxf``, ``csv`` or ``json``.

        Raises:
            ValueError: the format is not known, or cannot carry the linkage.
        """
        if format not in _formats:
            raise ValueError(f"{format!r} is not a format of linkages: take one of {', '.join(_formats)}")
        text = self._native.exported(format)
        if not text:
            raise ValueError(
                "the links of a spherical four-bar are arcs on a sphere, which no drawing in a plane shows at true size; "
                "export it as svg, csv or json"
            )
        return text

    def build(self, format: str = "step", *, position: int | None = None, **sizes: float) -> bytes:
        """As a machine: plates with round ends, pins and a ground plate in layers that do not collide, as
        ``linkwright export`` writes it. Where there are no such layers, a warning says what meets.

        Args:
            format: ``step`` (an assembly for CAD; needs the component that stands on OpenCASCADE), ``stl`` or ``3mf`` (to
                print), ``plates`` (DXF, to cut); ``mjcf``, ``sdf`` or ``urdf`` (for simulators, in metres and kilograms).
            position: of the task, from 1, in which a STEP file shows it; None: the first.
            sizes: ``width``, ``thickness``, ``gap``, ``pin``, ``clearance`` and, of spherical linkages, ``radius`` in the
                task's unit of length; what is missing comes from the longest link. For simulators ``density``, kg/m³.

        Raises:
            ProblemError: sizes that do not fit the linkage; no such position; no component for STEP files.
            ValueError: the format or a size is not known.
        """
        if format not in _machine_formats:
            raise ValueError(f"{format!r} is not a format of machines: take one of {', '.join(_machine_formats)}")
        unknown = sorted(set(sizes) - set(_sizes))
        if unknown:
            raise ValueError(f"{unknown[0]!r} is not a size of plates: take one of {', '.join(_sizes)}")
        content, warning = self._native.built(format, {name: float(size) for name, size in sizes.items()}, position)
        if warning:
            warnings.warn(warning, stacklevel=2)
        return content

    def save(self, path: str | "os.PathLike[str]", **wishes: Any) -> None:
        """Writes it to a file, in the format that its name ends in; ``wishes`` are those of :meth:`build`."""
        format = os.path.splitext(os.fspath(path))[1].lstrip(".") or "json"
        if format in _machine_formats:
            write_file(path, self.build(format, **wishes))
        else:
            write_file(path, self.export(format, **wishes))

    def plot(self, ax: Any = None, **options: Any) -> Any:
        """Draws it in its positions: see :func:`linkwright.plot.linkage`. Returns matplotlib's axes."""
        from . import plot

        return plot.linkage(self, ax, **options)

    def _repr_svg_(self) -> str:
        return self._native.exported("svg")

    def __repr__(self) -> str:
        angle = self.min_transmission_angle_deg
        told = f", transmission angle {angle:.2f}°" if angle is not None else ""
        return f"<{type(self).__name__} {self.type or ''}{told}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return _unpickled_linkage, (self._native.exported("json"), self.number)


class FourBar(Linkage):
    """A planar four-bar."""

    @property
    def lengths(self) -> Record:
        """``ground``, ``input``, ``coupler``, ``output``; user's unit."""
        lengths: Record = self.properties["lengths"]
        return lengths

    @property
    def pivots(self) -> dict[str, Array]:
        """``input_fixed``, ``input_moving``, ``output_fixed``, ``output_moving`` in position 1, each (2,), fixed frame."""
        of = self.properties
        if "pivots" in of:
            held = of["pivots"]
            old = {"input_fixed": "input_center", "input_moving": "input_circle"}
            old |= {"output_fixed": "output_center", "output_moving": "output_circle"}
            return {name: held[name] if name in held else held[former] for name, former in old.items()}
        sides = {"input": of["input"], "output": of["output"]}
        kinds = {"fixed": "center_point", "moving": "circle_point"}
        return {f"{side}_{kind}": dyad[key] for side, dyad in sides.items() for kind, key in kinds.items()}


    @property
    def full_turn(self) -> bool | None:
        """Paths: the crank turns fully, so that the path is closed; None of other tasks."""
        return self.properties.get("full_turn")

    @property
    def elbows(self) -> str | None:
        """Paths with points at which no angle is given: on which side of the line from the arm's ground pivot to each of
        them its elbow stands, ``+`` left or ``-`` right, and which of the further dyads, e.g. ``+-++- 2``; else None."""
        return self.properties.get("elbows")


class SixBar(Linkage):
    """A planar six-bar, driven by body 1 at hinge a."""

    @property
    def joints(self) -> Record:
        """The seven hinges in position 1, each (2,), fixed frame."""
        joints: Record = self.properties["joints"]
        return joints

    @property
    def topology(self) -> str:
        """``watt_1``, ``stephenson_1``, …"""
        return str(self.properties["topology"])


class SphericalFourBar(Linkage):
    """A spherical four-bar: its links are arcs about one centre."""

    @property
    def angles_deg(self) -> Record:
        """Link angles ``ground``, ``input``, ``coupler``, ``output``, degrees."""
        angles: Record = self.properties["angles_deg"]
        return angles

    @property
    def axes(self) -> dict[str, Array]:
        """``input_fixed``, ``input_moving``, ``output_fixed``, ``output_moving`` in position 1: unit vectors, (3,)."""
        of = self.properties
        if "axes" in of:
            return dict(of["axes"])
        return {f"{side}_{kind}": of[side][f"{kind}_axis"] for side in ("input", "output") for kind in ("fixed", "moving")}


def linkage_of(native: _linkwright.Linkage, number: int) -> Linkage:
    made = Linkage(native, number)
    kind = made.properties.get("mechanism")
    made.__class__ = {"six_bar": SixBar, "spherical_four_bar": SphericalFourBar}.get(kind or "", FourBar)
    return made


def _unpickled_linkage(text: str, number: int) -> Linkage:
    return linkage_of(_linkwright.Linkage(text), number)


def _file_text(path: str) -> str:
    try:
        return _linkwright.read_result_file(os.fsencode(path)).decode("utf-8")
    except ProblemError as error:
        raise ProblemError(error.mistakes, path) from None


def write_file(path: str | "os.PathLike[str]", text: str | bytes) -> None:
    failure = _linkwright.write_file(os.fspath(path), text)
    if failure:
        raise OSError(f"{os.fspath(path)}: {failure}")


def _plain_number(value: Any) -> Any:
    return value.tolist() if isinstance(value, (np.ndarray, np.generic)) else to_json(value)


_formats = ("svg", "dxf", "csv", "json")
_machine_formats = tuple(_linkwright.machine_formats())
_sizes = ("width", "thickness", "gap", "pin", "clearance", "radius", "density")
