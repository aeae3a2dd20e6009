import {degenerate} from "../engine/protocol";
import type {MapAnswer} from "../engine/protocol";
import {most_of} from "../state/ends";

/** Share of the defect-free cells in each of `bins` equal steps of [from, to], the largest scaled to 1. */
export function histogram(
  map: Pick<MapAnswer, "type" | "defects" | "value">,
  from: number,
  to: number,
  bins: number,
): number[] {
  const counts = new Array<number>(bins).fill(0),
    scale = bins / (to - from || 1);
  const {type, defects, value} = map;
  const step = type.length > 200_000 ? 5 : 1;
  for (let i = 0; i < type.length; i += step) {
    if (defects[i] !== 0 || type[i]! === degenerate) continue;
    const bin = Math.floor((value[i]! - from) * scale);
    if (bin >= 0 && bin < bins) ++counts[bin]!;
  }
  const most = most_of(counts);
  return most > 0 ? counts.map((count) => count / most) : counts;
}
