import {degenerate} from "../contract/messages";
import type {MapAnswer} from "../contract/messages";
import {most_of} from "../state/ends";
import {share_of, type ValueRange} from "./value_range";

/** Share of the defect-free cells, or of those only that meet everything, in each of `bins` equal steps of the range, the largest scaled to 1. */
export function histogram(
  map: Pick<MapAnswer, "type" | "defects" | "fails" | "value">,
  range: ValueRange,
  bins: number,
  only_meeting = false,
): number[] {
  const counts = new Array<number>(bins).fill(0);
  const {type, defects, fails, value} = map;
  const step = type.length > 200_000 ? 5 : 1;
  for (let i = 0; i < type.length; i += step) {
    if (defects[i] !== 0 || type[i]! === degenerate || (only_meeting && fails[i] !== 0)) continue;
    const bin = Math.floor(bins * share_of(range, value[i]!));
    if (bin >= 0 && bin < bins) ++counts[bin]!;
  }
  const most = most_of(counts);
  return most > 0 ? counts.map((count) => count / most) : counts;
}
