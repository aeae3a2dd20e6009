// Values that come from outside, looked at one by one.
import type {Point} from "../contract/messages";

export type JsonObject = Record<string, unknown>;

export function is_object(value: unknown): value is JsonObject {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}
export function is_number(value: unknown): value is number {
  return typeof value === "number" && Math.abs(value) <= 1e12;
}
export function is_finite(value: unknown): value is number {
  return Number.isFinite(value);
}
export function is_pair(value: unknown): value is Point {
  return Array.isArray(value) && value.length === 2 && value.every(is_number);
}
/** All of a list, or nothing where one of them is none. */
export function read_list<T>(value: unknown, read: (item: unknown) => T | null, most: number): T[] | null {
  if (!Array.isArray(value) || value.length > most) return null;
  const list = value.map(read);
  return list.every((item) => item !== null) ? list : null;
}
/** The members that are there. */
export function present<T extends object>(members: T): {[K in keyof T]?: NonNullable<T[K]>} {
  return Object.fromEntries(Object.entries(members).filter(([, value]) => value !== undefined && value !== null)) as {
    [K in keyof T]?: NonNullable<T[K]>;
  };
}
