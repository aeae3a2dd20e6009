"""Sessions: one problem at a time, kept with all that was computed from it, for live use."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any, Mapping

import numpy as np
import numpy.typing as npt

from . import _linkwright
from .records import Record, record_of
from .tasks import ProblemLike, native

Array = npt.NDArray[Any]


@dataclass(frozen=True)
class LiveMap:
    """The solution region of a session's problem as it was when it was asked for. Arrays are read-only copies.

    Rows and columns stand as a display likes them: when a pose is moved the axes keep the order that they had, so that the
    picture does not jump. `input` and `output` say which sample is which.

    Attributes:
        input, output: coordinates of rows and columns, float64.
        types: code of the linkage type (:data:`linkwright.linkage_types`), uint8, (rows, columns).
        defects: bits 1 order, 2 branch, 4 circuit, uint8, (rows, columns).
        failures: a bit for each requirement that a cell fails, uint32, (rows, columns); 0: it meets all.
        values: the measure that was asked for, float32, (rows, columns); angles in degrees, 0 where not defined.
        counts: linkages by type and defect, those that meet the requirements, what each requirement costs, and which alone
            keeps all others out.
        task: what is known of the task: pattern, condition, characteristic length, warnings.
    """

    input: Array
    output: Array
    types: Array
    defects: Array
    failures: Array
    values: Array
    counts: Record
    task: Record

    @property
    def meets(self) -> Array:
        """Cells that meet all requirements, bool, (rows, columns)."""
        return np.asarray(self.failures == 0)


class Session:
    """A problem that changes while it is looked at: after a change only what is new is computed.

    Threads may share it; one at a time is served, and others run on meanwhile.

    Args:
        problem: as of :func:`linkwright.solve`.

    Raises:
        ProblemError: the problem has mistakes.
    """

    def __init__(self, problem: ProblemLike) -> None:
        first = native(problem)
        self._session = _linkwright.Session(first)
        self._problem: dict[str, Any] = json.loads(first.text())

    def set(self, problem: ProblemLike) -> None:
        """Puts another problem, or the same after a change, in place. With mistakes the last good one stays."""
        new = native(problem)
        self._session.set(new)
        self._problem = json.loads(new.text())

    @property
    def problem(self) -> dict[str, Any]:
        """The problem at hand, a copy as a dict: change it and set() it."""
        copy: dict[str, Any] = json.loads(json.dumps(self._problem))
        return copy

    def move(self, position: int, **members: float) -> None:
        """Changes a pose of the task, or a point of a path: ``move(3, x=-210)``.

        Args:
            position: from 1.
            members: of the pose or point, e.g. ``x``, ``y``, ``theta_deg``.
        """
        problem = self.problem
        name = "point" if problem["task"]["kind"] == "path" else "pose"
        places = problem["task"].get(f"{name}s") or []
        if not 1 <= position <= len(places):
            raise IndexError(f"there is no {name} {position}: this task has {len(places)}")
        places[position - 1].update(members)
        self.set(problem)

    def explore(
        self,
        samples: int = 400,
        measure: str = "min_transmission_angle_deg",
        input: tuple[float, float] = (0, 1),
        output: tuple[float, float] = (0, 1),
    ) -> LiveMap | None:
        """The solution region; None where the task has none.

        Args:
            samples: N of the N × N map.
            measure: what ``values`` show.
            input, output: part of each axis that is looked at, in shares of it.
        """
        reply = self._session.explore(samples, (input[0], input[1]), (output[0], output[1]), measure)
        if "counts" not in reply:
            return None
        counts, task = record_of(reply.pop("counts")), Record(reply.pop("task"))
        for name in ("types", "meeting_types", "only", "left"):
            counts[name] = counts[name].astype(int)
        return LiveMap(**reply, counts=counts, task=task)

    def linkage(self, input: float, output: float) -> Record:
        """The linkage at a place of the map, by both coordinates, as result files have it; nothing of that where there is none.

        Beside it ``reason``, why there is none or it does not do the task (None: it does), and ``states`` of its travel:
        float64, a row a state, the driver's turn from position 1 and the transmission angle in degrees, then the coordinates of
        each hinge.
        """
        text, reason, states = self._session.linkage(input, output)
        record = record_of(json.loads(text)["linkages"][0] if text else {})
        record["reason"], record["states"] = reason or None, states
        return record

    def all_at(self, input: float, output: float) -> list[tuple[float, float]]:
        """Where the linkages stand that share a place of the map, the best by the requirements first: coordinates for
        :meth:`linkage` and :meth:`export`. Several only of paths with layers; elsewhere the place itself."""
        return self._session.all_at(input, output)

    def best(self, most: int = 1) -> list[Record]:
        """The best linkages, at most so many, best first, as result files have them."""
        text = self._session.best(most)
        return [record_of(linkage) for linkage in json.loads(text)["linkages"]] if text else []

    def improve(self, input: float, output: float) -> tuple[float, float]:
        """The place of the best linkage that a climb from here reaches."""
        first, second = self._session.improve(input, output)
        return first, second

    def export(self, input: float, output: float, format: str = "svg") -> str:
        """The linkage at a place as text: ``svg``, ``dxf``, ``csv``, ``json``, or ``result``; empty where none is."""
        return self._session.exported(input, output, format)
