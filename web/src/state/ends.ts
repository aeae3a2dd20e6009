// Least and most of any number of values: Math.min over a spread list throws where there are more than a call may have arguments.

/** Infinity of none. */
export function least_of(values: Iterable<number>): number {
  let end = Infinity;
  for (const value of values) end = Math.min(end, value);
  return end;
}
/** −Infinity of none. */
export function most_of(values: Iterable<number>): number {
  let end = -Infinity;
  for (const value of values) end = Math.max(end, value);
  return end;
}
