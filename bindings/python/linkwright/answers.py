"""Everything found for a task."""

from __future__ import annotations

import csv
import io
import json
import math
import os
from typing import Any, Mapping, Sequence

import numpy as np
import numpy.typing as npt

from . import _linkwright
from .linkages import Linkage, linkage_of, write_file
from .records import Record, record_of
from .region import Kept, Region, Views


def _curves_of(table: str) -> dict[str, dict[str, npt.NDArray[np.float64]]]:
    """The columns of a table of curves, by its first one."""
    heads, *rows = csv.reader(io.StringIO(table))
    by_case: dict[str, list[list[float]]] = {}
    for name, *numbers in rows:
        by_case.setdefault(name, []).append([float(number) if number else math.nan for number in numbers])
    return {name: dict(zip(heads[1:], np.array(found).T)) for name, found in by_case.items()}


class Answer:
    """Everything found for a task. Its numbers are those of the result file, to the last bit.

    Pickled it keeps its result and its region; the picture alone is computed anew when it is asked for.
    """

    def __init__(self, problem_text: str, result_text: str | None, columns: Any, solved: _linkwright.Solved | None):
        self._problem_text, self._text, self._columns_of, self._solved = problem_text, result_text, columns, solved
        self._result: Record | None = None
        self._linkages: list[Linkage] | None = None
        self._region: Region | None = None

    @staticmethod
    def _of(solved: _linkwright.Solved, problem_text: str) -> Answer:
        return Answer(problem_text, None, None, solved)

    def _result_text(self) -> str:
        if self._text is None:
            assert self._solved is not None
            self._text = self._solved.result(False)
        return self._text

    @property
    def result(self) -> Record:
        """The whole result file (``schema/result.schema.json``) without the region's arrays."""
        if self._result is None:
            self._result = record_of(json.loads(self._result_text()))
        return self._result

    def __getitem__(self, name: str) -> Any:
        return self.result[name]

    @property
    def status(self) -> str:
        """``solved``, ``no_solution`` or ``degenerate``."""
        return str(self.result["status"])

    @property
    def reason(self) -> str:
        """A sentence on what was found, or why nothing was."""
        return str(self.result["reason"])

    @property
    def pattern(self) -> str:
        """Of the positions: ``P-P-P-P``, ``PP-P-P``, …"""
        return str(self.result["pattern"])

    @property
    def characteristic_length(self) -> float:
        """Of the task, user's unit."""
        return float(self.result["characteristic_length"])

    @property
    def warnings(self) -> list[str]:
        """What to know before trusting the numbers, a sentence each."""
        return [str(warning["message"]) for warning in self.result["warnings"]]

    @property
    def problem(self) -> Record:
        """The problem, with the defaults that were used."""
        problem: Record = self.result["problem"]
        return problem

    @property
    def linkages(self) -> list[Linkage]:
        """The best linkages, best first: :class:`FourBar`, :class:`SixBar` or :class:`SphericalFourBar`."""
        if self._linkages is None:
            found = _linkwright.linkages_of_result(self._result_text())
            self._linkages = [linkage_of(native, number) for number, native in enumerate(found, 1)]
        return list(self._linkages)

    @property
    def dyads(self) -> list[Record]:
        """Five positions: all real dyads, with their residuals and multiplicities."""
        return list(self.result["dyads"])

    @property
    def curve(self) -> Record | None:
        """The curve of dyads: ``kind``, ``branches``, and ``samples``, of planar tasks ``coordinate`` (N,),
        ``center_homogeneous`` and ``circle_homogeneous`` (N, 3) as [w, x, y]; None where there is none."""
        return self.result.get("curve")

    @property
    def region(self) -> Region | None:
        """The solution region; None where the task has no map."""
        if self._region is None and self.result["region"] is not None:
            columns = self._columns_of if self._columns_of is not None else Views(self._native())
            about = self.result["region"]
            if columns["types"].size:
                self._region = Region(columns, about, columns.requirements, columns.measures)
        return self._region

    def tolerance(
        self,
        linkage: Linkage | int = 1,
        *,
        length: float | None = None,
        samples: int | None = None,
        seed: int | None = None,
    ) -> Record:
        """What tolerances do to a linkage: error to first order and sampled, yield, what contributes what.

        Args:
            linkage: one of :attr:`linkages`, or its number, from 1.
            length: half tolerance of every length and pivot, user's unit, instead of the problem's.
            samples, seed: how many linkages are made, and which.

        Returns:
            The ``tolerance`` of ``linkwright tolerance -o``; ``_repr_svg_()`` draws it.

        Raises:
            ProblemError: the problem has no tolerances and none are given, or the linkage stands at a dead point.
        """
        number = linkage.number if isinstance(linkage, Linkage) else linkage
        text, svg = _linkwright.tolerance(self._result_text(), number, length, samples, seed)
        return record_of(json.loads(text)["tolerance"], lambda: svg)

    def loads(
        self, linkage: Linkage | int = 1, *, case: str | None = None, free_share: float | None = None
    ) -> Record:
        """The forces in a linkage from position 1 to the last one, by the ``loads`` of the problem.

        Args:
            linkage: one of :attr:`linkages`, or its number, from 1.
            case: one of the cases; all where it is not given.
            free_share: of the real springs of the balance the free length, by the shortest that they get, in [0, 1];
                0.75 where it is not given.

        Returns:
            The ``report`` of ``linkwright loads -o``, its ``balance`` (None where a force turns with its link), and
            ``curves``: by case a dict of arrays, one value a station, under the names of its table
            (``body_turn_deg``, ``open_N``, ``close_N``, …, in motion ``time_s``; NaN where there is none).
            ``_repr_svg_()`` draws it.

        Raises:
            ProblemError: the problem has no loads or no such case, or the linkage does not get through its positions
                in order without a dead point.
        """
        number = linkage.number if isinstance(linkage, Linkage) else linkage
        text, table, svg = _linkwright.loads(self._result_text(), number, case, free_share)
        study = json.loads(text)
        report = study["report"] | {"balance": study["balance"]}
        report["curves"] = _curves_of(table)
        return record_of(report, lambda: svg)

    def place_spring(
        self, boxes: Mapping[str, Any], linkage: Linkage | int = 1, *, catalogue: Mapping[str, Any] | None = None
    ) -> Record:
        """Where a gas spring between ground and body helps the hand most, its studs in two boxes, and the proof.

        Ctrl-C stops it (KeyboardInterrupt).

        Args:
            boxes: what ``linkwright loads --place-springs`` reads: ``spring``, ``ground``, ``body``, ``max_F1``, …
            linkage: one of :attr:`linkages`, or its number, from 1.
            catalogue: what ``--catalogue`` reads; its parts are then ranked, in ``parts`` and ``missed``.

        Returns:
            ``spring``, as it may stand in the ``springs`` of loads, None where there is none (``why_not`` says why);
            ``max_hand_force`` in newtons, ``lower_bound``, ``proven``.

        Raises:
            ProblemError: what is wrong with the boxes, the catalogue or the loads, at its place.
        """
        number = linkage.number if isinstance(linkage, Linkage) else linkage
        parts = None if catalogue is None else json.dumps(catalogue)
        return record_of(json.loads(_linkwright.place_spring(self._result_text(), number, json.dumps(boxes), parts)))

    def instant(self, point: Sequence[float] | None = None) -> Record:
        """Of a task of one pose with three derivatives: what that instant tells, as of :meth:`Linkage.instant`."""
        return instant(self._problem_text, point)

    def export(self, format: str = "json", *, with_region: bool = False) -> str:
        """As text: ``json``, the result file, or ``svg``, the picture of ``linkwright solve --svg``.

        Args:
            with_region: the result file with the region's arrays, as base64.
        """
        if format == "svg":
            return self._native().svg()
        if format != "json":
            raise ValueError(f"{format!r} is not a format of answers: take json or svg, or export one of its linkages")
        return self._native().result(True) if with_region else self._result_text()

    def save(self, path: str | "os.PathLike[str]", *, with_region: bool = False) -> None:
        """Writes it to a file, a picture where its name ends in ``.svg``, else the result file."""
        format = "svg" if os.fspath(path).endswith(".svg") else "json"
        write_file(path, self.export(format, with_region=with_region))

    def plot(self, **options: Any) -> Any:
        """Draws poses, curves, the best linkage and the solution region: see :func:`linkwright.plot.answer`. Returns
        matplotlib's figure."""
        from . import plot

        return plot.answer(self, **options)

    def _native(self) -> _linkwright.Solved:
        """The same input gives the same answer."""
        if self._solved is None:
            problem = _linkwright.Problem(self._problem_text)
            self._solved = _linkwright.solve(problem, None, _linkwright.Cancellation())
        return self._solved

    def _repr_svg_(self) -> str:
        return self.export("svg")

    def __repr__(self) -> str:
        return f"<Answer {self.status}: {self.reason}>"

    def __reduce__(self) -> tuple[Any, ...]:
        region = self.region
        columns = None if region is None else Kept.of(region)
        return _unpickled_answer, (self._problem_text, self._result_text(), columns)


def instant(problem: Any, point: Sequence[float] | None = None) -> Record:
    """What a motion that is prescribed at one instant tells, of a problem of one pose with three derivatives at least.

    Args:
        problem: as of :func:`linkwright.solve`.
        point: of the body, fixed frame, (x, y).
    """
    from .tasks import native

    pair = None if point is None else (float(point[0]), float(point[1]))
    text, svg = _linkwright.instant_of_problem(native(problem).text(), pair)
    return record_of(json.loads(text)["instant"], lambda: svg or None)


def _unpickled_answer(problem: str, result: str, columns: Kept | None) -> Answer:
    return Answer(problem, result, columns, None)
