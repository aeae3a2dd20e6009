// How far the axes of a map run: the engine's ticks tell it, options.window sets it.
import type {Axes, Axis, Side} from "../../contract/messages";
import type {Interval} from "../../state/task";

function rounded(value: number): number {
  return Number(value.toPrecision(9));
}
/** As people read it; null where there is nothing to read. */
export function range_of({ticks, branches: [branch]}: Axis): Interval | null {
  const own = (ticks ?? []).filter(([tau]) => branch && tau >= branch.from && tau < branch.to),
    first = own[0],
    last = own.at(-1);
  if (!branch || !first || !last || own.length < 2) return null;
  const slope = (last[1] - first[1]) / (last[0] - first[0]);
  return [rounded(first[1]), rounded(first[1] + slope * (branch.to - first[0]))];
}
export function ranges_of(axes: Axes): Record<Side, Interval | null> {
  return {input: range_of(axes.input), output: range_of(axes.output)};
}
/** As options.window has them. */
export function window_of({input, output}: Record<Side, Interval | null>): [Interval, Interval] | undefined {
  return input && output ? [input, output] : undefined;
}
