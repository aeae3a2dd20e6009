// Which part of the fixed frame the drawing shows. User units, y up; screen pixels, y down.
import type {Box, Point} from "../contract/messages";
import {round_step} from "../state/problem";
import {least_of, most_of} from "../state/ends";

export interface Viewport {
  /** The fixed-frame point in the middle. */
  x: number;
  y: number;
  scale: number; // pixels per unit
  width: number;
  height: number;
}
export interface Margins {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

const least_scale = 1e-7,
  most_scale = 1e9;

export function to_screen(view: Viewport, point: Point): Point {
  return [view.width / 2 + (point[0] - view.x) * view.scale, view.height / 2 - (point[1] - view.y) * view.scale];
}
export function to_user(view: Viewport, at: Point): Point {
  return [view.x + (at[0] - view.width / 2) / view.scale, view.y - (at[1] - view.height / 2) / view.scale];
}

/** Zoomed so that the point under `at` stays there. */
export function zoomed(view: Viewport, factor: number, at: Point): Viewport {
  const scale = Math.min(Math.max(view.scale * factor, least_scale), most_scale);
  const [x, y] = to_user(view, at);
  return {...view, scale, x: x - (at[0] - view.width / 2) / scale, y: y + (at[1] - view.height / 2) / scale};
}
export function panned(view: Viewport, dx: number, dy: number): Viewport {
  return {...view, x: view.x - dx / view.scale, y: view.y + dy / view.scale};
}
export function resized(view: Viewport, width: number, height: number): Viewport {
  return {...view, width, height};
}

export function bounds(points: readonly Point[]): Box | null {
  const finite = points.filter((p) => Number.isFinite(p[0]) && Number.isFinite(p[1]));
  if (finite.length === 0) return null;
  const xs = finite.map((p) => p[0]),
    ys = finite.map((p) => p[1]);
  return {x: [least_of(xs), most_of(xs)], y: [least_of(ys), most_of(ys)]};
}

/** The view that shows a box whole, inside margins in pixels; a single point is shown with 200 units around it. */
export function fitted(box: Box, width: number, height: number, margins: Margins): Viewport {
  const free_width = Math.max(width - margins.left - margins.right, 40);
  const free_height = Math.max(height - margins.top - margins.bottom, 40);
  let w = box.x[1] - box.x[0],
    h = box.y[1] - box.y[0];
  if (!(w > 0) && !(h > 0)) w = h = 200;
  const scale = Math.min(Math.max(Math.min(free_width / w, free_height / h), least_scale), most_scale);
  return {
    scale,
    width,
    height,
    x: (box.x[0] + box.x[1]) / 2 - (margins.left - margins.right) / 2 / scale,
    y: (box.y[0] + box.y[1]) / 2 + (margins.top - margins.bottom) / 2 / scale,
  };
}
export function shows(view: Viewport, point: Point, border = 0): boolean {
  const [x, y] = to_screen(view, point);
  return x >= border && y >= border && x <= view.width - border && y <= view.height - border;
}

/** The step to which drags snap: the smallest of 1-2-5 × 10ⁿ that is at least 8 px. */
export function grid_step(view: Viewport): number {
  return round_step(8 / view.scale);
}
/** Lines of the grid stand a round number of units apart, at least 40 px. */
export function line_step(view: Viewport): number {
  return round_step(40 / view.scale);
}

/** Where the ray from the middle of the window leaves it, a little inside; for what lies outside. */
export function at_edge(view: Viewport, direction: Point, inset: number): Point {
  const x = view.width / 2 - inset,
    y = view.height / 2 - inset;
  const reach = Math.min(
    direction[0] !== 0 ? x / Math.abs(direction[0]) : Infinity,
    direction[1] !== 0 ? y / Math.abs(direction[1]) : Infinity,
  );
  return [view.width / 2 + direction[0] * reach, view.height / 2 + direction[1] * reach];
}
