/** `next` with the parts of `before` that are equal in value: what the page has made of those stays as it is. */
export function sharing<Value>(next: Value, before: unknown): Value {
  if (!is_object(next) || !is_object(before) || Object.getPrototypeOf(next) !== Object.getPrototypeOf(before))
    return next;
  if (ArrayBuffer.isView(next)) return same_numbers(next as never, before as never) ? (before as Value) : next;
  const keys = Object.keys(next),
    parts = keys.map((key) => sharing<unknown>(next[key], before[key]));
  if (keys.length === Object.keys(before).length && keys.every((key, i) => key in before && parts[i] === before[key]))
    return before as Value;
  if (Array.isArray(next)) return parts as Value;
  return Object.fromEntries(keys.map((key, i) => [key, parts[i]])) as Value;
}
function is_object(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null;
}
function same_numbers(a: Float64Array, b: Float64Array): boolean {
  if (a.length !== b.length) return false;
  for (let i = 0; i < a.length; ++i) if (!Object.is(a[i], b[i])) return false;
  return true;
}
