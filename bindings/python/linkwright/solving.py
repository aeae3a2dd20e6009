"""solve(): from a problem to its answer, with a word on how far it is."""

from __future__ import annotations

import sys
import time
from typing import Any, Callable, Iterable, Mapping, Sequence, Union

from . import _linkwright
from .answers import Answer
from .linkages import Linkage
from .tasks import MotionTask, PathPoint, PathTask, Pose, Problem, ProblemLike, native

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


def _start_of_path(start: Any) -> dict[str, Any]:
    return {"point": start["point"]}


def _start_of_poses(start: Any) -> dict[str, Any]:
    """Where its body is: as a start has it, or as an answer has the first of the configurations."""
    properties = start.properties if isinstance(start, Linkage) else start
    if "pose" in properties:
        return {"pose": properties["pose"]}
    if "near" not in properties:
        return {}
    first = properties["near"]["at"][0]
    x, y = first["place"]
    return {"pose": {"x": x, "y": y, "theta_deg": first["theta_deg"]}}


def _fit(effort: str, measure: str, starts: Iterable[Any], more_of: Callable[[Any], dict[str, Any]]) -> dict[str, Any]:
    """`options.fit`; `more_of`: what a start has beside its links."""
    ends = ("center_point", "circle_point")
    given = [{side: {end: start[side][end] for end in ends} for side in ("input", "output")} | more_of(start) for start in starts]
    return {"effort": effort, "measure": measure, **({"starts": given} if given else {})}


def fit_path(
    points: Any,
    *,
    closed: bool = False,
    tolerance: float | None = None,
    between: str | None = None,
    input_deg: Any = None,
    timing: str | None = None,
    ground_pivots: Mapping[str, Sequence[float]] | None = None,
    map: str | None = None,
    weights: Any = None,
    requirements: Mapping[str, Any] | None = None,
    effort: str = "standard",
    measure: str = "least_squares",
    starts: Iterable[Union[Linkage, Mapping[str, Any]]] = (),
    best: int = 10,
    length_unit: str = "",
    progress: Union[bool, Report, None] = None,
    cancellation: Cancellation | None = None,
) -> Answer:
    """The four-bars whose coupler point passes nearest to a drawn or measured curve.

        >>> import linkwright as lw
        >>> bean = [(90, 18), (83, 31), (64, 34), (34, 32), (0, 30), (-34, 32), (-64, 34), (-83, 31),
        ...         (-90, 18), (-83, -6), (-64, -34), (-34, -57), (0, -66), (34, -57), (64, -34), (83, -6)]
        >>> found = lw.fit_path(bean, closed=True).linkages[0]
        >>> found.type, found["fit"]["error"]["rms_over_diagonal"] < 0.005
        ('crank_rocker', True)

    Args:
        points: n × 2, in the order in which they are passed, 3 to 1000; user's unit.
        input_deg: the crank's angle at each point, degrees, rising or falling within a turn; the distances then are those at
            these angles. None: whatever the timing.
        closed, tolerance, between, timing, ground_pivots, map: as :class:`PathTask` has them.
        weights: one to each point, of the squared distances.
        requirements: as in problem files.
        effort: ``"quick"``, ``"standard"`` or ``"deep"``: how many places and starts are tried.
        measure: ``"least_squares"``, or ``"least_largest"``: the largest distance is least.
        starts: linkages to begin with beside those that are found: of an answer, or mappings as `options.fit.starts` of
            problem files, each as it lies at the first point.
        best: how many linkages are listed.
        length_unit, progress, cancellation: as :func:`solve` and :class:`Problem` have them.

    Returns:
        The answer, as :func:`solve` gives it. Its linkages are evidence, not proof: others may come nearer.

    Raises:
        ProblemError: fewer than three different points, numbers that are not finite, a tolerance of 0, ….
    """
    places = [(float(x), float(y)) for x, y in points]

    def to_each(values: Any, what: str) -> Sequence[float | None]:
        given: list[float | None] = [None] * len(places) if values is None else [float(value) for value in values]
        if len(given) != len(places):
            raise ValueError(f"{len(given)} {what} are given for {len(places)} points")
        return given

    given = zip(places, to_each(input_deg, "angles"), to_each(weights, "weights"))
    path = [PathPoint(x, y, input_deg=angle, weight=weight) for (x, y), angle, weight in given]
    if between is None and timing is None:
        between, timing = ("free", None) if input_deg is None else (None, "relative")
    task = PathTask(path, ground_pivots, closed, tolerance, between, timing, map)
    options = {"fit": _fit(effort, measure, starts, _start_of_path), "best": best}
    problem = Problem(task, requirements=requirements, options=options, length_unit=length_unit)
    return solve(problem, progress=progress, cancellation=cancellation)


def fit_poses(
    poses: Any,
    *,
    exact: Sequence[int] = (),
    weights: Any = None,
    tolerance: Mapping[str, float] | None = None,
    turning_length: float | None = None,
    requirements: Mapping[str, Any] | None = None,
    effort: str = "standard",
    measure: str = "least_squares",
    starts: Iterable[Union[Linkage, Mapping[str, Any]]] = (),
    best: int = 10,
    length_unit: str = "",
    progress: Union[bool, Report, None] = None,
    cancellation: Cancellation | None = None,
) -> Answer:
    """The four-bars that carry a body past many poses as near as they can.

        >>> import linkwright as lw
        >>> gate = [(0, 0, 0), (-60, 25, -11), (-125, 75, -25), (-178, 145, -39), (-220, 220, -52), (-240, 300, -63),
        ...         (-240, 380, -73), (-220, 450, -82)]
        >>> found = lw.fit_poses(gate, turning_length=177.38).linkages[0]
        >>> found["near"]["error"]["rms"] < 1.06
        True

    Args:
        poses: n × 3, x, y and theta in degrees, in the order in which they are passed, 3 to 1000; user's unit.
        exact: which of them, from 0, are passed exactly; with four or five the answer is that of their solution region,
            ranked by the error at the others.
        weights: one to each pose, of the squared errors.
        tolerance, turning_length: as :class:`Pose` and :class:`MotionTask` have them.
        requirements: as in problem files.
        effort: ``"quick"``, ``"standard"`` or ``"deep"``: how many starts are tried; not with four or five exact poses.
        measure: ``"least_squares"``, or ``"least_largest"``: the largest error is least; likewise.
        starts: linkages to begin with, as :func:`fit_path` has them, without points; likewise.
        best: how many linkages are listed.
        length_unit, progress, cancellation: as :func:`solve` and :class:`Problem` have them.

    Returns:
        The answer, as :func:`solve` gives it. Fitted linkages are evidence, not proof: others may come nearer.

    Raises:
        ProblemError: fewer than three different poses, more than five exact ones, numbers that are not finite, ….
    """
    rows = [(float(x), float(y), float(theta)) for x, y, theta in poses]
    given: Sequence[float | None] = [None] * len(rows) if weights is None else [float(weight) for weight in weights]
    if len(given) != len(rows):
        raise ValueError(f"{len(given)} weights are given for {len(rows)} poses")
    passed = [
        Pose(*row) if j in exact else Pose(*row, near=True, tolerance=tolerance, weight=weight)
        for j, (row, weight) in enumerate(zip(rows, given))
    ]
    task = MotionTask(passed, turning_length=turning_length)
    options: dict[str, Any] = {"best": best}
    if len(exact) < 4:
        options["fit"] = _fit(effort, measure, starts, _start_of_poses)
    problem = Problem(task, requirements=requirements, options=options, length_unit=length_unit)
    return solve(problem, progress=progress, cancellation=cancellation)


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
