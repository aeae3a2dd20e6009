// Values as shares of a range: along the ramp of colours, and along the scale.

/** Values → [0, 1] of the ramp; `from` is the bad end, whichever is larger. */
export interface ValueRange {
  from: number;
  to: number;
  /** Equal shares are equal ratios; both ends are positive. */
  logarithmic?: boolean;
}

/** Below 0 and above 1 beyond the ends. */
export function share_of({from, to, logarithmic}: ValueRange, value: number): number {
  if (from === to) return 0;
  if (!logarithmic) return (value - from) / (to - from);
  return value > 0 ? Math.log(value / from) / Math.log(to / from) : -Infinity * Math.sign(to - from);
}
export function value_at({from, to, logarithmic}: ValueRange, share: number): number {
  return logarithmic ? from * (to / from) ** share : from + share * (to - from);
}
