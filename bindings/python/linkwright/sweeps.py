"""Sweeps: a problem for many values of its numbers, as columns."""

from __future__ import annotations

import json
import os
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, Iterator, Mapping, Union

import numpy as np
import numpy.typing as npt

from . import _linkwright

Array = npt.NDArray[Any]
Columns = dict[str, Array]
SweepLike = Union[str, bytes, "os.PathLike[str]", Mapping[str, Any]]
TABLES = ("samples", "linkages", "failures")


class SweepPlan:
    """A sweep file, read and checked: the problem of any sample at once.

    Args:
        source: the path of a sweep file, its JSON text, or its dict.
        folder: from which its problem's file is named; by default that of the path, or the current one.

    Raises:
        ProblemError: the file has mistakes; all of them, with their places.
    """

    def __init__(self, source: SweepLike, folder: str | os.PathLike[str] | None = None) -> None:
        if isinstance(source, Mapping):
            text: str | bytes = json.dumps(source)
        elif isinstance(source, bytes) or (isinstance(source, str) and "{" in source):
            text = source
        else:
            text = Path(source).read_bytes()
            folder = Path(source).parent if folder is None else folder
        self._plan = _linkwright.SweepPlan(text, os.fspath(folder or ""))

    def __len__(self) -> int:
        return self._plan.samples

    @property
    def title(self) -> str:
        """What the file calls it."""
        return self._plan.title

    @property
    def variables(self) -> tuple[str, ...]:
        """Names of what varies: columns of the samples."""
        return self._plan.variables

    def values(self, sample: int) -> list[float]:
        """What varies, for a sample from 0, in the order of :attr:`variables`."""
        return self._plan.values(sample)

    def problem(self, sample: int) -> dict[str, Any]:
        """The problem of a sample from 0, as the dict of a problem file; :func:`solve` takes it."""
        found: dict[str, Any] = json.loads(self._plan.problem(sample))
        return found


class Sweep:
    """The table of a sweep: columns of samples, of linkages, and of the reasons why samples have none.

    Columns are arrays by the names that they have in the file: float64 (NaN where there is nothing), int64, uint8 for
    flags (255 where there is nothing) and texts. ``units`` has a unit to each, by ``"linkages/lengths.ground"``.
    """

    def __init__(self, tables: Mapping[str, Columns], units: Mapping[str, str], about: Mapping[str, Any]) -> None:
        self.samples, self.linkages, self.failures = (dict(tables[name]) for name in TABLES)
        self.units = dict(units)
        self.about = dict(about)
        """``title``, ``version``, and as dicts ``problem``, the base problem, and ``sweep``, the rest of the file."""

    def __len__(self) -> int:
        return len(self.samples["sample"])

    def frame(self, table: str = "samples") -> Any:
        """A table as a pandas data frame: ``"samples"``, ``"linkages"`` or ``"failures"``."""
        import pandas

        if table not in TABLES:
            raise KeyError(f"there is no table {table!r}; take one of {', '.join(TABLES)}")
        return pandas.DataFrame(getattr(self, table))

    def joined(self) -> Any:
        """A pandas data frame with a row to a linkage: its columns, and those of its sample."""
        return self.frame("linkages").merge(self.frame("samples"), on="sample", suffixes=("", "_of_sample"))


def sweep(source: SweepLike | SweepPlan, *, threads: int = 0) -> Sweep:
    """Solves all samples of a sweep and keeps what it says, in memory.

    For sweeps of hours take the program: ``linkwright sweep SWEEP.json -o OUT.h5`` keeps what is done and goes on where
    it was stopped; :func:`load_sweep` reads its table, which has the same numbers.

    Args:
        source: a :class:`SweepPlan`, or what makes one.
        threads: 0: as many as the machine has.

    Raises:
        ProblemError: the file has mistakes. A sample whose values make no problem is a row with status ``invalid``.
    """
    plan = (source if isinstance(source, SweepPlan) else SweepPlan(source))._plan
    tables: dict[str, dict[str, list[Array]]] = {}
    for rows in _blocks(plan, threads or os.cpu_count() or 1):
        for table, columns in rows.items():
            for name, column in columns.items():
                tables.setdefault(table, {}).setdefault(name, []).append(column)
    units = {f"{table}/{name}": unit for table, columns in plan.columns().items() for name, (unit, _) in columns.items()}
    whole = {table: {name: _readable(np.concatenate(pieces)) for name, pieces in columns.items()}
             for table, columns in tables.items()}
    about = {"title": plan.title, "version": _linkwright.version, "problem": json.loads(plan.problem_text),
             "sweep": json.loads(plan.sweep_text)}
    return Sweep(whole, units, about)


def load_sweep(path: str | os.PathLike[str]) -> Sweep:
    """The table that ``linkwright sweep`` wrote.

    Raises:
        ImportError: h5py is not installed.
        ValueError: the file is no table of a sweep.
    """
    try:
        import h5py
    except ImportError:
        raise ImportError("tables of sweeps are HDF5 files; to read them install h5py (Debian: python3-h5py)") from None
    with h5py.File(path, "r") as file:
        if "linkwright_sweep" not in file.attrs:
            raise ValueError(f"{os.fspath(path)} is no table of a sweep")
        tables = {table: {name: _readable(data[:]) for name, data in file[table].items()} for table in TABLES}
        units = {f"{table}/{name}": str(data.attrs["unit"]) for table in TABLES for name, data in file[table].items()}
        about = {name: str(file.attrs[name]) for name in ("title", "version")}
        about |= {name: json.loads(file.attrs[name]) for name in ("problem", "sweep")}
    return Sweep(tables, units, about)


def _readable(column: Array) -> Array:
    return np.char.decode(column, "utf-8") if column.dtype.kind == "S" else column


def _blocks(plan: _linkwright.SweepPlan, threads: int) -> Iterator[dict[str, Columns]]:
    """Rows block by block, in order; few blocks are under way at a time."""
    cancellation = _linkwright.Cancellation()
    starts = range(0, plan.samples, plan.block_samples)
    with ThreadPoolExecutor(threads) as pool:
        try:
            yield from pool.map(
                lambda first: plan.rows(first, min(first + plan.block_samples, plan.samples), cancellation), starts)
        except BaseException:
            cancellation.cancel()
            pool.shutdown(cancel_futures=True)
            raise
