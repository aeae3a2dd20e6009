// Bars of the distances of a path from its points, in pixels of a plot.
import type {PathFit} from "../../contract/result";
import type {PathTask} from "./task";

export interface Bar {
  x: number;
  y: number;
  width: number;
  /** Of the task, from 1. */
  point: number;
  /** User's unit. */
  distance: number;
  outside: boolean;
}
export interface Plot {
  bars: Bar[];
  /** What the upper edge stands for, user's unit. */
  top: number;
  /** Height of the tolerance of all points; nothing where there is none, or it lies beyond the edge. */
  limit: number | null;
}

export function plot_of(fit: PathFit, {tolerance}: Pick<PathTask, "tolerance">, width: number, height: number): Plot {
  const most = fit.at.reduce((largest, {distance}) => Math.max(largest, distance), 0),
    room = 1.15,
    reach = tolerance !== undefined && tolerance < 3 * most ? Math.max(most, tolerance) : most,
    top = reach > 0 ? room * reach : 1,
    step = width / Math.max(1, fit.at.length),
    gap = step > 4 ? 1 : 0,
    outside = new Set(fit.outside);
  const y = (distance: number) => height * (1 - distance / top);
  return {
    bars: fit.at.map(({point, distance}, i) => ({
      x: i * step,
      y: y(distance),
      width: Math.max(0.5, step - gap),
      point,
      distance,
      outside: outside.has(point),
    })),
    top,
    limit: tolerance !== undefined && tolerance <= top ? y(tolerance) : null,
  };
}
