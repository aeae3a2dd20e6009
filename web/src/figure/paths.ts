// SVG path data in pixels.
import type {Point} from "../contract/messages";

export function px(value: number): number {
  return Math.round(value * 10) / 10;
}
export function polyline(points: readonly Point[]): string {
  return points.map((p, i) => `${i ? "L" : "M"}${px(p[0])} ${px(p[1])}`).join("");
}
export function polygon(points: readonly Point[]): string {
  return `${polyline(points)}Z`;
}
export function line(a: Point, b: Point): string {
  return polyline([a, b]);
}

/** Where a point of the fixed frame lies on a picture, in pixels, y down. */
export type Projection = (point: Point) => Point;

/** Fits points into a picture, with a margin around them; all lies in its middle where there are none. */
export function fitting(points: readonly Point[], width: number, height: number, margin: number): Projection {
  let [x0, y0, x1, y1] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [x, y] of points) [x0, y0, x1, y1] = [Math.min(x0, x), Math.min(y0, y), Math.max(x1, x), Math.max(y1, y)];
  if (!(x0 <= x1)) return () => [width / 2, height / 2];
  const scale = Math.min((width - 2 * margin) / (x1 - x0 || 1), (height - 2 * margin) / (y1 - y0 || 1));
  const left = width / 2 - (scale * (x0 + x1)) / 2,
    top = height / 2 + (scale * (y0 + y1)) / 2;
  return ([x, y]) => [left + scale * x, top - scale * y];
}
