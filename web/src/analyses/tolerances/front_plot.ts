// The plane of the two objectives: transmission angle to the right, the error upwards by its logarithm.
import type {Point} from "../../contract/messages";
import {css_values} from "../../state/css_values";
import {least_of, most_of} from "../../state/ends";
import type {Front, FrontPoint} from "./front.svelte";

export interface Field {
  angle: readonly [number, number];
  error: readonly [number, number];
  width: number;
  height: number;
}
export const room = {left: 46, right: 10, top: 8, bottom: 30};
type Values = Pick<FrontPoint, "angle_deg" | "error">;

const far_tail = 0.98; // of the cells: the rest, next to dead points, would press all others to the foot

/** What is shown: all of the front, nearly all cells, and the linkages that are to be marked. */
export function field_of({points, cells}: Front, marked: readonly Values[], width: number, height: number): Field {
  const angles: number[] = [],
    errors: number[] = [];
  for (let i = 0; i < cells.length; i += 2) {
    angles.push(cells[i]!);
    errors.push(cells[i + 1]!);
  }
  errors.sort((a, b) => a - b);
  const all = [...points, ...marked],
    usual = errors[Math.floor(far_tail * (errors.length - 1))] ?? 0;
  const low = Math.min(least_of(angles), least_of(all.map((p) => p.angle_deg))),
    high = Math.max(most_of(angles), most_of(all.map((p) => p.angle_deg))),
    bottom = least_of(all.map((p) => p.error)),
    top = Math.max(usual, most_of(all.map((p) => p.error)));
  const margin = Math.max(0.03 * (high - low), 0.5);
  return {
    angle: [Math.max(low - margin, 0), Math.min(high + margin, 90)],
    error: [bottom / 1.15, Math.max(top, 1.5 * bottom) * 1.1],
    width,
    height,
  };
}
export function place_of({angle, error, width, height}: Field, point: Values): Point {
  const across = (point.angle_deg - angle[0]) / (angle[1] - angle[0]),
    up = Math.log(point.error / error[0]) / Math.log(error[1] / error[0]);
  return [
    room.left + across * (width - room.left - room.right),
    room.top + (1 - up) * (height - room.top - room.bottom),
  ];
}
/** All cells, faint: a dot to each, where several fall on one pixel the first. */
export function paint_cells(canvas: HTMLCanvasElement, {cells}: Front, field: Field): void {
  const ratio = devicePixelRatio,
    context = canvas.getContext("2d")!,
    taken = new Set<number>();
  canvas.width = Math.round(field.width * ratio);
  canvas.height = Math.round(field.height * ratio);
  context.scale(ratio, ratio);
  context.fillStyle = css_values(canvas, ["ink3"]).ink3;
  context.globalAlpha = 0.22;
  for (let i = 0; i < cells.length; i += 2) {
    const [x, y] = place_of(field, {angle_deg: cells[i]!, error: cells[i + 1]!}),
      pixel = Math.round(y) * Math.ceil(field.width) + Math.round(x);
    if (y < room.top || taken.has(pixel)) continue;
    taken.add(pixel);
    context.fillRect(x - 0.6, y - 0.6, 1.2, 1.2);
  }
}
/** From each point of the front to the next better angle it is a corner that nothing reaches beyond. */
export function front_path(field: Field, points: readonly FrontPoint[]): string {
  return points
    .map((point, i) => {
      const [x, y] = place_of(field, point).map((v) => Math.round(v * 10) / 10);
      return i === 0 ? `M${x} ${y}` : `V${y}H${x}`;
    })
    .join("");
}
/** Index of the point of the front that is meant by pointing at a place; −1 where there is none. */
export function nearest_point(field: Field, points: readonly FrontPoint[], [x, y]: Point): number {
  let best = -1,
    least = Infinity;
  points.forEach((point, i) => {
    const at = place_of(field, point),
      distance = Math.hypot(at[0] - x, at[1] - y);
    if (distance < least) [best, least] = [i, distance];
  });
  return best;
}

/** 1, 2, 5 × 10ⁿ within the range; where that is less than a decade wide, closer. */
export function error_ticks([from, to]: readonly [number, number]): number[] {
  const digits = to / from < 3 ? [1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8] : to / from > 300 ? [1] : [1, 2, 5];
  const ticks: number[] = [];
  for (let power = Math.floor(Math.log10(from)); power <= Math.ceil(Math.log10(to)); ++power)
    for (const digit of digits) {
      const value = Number((digit * 10 ** power).toPrecision(6));
      if (value >= from && value <= to) ticks.push(value);
    }
  return ticks;
}
export function angle_ticks([from, to]: readonly [number, number]): number[] {
  const step = [1, 2, 5, 10, 15, 30].find((width) => (to - from) / width <= 7) ?? 30,
    first = Math.ceil(from / step);
  return Array.from({length: Math.floor(to / step) - first + 1}, (_, i) => (first + i) * step);
}
