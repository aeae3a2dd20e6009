// The dimensions of a linkage and the tolerances that a problem file gives for them: several dimensions share one.
import type {ToleranceFigures} from "../../contract/messages";
import {length_entries, length_tolerance, with_length, type LengthEntry, type Tolerances} from "./block";

export type Share = ToleranceFigures["sensitivities"][number];
/** Where a problem file has a tolerance. */
export type Entry = LengthEntry | "driver_deg" | "link_angle_deg";

const driving_body = "1";

/** `parameters`: all of the linkage, among which those of a longer one have their neighbours. */
export function entry_of(parameter: string, of_angle: boolean, parameters: readonly string[]): Entry {
  if (parameter === "driver") return "driver_deg";
  if (of_angle) return "link_angle_deg";
  if (parameter.startsWith("point_")) return "point";
  if (/center_.*[xy]$/.test(parameter)) return "ground_pivots";
  if (parameter.startsWith("length ")) return entry_of_length(parameter, parameters);
  return length_entries.find((entry) => entry === parameter) ?? "coupler";
}
/** Of a longer linkage, "length 2:b-d" of body 2: the driver's is the input's, those of other bodies hinged to the ground
 *  the output's, the rest the coupler's. */
function entry_of_length(parameter: string, parameters: readonly string[]): Entry {
  const body_of = (name: string) => /^length (\d+):/.exec(name)?.[1];
  const body = body_of(parameter);
  if (body === driving_body) return "input";
  const joints = parameters
    .filter((name) => body !== undefined && body_of(name) === body)
    .flatMap((name) => name.split(":")[1]!.split("-"));
  return joints.some((joint) => parameters.includes(`center_${joint}_x`)) ? "output" : "coupler";
}
export function entry_of_share({parameter, tolerance_deg}: Share, all: readonly Share[]): Entry {
  return entry_of(
    parameter,
    tolerance_deg !== undefined,
    all.map((one) => one.parameter),
  );
}

export function tolerance_at(tolerances: Tolerances, entry: Entry): number {
  return is_angle(entry) ? (tolerances[entry] ?? 0) : length_tolerance(tolerances, entry);
}
export function with_tolerance(tolerances: Tolerances, entry: Entry, value: number): Tolerances {
  return is_angle(entry) ? {...tolerances, [entry]: value} : with_length(tolerances, entry, value);
}
function is_angle(entry: Entry): entry is Exclude<Entry, LengthEntry> {
  return entry === "driver_deg" || entry === "link_angle_deg";
}

/** By which factor the tolerance behind a dimension changes where its share of the variance is to become `wanted` while
 *  all others stay; `common`: the share of all dimensions with that tolerance. The variance goes by its square. */
export function factor_for_share(share: number, common: number, wanted: number): number {
  const most = (0.995 * share) / common,
    held = Math.min(Math.max(wanted, 0.0001), common < 1 - 1e-9 ? most : share);
  if (common >= 1 - 1e-9) return 1; // nothing else counts: its share stays whatever it is
  return Math.sqrt((held * (1 - common)) / (share - held * common));
}
export function rounded(value: number): number {
  return Number(value.toPrecision(3));
}

/** The cheapest tolerances of the same error, an entry each: of those that share one the finest. */
export function allocated(tolerances: Tolerances, {allocation, sensitivities}: ToleranceFigures): Tolerances {
  const finest = new Map<Entry, number>(),
    parameters = sensitivities.map(({parameter}) => parameter);
  for (const {parameter, tolerance, tolerance_deg} of allocation ?? []) {
    const entry = entry_of(parameter, tolerance_deg !== undefined, parameters),
      value = tolerance_deg ?? tolerance ?? 0;
    finest.set(entry, Math.min(finest.get(entry) ?? Infinity, value));
  }
  return [...finest].reduce((all, [entry, value]) => with_tolerance(all, entry, rounded(value)), tolerances);
}

/** A tolerance that makes so much of the variance is to be tightened first, and up to the other does not matter. */
const worth_tightening = 0.25,
  does_not_matter = 0.01;
export function advice_for({share}: Share): "tighten" | "loosen" | null {
  return share >= worth_tightening ? "tighten" : share < does_not_matter ? "loosen" : null;
}
