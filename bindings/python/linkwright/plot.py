"""Pictures by matplotlib, in the look of the library's own: colour is the linkage's type, hatched is a defect, pale works
but does not meet a requirement.

Everything drawn is read from the answer; nothing is computed here.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Sequence

import numpy as np
import numpy.typing as npt

from . import _linkwright

if TYPE_CHECKING:
    from .answers import Answer
    from .linkages import Linkage
    from .region import Region

Array = npt.NDArray[Any]
colors = _linkwright.colors
"""Colours of the pictures by name, ``#RRGGBB``."""
type_colors = dict(zip(_linkwright.linkage_types, _linkwright.type_colors))
"""Colours of the linkage types."""


def answer(answer: Answer, *, figsize: tuple[float, float] = (12, 5.5), measure: str | None = None) -> Any:
    """Poses or points, curves and the best linkage beside the solution region. Returns the figure."""
    from matplotlib import pyplot

    figure = pyplot.figure(figsize=figsize, layout="constrained")
    found, map_ = answer.linkages, answer.region
    solid = answer.problem["task"]["mechanism"] == "spherical_four_bar"
    places = 1 + (map_ is not None)
    left = figure.add_subplot(1, places, 1, projection="3d" if solid else None)
    if not solid:
        curves(answer, left)
    if found:
        found[0].plot(left)
        if not solid and not answer.problem["task"].get("poses"):
            _look_around(left, found[0])
    if map_ is not None:
        right = figure.add_subplot(1, places, 2)
        region(map_, right, measure=measure)
        _mark(right, map_, found)
    if answer.problem.get("title"):
        figure.suptitle(answer.problem["title"], color=colors["ink"])
    return figure


def region(
    region: Region,
    ax: Any = None,
    *,
    measure: str | None = None,
    contours: str | Sequence[Any] | None = None,
    layer: int = 0,
    legend: bool = True,
) -> Any:
    """The solution region.

    Args:
        ax: matplotlib's axes; None makes new ones.
        measure: colours the linkages without defect by it, instead of by their types.
        contours: a measure whose contour lines are drawn over the linkages without defect, or (measure, levels).
        layer: of straight lines: which of the linkages at a place.
        legend: says what the colours mean.

    Returns:
        The axes.
    """
    from matplotlib import pyplot

    ax = pyplot.subplots(layout="constrained")[1] if ax is None else ax
    rows = _rows_of_layer(region, layer)
    sound = (region.defects[rows] == 0) & (region.types[rows] != _linkwright.linkage_types.index("degenerate"))
    meets = region.meets[rows]
    extent = _extent(region.input[rows], region.output)
    picture = _painted(region.types[rows], region.defects[rows], sound, meets)
    ax.imshow(picture, origin="lower", extent=extent, aspect="auto", interpolation="nearest")
    if measure is not None:
        values = np.where(sound, region[measure][rows], np.nan)
        shade = np.where(meets, 1.0, 0.3)
        shown = ax.imshow(values, origin="lower", extent=extent, aspect="auto", interpolation="nearest", alpha=shade)
        ax.figure.colorbar(shown, ax=ax, label=_words(measure))
    elif legend:
        _legend(ax, region.types[rows][sound])
    if contours is not None:
        name, levels = (contours, 6) if isinstance(contours, str) else (contours[0], contours[1])
        values = np.where(sound, region[name][rows], np.nan)
        x, y = np.linspace(*extent[:2], values.shape[1]), np.linspace(*extent[2:], values.shape[0])
        lines = ax.contour(x, y, values, levels=levels, colors=colors["ink"], linewidths=0.7)
        ax.clabel(lines, fontsize=7)
    axes = region.about["axes"]
    ax.set_ylabel(axes[0]["name"])
    ax.set_xlabel(axes[1]["name"])
    return ax


