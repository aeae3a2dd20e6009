"""The solution region and its columns."""

from __future__ import annotations

from typing import Any, Iterator, Mapping, Sequence

import numpy as np
import numpy.typing as npt

from . import _linkwright
from .records import Record, read_only

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
        """A bit for each of :attr:`requirements` that a cell fails, from the lowest on; uint32, (rows, columns)."""
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


class Views(Mapping[str, Array]):
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


class Kept(dict[str, Array]):
    """Columns that came out of a pickle."""

    measures: list[str]
    requirements: list[str]

    @staticmethod
    def of(region: Region) -> Kept:
        return kept_columns({name: np.array(column) for name, column in region._columns.items()}, region.measures, region.requirements)

    def __reduce__(self) -> tuple[Any, ...]:
        return kept_columns, (dict(self), self.measures, self.requirements)


def kept_columns(columns: dict[str, Array], measures: list[str], requirements: list[str]) -> Kept:
    kept = Kept({name: read_only(column) for name, column in columns.items()})
    kept.measures, kept.requirements = measures, requirements
    return kept


_columns = ("input", "output", "types", "defects", "failures")
