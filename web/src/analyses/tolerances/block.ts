// How exactly linkages are made, as the problem file has it: half tolerances, in the user's unit and in degrees.
import type {Problem} from "../../state/problem";
import {is_number, is_object, present, type JsonObject} from "../../state/shape";

export const length_entries = ["input", "coupler", "output", "ground_pivots", "point"] as const;
export type LengthEntry = (typeof length_entries)[number];
export type LengthTolerances = {[K in LengthEntry]?: number | null};
export const distributions = ["normal", "truncated_normal", "uniform"] as const;
export type Distribution = (typeof distributions)[number];
export const limit_kinds = ["position", "angle_deg", "deviation"] as const;
export type LimitKind = (typeof limit_kinds)[number];
/** The error up to which a linkage is good: one of them. */
export type Limit = {readonly [K in LimitKind]?: number};

export interface Tolerances {
  /** One for all, or each its own. */
  length?: number | LengthTolerances;
  /** Radius: how far a pin can move in its hole. */
  clearance?: number;
  driver_deg?: number;
  /** Of the arcs of a sphere. */
  link_angle_deg?: number;
  distribution?: Distribution;
  /** By which an angle is multiplied to be weighed against a distance; none: the size of the task. */
  turning_length?: number;
  limit?: Limit;
  cost?: {exponent: number};
  samples?: number;
  seed?: number;
}

const is_half = (value: unknown): value is number => is_number(value) && value >= 0;

function read_length(value: unknown): number | LengthTolerances | null {
  if (is_half(value)) return value;
  if (!is_object(value)) return null;
  return present(Object.fromEntries(length_entries.map((key) => [key, is_half(value[key]) ? value[key] : null])));
}
function read_limit(value: unknown): Limit | null {
  if (!is_object(value)) return null;
  const kind = limit_kinds.find((kind) => is_number(value[kind]));
  return kind ? {[kind]: value[kind]} : null;
}
/** From outside, member by member; the engine says in detail what is wrong. */
export function read_tolerances(value: unknown): Tolerances | null {
  if (!is_object(value)) return null;
  const half = (key: keyof Tolerances) => (is_half(value[key]) ? value[key] : null),
    number = (of: JsonObject, key: string) => (is_number(of[key]) ? of[key] : null);
  const exponent = is_object(value.cost) ? number(value.cost, "exponent") : null;
  return present({
    length: read_length(value.length),
    clearance: half("clearance"),
    driver_deg: half("driver_deg"),
    link_angle_deg: half("link_angle_deg"),
    distribution: distributions.find((name) => name === value.distribution) ?? null,
    turning_length: number(value, "turning_length"),
    limit: read_limit(value.limit),
    cost: exponent === null ? null : {exponent},
    samples: number(value, "samples"),
    seed: number(value, "seed"),
  });
}

/** That of one kind of length. */
export function length_tolerance({length}: Tolerances, key: LengthEntry): number {
  return (typeof length === "object" ? length[key] : length) ?? 0;
}
/** The one number that all of these have; null: they differ. */
export function common_length(tolerances: Tolerances, keys: readonly LengthEntry[]): number | null {
  const [first = 0, ...others] = keys.map((key) => length_tolerance(tolerances, key));
  return others.every((other) => other === first) ? first : null;
}
/** With one kind of length of its own; one number again where all are the same. */
export function with_length(tolerances: Tolerances, key: LengthEntry, value: number): Tolerances {
  const each = Object.fromEntries(
    length_entries.map((of) => [of, of === key ? value : length_tolerance(tolerances, of)]),
  );
  const changed = {...tolerances, length: each};
  return {...changed, length: common_length(changed, length_entries) ?? each};
}
/** Nothing varies: the engine takes none of these. */
export function is_exact(tolerances: Tolerances): boolean {
  const {clearance = 0, driver_deg = 0, link_angle_deg = 0} = tolerances;
  return (
    !(clearance || driver_deg || link_angle_deg) && length_entries.every((key) => !length_tolerance(tolerances, key))
  );
}
export function limit_of({limit = {}}: Tolerances): {kind: LimitKind; value: number} | null {
  const kind = limit_kinds.find((of) => limit[of] !== undefined);
  return kind ? {kind, value: limit[kind]!} : null;
}

declare module "../../state/problem" {
  interface Problem {
    tolerances?: Tolerances;
  }
}
export function tolerances_of({tolerances}: Pick<Problem, "tolerances">): Tolerances | null {
  return tolerances ?? null;
}
