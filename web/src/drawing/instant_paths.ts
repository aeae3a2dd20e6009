// The circles, lines and curves of an instant as paths in px.
import type {CircleOrLine, Point} from "../contract/messages";
import {line, px} from "../figure/paths";
import {clip} from "./curve_samples";
import type {Plane} from "./space";

export interface Sight {
  width: number;
  height: number;
}
const sagitta = 0.1; // px between a circle and its chords
const largest = 4000; // px: beyond it a circle is drawn where it can be seen only

export function polyline(points: readonly Point[], {project}: Pick<Plane, "project">): string {
  return points
    .map((point, i) => {
      const [x, y] = project(point);
      return `${i === 0 ? "M" : "L"}${px(x)} ${px(y)}`;
    })
    .join("");
}
/** A line without ends, as far as it is seen. */
export function endless(point: Point, direction_deg: number, {project}: Pick<Plane, "project">, seen: Sight): string {
  const at = project(point),
    turn = (direction_deg * Math.PI) / 180;
  const end = (s: number): Point => [at[0] + s * Math.cos(turn), at[1] - s * Math.sin(turn)];
  const piece = clip(end(-1e6), end(1e6), [-10, -10], [seen.width + 10, seen.height + 10]);
  return piece ? line(...piece) : "";
}
export function circle_path(shape: CircleOrLine, space: Pick<Plane, "project">, seen: Sight): string {
  if ("line" in shape) return endless(shape.line.point, shape.line.direction_deg, space, seen);
  const [x, y] = space.project(shape.center),
    [edge] = space.project([shape.center[0] + shape.radius, shape.center[1]]),
    radius = edge - x;
  const towards = Math.atan2(seen.height / 2 - y, seen.width / 2 - x);
  const half = radius < largest ? Math.PI : Math.min(Math.PI, (2 * Math.hypot(seen.width, seen.height)) / radius);
  const steps = Math.max(Math.ceil(half * Math.sqrt(radius / (2 * sagitta))), 8);
  return Array.from({length: steps + 1}, (_, i) => {
    const angle = towards + half * ((2 * i) / steps - 1);
    return `${i === 0 ? "M" : "L"}${px(x + radius * Math.cos(angle))} ${px(y + radius * Math.sin(angle))}`;
  }).join("");
}