def curves(answer: Answer, ax: Any = None) -> Any:
    """The curves of fixed pivots (solid) and moving pivots in position 1 (dashed), or the few dyads of five positions,
    and the poses or points of the task. Returns the axes."""
    ax = _plane(ax)
    curve = answer.curve
    samples = curve["samples"] if curve else {}
    for key, style, name in (("center", "-", "fixed pivots"), ("circle", "--", "moving pivots")):
        if f"{key}_homogeneous" in samples:
            x, y = _paths(samples[f"{key}_homogeneous"], samples["coordinate"])
            ax.plot(x, y, style, color=colors["curve"], linewidth=1, label=name, zorder=1)
    for dyad in answer.dyads:
        if dyad.get("center_point") is not None and dyad.get("circle_point") is not None:
            link = np.array([dyad["center_point"], dyad["circle_point"]])
            ax.plot(*link.T, "o-", color=colors["curve"], linewidth=0.8, markersize=3, zorder=1)
    poses = answer.problem["task"].get("poses") or []
    for number, pose in enumerate(poses, 1):
        _frame(ax, pose["x"], pose["y"], pose["theta_deg"], 0.08 * answer.characteristic_length, str(number))
    for number, point in enumerate(answer.problem["task"].get("points") or [], 1):
        ax.plot(point["x"], point["y"], "o", color=colors["accent"], markersize=4, zorder=5)
        ax.annotate(
            str(number), (point["x"], point["y"]), textcoords="offset points", xytext=(5, 4), fontsize=8, color=colors["ink2"]
        )
    if poses:
        _look_at(ax, np.array([[pose["x"], pose["y"]] for pose in poses]), answer.characteristic_length)
    return ax


def linkage(linkage: Linkage, ax: Any = None, *, path: bool = True) -> Any:
    """A linkage in its positions, position 1 in full colour, and the path of its body.

    Args:
        ax: matplotlib's axes, of spherical linkages 3-D ones; None makes new ones.
        path: draws the path of the moving frame's origin (of a straight line that of its point).

    Returns:
        The axes.
    """
    from .linkages import SixBar, SphericalFourBar

    motion = linkage.motion()
    positions = motion[motion["position"] > 0]
    positions = positions[np.argsort(positions["position"], kind="stable")]
    shown = positions if len(positions) else motion[:1]
    if isinstance(linkage, SphericalFourBar):
        return _sphere(linkage, shown, motion, ax)
    ax = _plane(ax)
    draw = _six_bar if isinstance(linkage, SixBar) else _four_bar
    for number, state in reversed(list(enumerate(shown))):
        draw(ax, linkage, state, 1.0 if number == 0 else 0.28)
    if path:
        traced = "point" if "point_x" in (motion.dtype.names or ()) else "body"
        ax.plot(motion[f"{traced}_x"], motion[f"{traced}_y"], color=colors["accent"], linewidth=0.9, zorder=2)
    if linkage.length_unit:
        ax.set_xlabel(linkage.length_unit)
    return ax


