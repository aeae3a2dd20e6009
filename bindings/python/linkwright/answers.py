"""Answers and the linkages in them."""

from __future__ import annotations

import json
import os
import warnings
from typing import Any, Iterator, Mapping, Sequence

import numpy as np
import numpy.typing as npt

from . import _linkwright
from .errors import ProblemError
from .records import Record, read_only, record_of
from .tasks import is_json, to_json

Array = npt.NDArray[Any]


class Region:
    """The solution region: all linkages of a task over two coordinates, sampled and judged.

    Columns are read-only arrays (rows, columns) = [input, output]. Straight from :func:`solve` they are views of the
    answer's own memory, which lives as long as any of them.
    """

    def __init__(self, columns: Mapping[str, Array], about: Record, requirements: Sequence[str], keys: Sequence[str]):
        self._columns, self._requirements, self._keys = columns, list(requirements), list(keys)
        self.about = about
        """What the result file says of it: ``axes``, ``counts``, ``meeting_requirements``, …"""

    @property
    def input(self) -> Array:
        """Coordinates of the rows, those of the input link; float64, (rows,)."""
        return self._columns["input"]

    @property
    def output(self) -> Array:
        """Coordinates of the columns, those of the output link; float64, (columns,)."""
        return self._columns["output"]

    @property
    def types(self) -> Array:
        """Linkage types as codes, places in :data:`linkwright.linkage_types`; uint8, (rows, columns)."""
        return self._columns["types"]

    @property
    def defects(self) -> Array:
        """Bits 1 order, 2 branch, 4 circuit; uint8, (rows, columns)."""
        return self._columns["defects"]

    @property
    def failures(self) -> Array:
        """A bit for each of :attr:`requirements` that a cell fails, from the lowest on; uint16, (rows, columns)."""
        return self._columns["failures"]

    @property
    def meets(self) -> Array:
        """Cells that meet all requirements; bool, (rows, columns)."""
        return np.asarray(self.failures == 0)

    @property
    def requirements(self) -> list[str]:
        """What can be required of such linkages, in the order of the bits of :attr:`failures`."""
        return list(self._requirements)

    @property
    def measures(self) -> list[str]:
        """Names of the measures, which ``region[name]`` gives."""
        return list(self._keys)

    @property
    def counts(self) -> Record:
        """Linkages by type and by defect, as in the result file."""
        counts: Record = self.about["counts"]
        return counts

    @property
    def shape(self) -> tuple[int, int]:
        """(rows, columns)."""
        rows, columns = self.types.shape
        return rows, columns

    def __getitem__(self, measure: str) -> Array:
        """A measure of each cell: float32, (rows, columns), angles in degrees, 0 where it is not defined."""
        if measure not in self._keys:
            raise KeyError(f"{measure}: this map has {', '.join(self._keys)}")
        return self._columns[measure]

    def __len__(self) -> int:
        return int(self.types.size)

    def __repr__(self) -> str:
        rows, columns = self.shape
        return f"<Region {rows} × {columns}, {int(np.count_nonzero(self.meets))} meet the requirements>"

    def to_dataframe(self, *, meeting_only: bool = False) -> Any:
        """The region as a pandas DataFrame, one row a cell: coordinates, type, defects, whether it meets the
        requirements, and every measure (angles in degrees; NaN where the map has 0 for not defined).

        Args:
            meeting_only: cells that meet all requirements, and no others.

        Raises:
            ImportError: pandas is not there.
        """
        try:
            import pandas
        except ImportError as error:
            raise ImportError("to_dataframe() needs pandas: on Debian `apt install python3-pandas`") from error
        chosen = self.meets if meeting_only else np.ones(self.shape, dtype=bool)
        rows, columns = np.nonzero(chosen)
        codes = self.types[chosen]
        table: dict[str, Any] = {"input": self.input[rows], "output": self.output[columns]}
        table["type"] = pandas.Categorical.from_codes(codes.astype(np.int8), list(_linkwright.linkage_types))
        for bit, name in ((1, "order_defect"), (2, "branch_defect"), (4, "circuit_defect")):
            table[name] = (self.defects[chosen] & bit) != 0
        table["meets"] = self.meets[chosen]
        for name in self._keys:
            values = self[name][chosen]
            table[name] = np.where(values == 0, np.float32("nan"), values)
        return pandas.DataFrame(table)

    def plot(self, ax: Any = None, **options: Any) -> Any:
        """Draws it: see :func:`linkwright.plot.region`. Returns matplotlib's axes."""
        from . import plot

        return plot.region(self, ax, **options)


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
            return _linkage_of(_linkwright.Linkage(text), 0)
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
            _write(path, self.build(format, **wishes))
        else:
            _write(path, self.export(format, **wishes))

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
            self._linkages = [_linkage_of(native, number) for number, native in enumerate(found, 1)]
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
            columns = self._columns_of if self._columns_of is not None else _Views(self._native())
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
        _write(path, self.export(format, with_region=with_region))

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
        columns = None if region is None else _Kept.of(region)
        return _unpickled_answer, (self._problem_text, self._result_text(), columns)


