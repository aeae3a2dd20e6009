// The map over the drawing, where its places are places of a pivot in the plane: which linkage has it under the pointer, and
// what colour a pixel of the drawing has.
import {degenerate, type Axis, type MapAnswer, type Point, type TauPair} from "../contract/messages";
import {place_of, plane_axes, places_of, tau_of_point, tau_on_line, type PlaneAxes} from "../engine/axis";
import {preferences} from "../state/preferences.svelte";
import type {Workbench} from "../state/workbench.svelte";
import type {Bench} from "./bench";
import type {Target} from "./handles";
import type {Plane} from "./space";

type Asked = Pick<Workbench, "task" | "map" | "solid">;

/** Nothing where the map is of something else, or is not to be shown here. */
export function plane_here({task, map, solid}: Asked): PlaneAxes | null {
  return task && map && !solid && preferences.plane_map ? plane_axes(task.axes) : null;
}
/** Of the linkage whose pivot lies under the pointer. */
export function tau_under({workbench, scene}: Bench, at: Point): TauPair | null {
  const plane = plane_here(workbench);
  return plane && tau_of_point(workbench.task!.axes, plane, scene.space.unproject(at));
}
/** A pivot that comes along with the pointer is nothing to be taken hold of. */
export function comes_along({workbench}: Bench, target: Target): boolean {
  return target.kind === "pivot" && target.end === plane_here(workbench)?.end;
}
/** Takes the linkage under the pointer in hand; false: there is none. */
export function pick_under(bench: Bench, at: Point): boolean {
  const {workbench} = bench,
    tau = tau_under(bench, at),
    cell = tau && cell_at(workbench, tau);
  if (!tau || cell === null || workbench.map!.type[cell] === degenerate) return false;
  workbench.pick(tau, "drawing");
  return true;
}
function cell_at({task, map}: Asked, tau: TauPair): number | null {
  const place = places_of(task!.axes, tau);
  if (!place || !map) return null;
  const row = index_at(place[0], map.window.input, map.rows),
    column = index_at(place[1], map.window.output, map.columns);
  return row < 0 || column < 0 ? null : row * map.columns + column;
}
function index_at(place: number, [from, to]: readonly [number, number], count: number): number {
  const index = Math.floor(((place - from) / (to - from)) * count);
  return index >= 0 && index < count ? index : -1;
}

// ---- its tint ---------------------------------------------------------------------------------------------------------

/** Pixels of the drawing that one of the tint covers, each way. */
export const tint_px = 2;
export interface Tinted {
  axes: Record<"input" | "output", Axis>;
  plane: PlaneAxes;
  map: MapAnswer;
  /** Of its cells, row 0 at the bottom (region/painter). */
  colors: Uint32Array;
}
/** Fills width × height pixels: what is free of defects in its colour, all else clear. */
export function tint(
  {axes, plane, map, colors}: Tinted,
  space: Plane,
  width: number,
  height: number,
  out: Uint32Array,
): void {
  const {rows, columns, type, defects} = map;
  const across = indices(axes, plane.x, map, width, (i) => space.unproject([(i + 0.5) * tint_px, 0])[0]),
    up = indices(axes, plane.y, map, height, (k) => space.unproject([0, (k + 0.5) * tint_px])[1]),
    along_rows = plane.y === "input";
  for (let k = 0, to = 0; k < height; ++k) {
    for (let i = 0; i < width; ++i, ++to) {
      const row = along_rows ? up[k]! : across[i]!,
        column = along_rows ? across[i]! : up[k]!,
        cell = row * columns + column;
      const shows = row >= 0 && column >= 0 && type[cell] !== degenerate && defects[cell] === 0;
      out[to] = shows ? colors[(rows - 1 - row) * columns + column]! : 0;
    }
  }
}
/** Row or column of the map at each of `count` pixels; −1: none. */
function indices(
  axes: Tinted["axes"],
  side: "input" | "output",
  map: MapAnswer,
  count: number,
  value: (pixel: number) => number,
): Int32Array {
  const axis = axes[side],
    cells = side === "input" ? map.rows : map.columns;
  return Int32Array.from({length: count}, (_, i) => {
    const place = place_of(axis, tau_on_line(axis, value(i)));
    return place === null ? -1 : index_at(place, map.window[side], cells);
  });
}
