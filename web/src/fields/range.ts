// A range is taken when both of its ends are there and fit; until then what was typed stands beside the last good one.
export type Ends = readonly [from: number | null, to: number | null];
export interface RangeRule {
  /** From below to; otherwise the two only differ. */
  rising: boolean;
  /** Both ends empty: none. */
  optional: boolean;
}
export type RangeFault = "half" | "falling" | "no_extent";

export function reading_of(
  [from, to]: Ends,
  {rising, optional}: RangeRule,
): {range: readonly [number, number] | null} | {fault: RangeFault} {
  if (from === null && to === null && optional) return {range: null};
  if (from === null || to === null) return {fault: "half"};
  if (from === to) return {fault: "no_extent"};
  return rising && from > to ? {fault: "falling"} : {range: [from, to]};
}
export function with_end(ends: Ends, end: 0 | 1, to: number | null): Ends {
  return end === 0 ? [to, ends[1]] : [ends[0], to];
}
export function same_ends(a: Ends, b: Ends): boolean {
  return a[0] === b[0] && a[1] === b[1];
}
