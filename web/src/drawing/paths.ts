// SVG path data in screen pixels.
import type {Point} from "../engine/protocol";
import {placed} from "../state/problem";
import type {Pose} from "../state/task";
import {to_screen, type Viewport} from "./viewport";

export function px(value: number): number {
  return Math.round(value * 10) / 10;
}
export function polyline(points: readonly Point[]): string {
  return points.map((p, i) => `${i ? "L" : "M"}${px(p[0])} ${px(p[1])}`).join("");
}
export function body_path(
  outline: readonly Point[],
  pose: Pick<Pose, "x" | "y" | "theta_deg">,
  view: Viewport,
): string {
  return `${polyline(outline.map((p) => to_screen(view, placed(p, pose))))}Z`;
}
export function line(a: Point, b: Point): string {
  return polyline([a, b]);
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