def _painted(types: Array, defects: Array, sound: Array, meets: Array) -> Array:
    palette = np.array([_rgb(color) for color in _linkwright.type_colors])
    full = palette[np.minimum(types, len(palette) - 1)]
    picture = np.where(meets[..., None], full, 1 + (full - 1) * 0.34)
    rows, columns = np.indices(types.shape)
    step = max(6, types.shape[0] // 50)
    stripe = ((rows + columns) % step < max(1, step // 4))[..., None]
    hatched = np.where(stripe, _rgb(colors["hatch"]), _rgb(colors["defect"]))
    picture = np.where(sound[..., None], picture, hatched)
    return np.where(((defects == 0) & ~sound)[..., None], 1.0, picture)


def _legend(ax: Any, codes: Array) -> None:
    from matplotlib.patches import Patch

    counts = np.bincount(codes, minlength=len(_linkwright.linkage_types))
    handles = [
        Patch(color=_linkwright.type_colors[code], label=_linkwright.type_labels[code])
        for code in np.argsort(-counts, kind="stable")
        if counts[code]
    ]
    handles.append(Patch(facecolor=colors["defect"], edgecolor=colors["hatch"], hatch="////", label="Defect"))
    ax.legend(handles=handles, fontsize=7, loc="upper right", framealpha=0.9)


def _mark(ax: Any, region: Region, linkages: Sequence[Linkage]) -> None:
    """Where the linkages listed stand, those whose place is that of both dyads."""
    ends = [axis["branches"][-1]["to"] for axis in reversed(region.about["axes"])]
    for number, linkage in enumerate(linkages, 1):
        sides = [linkage.properties.get(side) for side in ("output", "input")]
        if any(side is None or "coordinate" not in side for side in sides):
            return
        # Coordinates beyond the end of an axis are of a layer of it.
        x, y = (at if at <= end else at % 1 for at, end in zip((side["coordinate"] for side in sides if side), ends))
        ax.plot(x, y, "o", color=colors["ink"], markerfacecolor="white", markersize=5)
        if number == 1:
            ax.annotate("1", (x, y), textcoords="offset points", xytext=(5, 5), fontsize=8)


def _four_bar(ax: Any, linkage: Any, state: Any, alpha: float) -> None:
    pivots = linkage.pivots
    grounds = pivots["input_fixed"], pivots["output_fixed"]
    ends = [np.array([state[f"{side}_circle_x"], state[f"{side}_circle_y"]]) for side in ("input", "output")]
    for ground, end, side in zip(grounds, ends, ("input", "output")):
        _bar(ax, ground, end, colors[side], alpha)
    corners = [*ends, np.array([state["body_x"], state["body_y"]])]
    if "point_x" in state.dtype.names:
        corners[-1] = np.array([state["point_x"], state["point_y"]])
    ax.fill(*np.transpose(corners), facecolor=colors["body"], alpha=0.12 * alpha, zorder=2)
    _bar(ax, ends[0], ends[1], colors["body"], alpha)
    ax.plot(*np.transpose(grounds), "^", color=colors["ink"], markersize=7, zorder=4)


def _six_bar(ax: Any, linkage: Any, state: Any, alpha: float) -> None:
    tones = {"0": "ink", "1": "input", "2": "link_2", "3": "body", "4": "output", "5": "link_5"}
    for name in linkage.properties["lengths"]:
        body, ends = name.split(":")
        first, second = ([state[f"{joint}_x"], state[f"{joint}_y"]] for joint in ends.split("-"))
        if body == "0":
            ax.plot(*np.transpose([first, second]), "^", color=colors["ink"], markersize=7, zorder=4)
        else:
            _bar(ax, first, second, colors[tones[body]], alpha)


def _sphere(linkage: Any, shown: Any, motion: Any, ax: Any) -> Any:
    from matplotlib import pyplot

    ax = pyplot.figure().add_subplot(projection="3d") if ax is None else ax
    u, v = np.mgrid[0 : 2 * np.pi : 25j, 0 : np.pi : 13j]  # type: ignore[misc]
    ball = np.cos(u) * np.sin(v), np.sin(u) * np.sin(v), np.cos(v)
    ax.plot_wireframe(*ball, color=colors["line"], linewidth=0.4)
    axes = linkage.axes
    for number, state in reversed(list(enumerate(shown))):
        alpha = 1.0 if number == 0 else 0.3
        ends = {side: np.array([state[f"{side}_moving_{axis}"] for axis in "xyz"]) for side in ("input", "output")}
        for side, end in ends.items():
            ax.plot(*_arc(axes[f"{side}_fixed"], end), color=colors[side], alpha=alpha, linewidth=2.2)
        ax.plot(*_arc(ends["input"], ends["output"]), color=colors["body"], alpha=alpha, linewidth=2.2)
    for side in ("input", "output"):
        ax.plot(*axes[f"{side}_fixed"], "^", color=colors["ink"])
        ax.plot(*(motion[f"{side}_moving_{axis}"] for axis in "xyz"), color=colors["accent"], linewidth=0.6)
    ax.set_box_aspect((1, 1, 1))
    ax.set_axis_off()
    return ax


def _arc(start: Array, end: Array) -> Array:
    """Of a great circle, (3, n)."""
    angle = np.arctan2(np.linalg.norm(np.cross(start, end)), np.dot(start, end))
    share = np.linspace(0, 1, 24)
    if angle < 1e-9:
        return np.array([start, end]).T
    weights = np.sin((1 - share) * angle) / np.sin(angle), np.sin(share * angle) / np.sin(angle)
    return np.asarray(np.outer(start, weights[0]) + np.outer(end, weights[1]))


def _plane(ax: Any) -> Any:
    from matplotlib import pyplot

    if ax is None:
        ax = pyplot.subplots(layout="constrained")[1]
    ax.set_aspect("equal", adjustable="datalim")
    ax.grid(color=colors["grid"], zorder=0)
    ax.set_axisbelow(True)
    return ax


def _bar(ax: Any, first: Any, second: Any, color: str, alpha: float) -> None:
    x, y = np.transpose([first, second])
    ax.plot(x, y, "o-", color=color, alpha=alpha, linewidth=2.4, markersize=5, markerfacecolor="white", zorder=3)


def _frame(ax: Any, x: float, y: float, theta_deg: float, size: float, name: str) -> None:
    angle = np.radians(theta_deg)
    for turn in (0, np.pi / 2):
        ax.plot([x, x + size * np.cos(angle + turn)], [y, y + size * np.sin(angle + turn)], color=colors["ink2"], lw=1.2)
    ax.annotate(name, (x, y), textcoords="offset points", xytext=(-9, -9), fontsize=8, color=colors["ink2"])


def _paths(homogeneous: Array, coordinate: Array) -> tuple[Array, Array]:
    """Points of a curve, with gaps where it goes through infinity or another branch begins."""
    w = homogeneous[:, 0]
    near = np.abs(w) > 1e-9 * np.linalg.norm(homogeneous, axis=1)
    points = np.full((len(w), 2), np.nan)
    points[near] = homogeneous[near, 1:] / w[near, None]
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    gaps = np.floor(coordinate[1:]) != np.floor(coordinate[:-1])
    gaps |= ~(steps < 30 * np.nanmedian(steps))
    return _with_gaps(points[:, 0], gaps), _with_gaps(points[:, 1], gaps)


def _with_gaps(values: Array, gaps: Array) -> Array:
    return np.insert(values, 1 + np.flatnonzero(gaps), np.nan)


def _look_at(ax: Any, points: Array, size: float) -> None:
    low, high = points.min(axis=0) - 0.9 * size, points.max(axis=0) + 0.9 * size
    ax.set_xlim(low[0], high[0])
    ax.set_ylim(low[1], high[1])


def _look_around(ax: Any, linkage: Linkage) -> None:
    motion = linkage.motion()
    names = [name.removesuffix("_x") for name in motion.dtype.names or () if name.endswith("_x")]
    points = np.concatenate([np.column_stack([motion[f"{name}_x"], motion[f"{name}_y"]]) for name in names])
    _look_at(ax, points, 0.2 * float(np.ptp(points, axis=0).max()))


def _rows_of_layer(region: Region, layer: int) -> slice:
    layers = int(region.about.get("layers", 1))
    if not 0 <= layer < layers:
        raise ValueError(f"layer {layer}: this map has {layers}, from 0")
    size = region.shape[0] // layers
    return slice(layer * size, (layer + 1) * size)


def _extent(rows: Array, columns: Array) -> tuple[float, float, float, float]:
    return (*_span(columns), *_span(rows))


def _span(coordinates: Array) -> tuple[float, float]:
    """Outer edges of the cells; their numbers where the coordinates are not evenly spaced."""
    steps = np.diff(coordinates)
    if not len(steps) or not np.allclose(steps, steps[0]):
        return 0, len(coordinates)
    return coordinates[0] - steps[0] / 2, coordinates[-1] + steps[0] / 2


def _words(measure: str) -> str:
    return measure.removesuffix("_deg").replace("_", " ") + (", °" if measure.endswith("_deg") else "")


def _rgb(color: str) -> Array:
    return np.array([int(color[i : i + 2], 16) / 255 for i in (1, 3, 5)])