class _Views(Mapping[str, Array]):
    """The columns of a solved task, made when they are asked for."""

    def __init__(self, solved: _linkwright.Solved) -> None:
        self._solved = solved
        self.measures, self.requirements = solved.measures(), solved.requirements()

    def __getitem__(self, name: str) -> Array:
        made: Array = getattr(self._solved, name)() if name in _columns else self._solved.values(name)
        return made

    def __iter__(self) -> Iterator[str]:
        return iter([*_columns, *self.measures])

    def __len__(self) -> int:
        return len(_columns) + len(self.measures)


class _Kept(dict[str, Array]):
    """Columns that came out of a pickle."""

    measures: list[str]
    requirements: list[str]

    @staticmethod
    def of(region: Region) -> _Kept:
        return _kept({name: np.array(column) for name, column in region._columns.items()}, region.measures, region.requirements)

    def __reduce__(self) -> tuple[Any, ...]:
        return _kept, (dict(self), self.measures, self.requirements)


def _kept(columns: dict[str, Array], measures: list[str], requirements: list[str]) -> _Kept:
    kept = _Kept({name: read_only(column) for name, column in columns.items()})
    kept.measures, kept.requirements = measures, requirements
    return kept


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


def _linkage_of(native: _linkwright.Linkage, number: int) -> Linkage:
    made = Linkage(native, number)
    kind = made.properties.get("mechanism")
    made.__class__ = {"six_bar": SixBar, "spherical_four_bar": SphericalFourBar}.get(kind or "", FourBar)
    return made


def _unpickled_linkage(text: str, number: int) -> Linkage:
    return _linkage_of(_linkwright.Linkage(text), number)


def _unpickled_answer(problem: str, result: str, columns: _Kept | None) -> Answer:
    return Answer(problem, result, columns, None)


def _file_text(path: str) -> str:
    try:
        return _linkwright.read_result_file(os.fsencode(path)).decode("utf-8")
    except ProblemError as error:
        raise ProblemError(error.mistakes, path) from None


def _write(path: str | "os.PathLike[str]", text: str | bytes) -> None:
    failure = _linkwright.write_file(os.fspath(path), text)
    if failure:
        raise OSError(f"{os.fspath(path)}: {failure}")


def _plain_number(value: Any) -> Any:
    return value.tolist() if isinstance(value, (np.ndarray, np.generic)) else to_json(value)


_columns = ("input", "output", "types", "defects", "failures")
_formats = ("svg", "dxf", "csv", "json")
_machine_formats = tuple(_linkwright.machine_formats())
_sizes = ("width", "thickness", "gap", "pin", "clearance", "radius", "density")
