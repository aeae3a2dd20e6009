// The scrub bar's scale: driver angles to places along the bar. The whole travel is on it, and the prescribed stretch gets
// at least three fifths of the length, so that its positions can be told apart where the travel is long.
import type {Drive} from "../contract/messages";
import {travel} from "../state/drive";
import {stops_of, task_span, type Stop} from "./play";

export type Knot = readonly [angle: number, place: number];
export const least_task_share = 0.6;
export const snap_px = 6;

export function bar_knots(drive: Drive): Knot[] {
  const [low, high] = travel(drive),
    task = task_span(drive);
  if (!(high > low))
    return [
      [low, 0],
      [low + 1, 1],
    ];
  if (!task)
    return [
      [low, 0],
      [high, 1],
    ];
  const before = task[0] - low,
    after = high - task[1],
    all = high - low;
  const share = Math.max((task[1] - task[0]) / all, least_task_share);
  const outside = before + after;
  const start = outside > 0 ? ((1 - share) * before) / outside : 0;
  const end = outside > 0 ? 1 - ((1 - share) * after) / outside : 1;
  const knots: Knot[] = [
    [low, 0],
    [task[0], start],
    [task[1], end],
    [high, 1],
  ];
  return knots.filter((knot, i) => i === 0 || knot[0] > knots[i - 1]![0]);
}

function interpolated(knots: readonly Knot[], value: number, from: 0 | 1): number {
  const to = from === 0 ? 1 : 0,
    last = knots.length - 1;
  if (value <= knots[0]![from]) return knots[0]![to];
  if (value >= knots[last]![from]) return knots[last]![to];
  const i = knots.findIndex((knot) => knot[from] >= value);
  const [a, b] = [knots[i - 1], knots[i]];
  return a![to] + ((value - a![from]) / (b![from] - a![from])) * (b![to] - a![to]);
}
export function bar_place(knots: readonly Knot[], angle: number): number {
  return interpolated(knots, angle, 0);
}
export function bar_angle(knots: readonly Knot[], place: number): number {
  return interpolated(knots, place, 1);
}

/** The angle meant by a place along a bar of `length_px`: a position within six pixels is that position. */
export function snapped_angle(
  knots: readonly Knot[],
  stops: readonly Stop[],
  place: number,
  length_px: number,
): number {
  const away = (stop: Stop) => Math.abs(bar_place(knots, stop.angle) - place) * length_px;
  const nearest = [...stops].sort((a, b) => away(a) - away(b))[0];
  return nearest && away(nearest) <= snap_px ? nearest.angle : bar_angle(knots, place);
}

/** One degree on, or to the next position. */
export function keyed_angle(drive: Drive, angle: number, key: string, to_position: boolean): number | null {
  const [low, high] = travel(drive);
  const sense =
    key === "ArrowRight" || key === "ArrowUp" || key === "PageUp"
      ? 1
      : key === "ArrowLeft" || key === "ArrowDown" || key === "PageDown"
        ? -1
        : 0;
  if (key === "Home") return low;
  if (key === "End") return high;
  if (sense === 0) return null;
  if (!to_position && !key.startsWith("Page")) return Math.min(Math.max(angle + sense, low), high);
  const stops = stops_of(drive).map((stop) => stop.angle);
  return (
    (sense > 0 ? stops.find((a) => a > angle + 1e-9) : stops.findLast((a) => a < angle - 1e-9)) ??
    (sense > 0 ? high : low)
  );
}
