"""Records: dicts as the library's JSON has them, whose lists of numbers are arrays."""

from __future__ import annotations

from typing import Any, Callable, Iterator

import numpy as np


class Record(dict[str, Any]):
    """A dict whose members may also be read as attributes; lists of numbers in it are read-only numpy arrays,
    in which null is NaN.

    Its keys are those of the files that the program writes, described in ``schema/``.
    """

    _svg: Callable[[], str | None] | None = None

    def __getattr__(self, name: str) -> Any:
        try:
            return self[name]
        except KeyError:
            raise AttributeError(f"there is no {name!r} here, but: {', '.join(self)}") from None

    def __dir__(self) -> Iterator[str]:
        return iter([*super().__dir__(), *self])

    def _repr_svg_(self) -> str | None:
        """The library's picture of it, where it has one."""
        return self._svg() if self._svg else None

    def __reduce__(self) -> tuple[Any, ...]:
        return Record, (dict(self),)


def record_of(value: dict[str, Any], svg: Callable[[], str | None] | None = None) -> Record:
    """`value` with arrays for lists of numbers."""
    record = Record({key: _with_arrays(member) for key, member in value.items()})
    record._svg = svg
    return record


def read_only(array: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    array.setflags(write=False)
    return array


def _with_arrays(value: Any) -> Any:
    if isinstance(value, dict):
        return record_of(value)
    if isinstance(value, list):
        return read_only(np.array(value, dtype=float)) if _is_numeric(value) else [_with_arrays(each) for each in value]
    return value


def _is_numeric(value: list[Any]) -> bool:
    """Numbers, or lists of numbers of one length; among them None, which becomes NaN. An empty list stays a list."""
    kinds = {type(each) for each in value}
    if kinds == {list}:
        rows = [each for each in value if each]
        return len({len(each) for each in value}) == 1 and bool(rows) and all(map(_is_flat, rows))
    return _is_flat(value)


def _is_flat(value: list[Any]) -> bool:
    kinds = {type(each) for each in value}
    return kinds <= {int, float, type(None)} and kinds != {type(None)} and bool(kinds)
