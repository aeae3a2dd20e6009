// Where a drag comes to rest: the grid, the places of other poses, round angles.
import type {Point} from "../contract/messages";

/** How near in pixels things line up. */
export const align_px = 6;

export interface Keys {
  shift: boolean; // one axis, 15°
  alt: boolean; // no snapping
  fine: boolean; // Ctrl or ⌘: a tenth of the motion
}
export const no_keys: Keys = {shift: false, alt: false, fine: false};

export function keys_of(event: {shiftKey: boolean; altKey: boolean; ctrlKey: boolean; metaKey: boolean}): Keys {
  return {shift: event.shiftKey, alt: event.altKey, fine: event.ctrlKey || event.metaKey};
}

/** A hair line: all points with this x, or this y. */
export interface Guide {
  axis: "x" | "y";
  value: number;
}
export interface Grid {
  step: number;
  /** Values to align with, and how near is near (user units). */
  xs: readonly number[];
  ys: readonly number[];
  near: number;
  on: boolean; // snapping not switched off
}

/** A multiple of the step without the dust of binary fractions. */
export function multiple(value: number, step: number): number {
  return Number((Math.round(value / step) * step).toPrecision(12)) + 0;
}
/** Freely placed values are still cut where nobody can see: a hundredth of a pixel. */
export function cut(value: number, pixel: number): number {
  return multiple(value, 10 ** Math.floor(Math.log10(pixel / 10)));
}

function aligned(value: number, candidates: readonly number[], near: number): number | null {
  let best: number | null = null;
  for (const c of candidates) {
    if (Math.abs(c - value) <= near && (best === null || Math.abs(c - value) < Math.abs(best - value))) best = c;
  }
  return best;
}

/** A dragged point: `from` where it was taken, `raw` where the pointer has it. */
export function snapped_point(
  from: Point,
  raw: Point,
  grid: Grid,
  keys: Keys,
  pixel: number,
): {point: Point; guides: Guide[]} {
  let [x, y] = raw;
  const keeps_x = keys.shift && Math.abs(raw[0] - from[0]) < Math.abs(raw[1] - from[1]);
  const keeps_y = keys.shift && !keeps_x;
  if (keeps_x) x = from[0];
  if (keeps_y) y = from[1];
  if (keys.alt || !grid.on) return {point: [keeps_x ? x : cut(x, pixel), keeps_y ? y : cut(y, pixel)], guides: []};
  const step = keys.fine ? grid.step / 10 : grid.step,
    near = keys.fine ? grid.near / 10 : grid.near;
  const guides: Guide[] = [];
  const settle = (axis: "x" | "y", value: number, candidates: readonly number[]) => {
    const other = aligned(value, candidates, near);
    if (other === null) return multiple(value, step);
    guides.push({axis, value: other});
    return other;
  };
  return {point: [keeps_x ? x : settle("x", x, grid.xs), keeps_y ? y : settle("y", y, grid.ys)], guides};
}

/** (−180, 180] */
export function wrapped_deg(angle: number): number {
  const rest = angle - 360 * Math.ceil((angle - 180) / 360);
  return rest <= -180 ? rest + 360 : rest;
}

/** A dragged angle in degrees; `near` is how many degrees 6 px are at the arm's end. */
export function snapped_angle(
  raw: number,
  others: readonly number[],
  near: number,
  on: boolean,
  keys: Keys,
): {angle: number; aligned: boolean} {
  if (keys.shift) return {angle: wrapped_deg(multiple(raw, 15)), aligned: false};
  if (keys.alt || !on) return {angle: wrapped_deg(multiple(raw, 0.001)), aligned: false};
  const other = others
    .map(wrapped_deg)
    .find((o) => Math.abs(wrapped_deg(raw - o)) <= Math.min(near, keys.fine ? 0.05 : 0.8));
  if (other !== undefined) return {angle: other, aligned: true};
  return {angle: wrapped_deg(multiple(raw, keys.fine ? 0.1 : 1)), aligned: false};
}
