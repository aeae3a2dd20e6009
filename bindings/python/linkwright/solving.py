"""solve(): from a problem to its answer, with a word on how far it is."""

from __future__ import annotations

import sys
import time
from typing import Any, Callable, Union

from . import _linkwright
from .answers import Answer
from .tasks import ProblemLike, native

Cancellation = _linkwright.Cancellation
Report = Callable[[float], Any]


def solve(
    problem: ProblemLike,
    *,
    samples: int | None = None,
    progress: Union[bool, Report, None] = None,
    cancellation: Cancellation | None = None,
) -> Answer:
    """All linkages that do a task, and the best of them by what is required.

    Other Python threads run on meanwhile. Ctrl-C stops it (KeyboardInterrupt) within about a tenth of a second.

    Args:
        problem: a :class:`Problem`, a task class or its dict alone, the dict of a problem file, its JSON text, or the
            path of a file.
        samples: N of the N × N map, before what the problem says.
        progress: True or None shows how far it is where that is seen, on a terminal or in a notebook, once it has
            taken a third of a second; False never. Or a function that is called with the share done, in [0, 1].
        cancellation: stops it when its ``cancel()`` is called, by any thread. A search for six-bars or straight lines
            then answers with the best so far; everything else raises :class:`Cancelled`.

    Returns:
        The answer. "No linkage does this" is one too: see its ``status`` and ``reason``.

    Raises:
        ProblemError: the problem has mistakes; all of them, with their places.
        Cancelled: it was cancelled.
    """
    read = native(problem)
    if samples is not None:
        read.set_samples(samples)
    report, close = _reporter(progress)
    try:
        solved = _linkwright.solve(read, report, cancellation or Cancellation())
    finally:
        close()
    return Answer._of(solved, read.text())


def read_problem(problem: ProblemLike) -> dict[str, Any]:
    """The normal form of a problem: a dict with every default that does not depend on the task.

    Raises:
        ProblemError: the problem has mistakes; all of them, with their places.
    """
    import json

    found: dict[str, Any] = json.loads(native(problem).text())
    return found


def _reporter(progress: Union[bool, Report, None]) -> tuple[Report | None, Callable[[], None]]:
    if callable(progress):
        return progress, lambda: None
    shown = None if progress is False else _in_notebook() or _on_terminal()
    return (shown.show, shown.close) if shown else (None, lambda: None)


class _Shown:
    """Said only once it has taken a while, and only when the percentage is another."""

    patience = 0.3

    def __init__(self, say: Callable[[str], None], clear: Callable[[], None]) -> None:
        self._say, self._clear = say, clear
        self._begun, self._percent = time.monotonic(), -1

    def show(self, done: float) -> None:
        percent = int(100 * done)
        if time.monotonic() - self._begun > self.patience and percent != self._percent:
            self._percent = percent
            self._say(f"solving … {percent} %")

    def close(self) -> None:
        if self._percent >= 0:
            self._clear()


def _on_terminal() -> _Shown | None:
    stream = sys.stderr
    if stream is None or not stream.isatty():
        return None

    def put(text: str) -> None:
        stream.write(f"\r{text}\033[K")
        stream.flush()

    return _Shown(put, lambda: put(""))


def _in_notebook() -> _Shown | None:
    if "IPython" not in sys.modules:
        return None
    from IPython import get_ipython
    from IPython.display import display

    shell = get_ipython()
    if shell is None or not hasattr(shell, "kernel"):
        return None
    handle: list[Any] = []

    def put(text: str) -> None:
        bundle = {"text/plain": text}
        if handle:
            handle[0].update(bundle, raw=True)
        else:
            handle.append(display(bundle, raw=True, display_id=True))

    return _Shown(put, lambda: put(""))
