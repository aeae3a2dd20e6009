// What linkages can be coloured by, required to be and the best by once it is known how exactly they are made.
import {most_of} from "../../state/ends";
import {round_step} from "../../state/problem";
import type {ObjectiveDescription, PropertyDescription} from "../../kinds/kind";
import {limits, type Criteria} from "../analysis";
import {length_entries, length_tolerance, type Tolerances} from "./block";
import type {Making} from "./making";

const degrees_per_radian = 180 / Math.PI;
/** Over a map errors differ by some hundred times. */
const spread = 1000;

/** About how large an error is where nothing magnifies the tolerances. */
function plain_error(tolerances: Tolerances, typical: number, error: Making["error"]): number {
  const lengths = length_entries.map((key) => length_tolerance(tolerances, key)),
    length = Math.max(most_of(lengths), tolerances.clearance ?? 0),
    angle = Math.max(tolerances.driver_deg ?? 0, tolerances.link_angle_deg ?? 0);
  if (error === "length") return Math.max(length, (angle / degrees_per_radian) * typical);
  return Math.max((length / Math.max(typical, 1e-9)) * degrees_per_radian, angle);
}
/** 1, 2, 5 × 10ⁿ within a span. */
export function round_levels([from, to]: readonly [number, number]): number[] {
  const levels: number[] = [];
  for (let level = round_step(from); level <= to; level = round_step(1.5 * level)) levels.push(level);
  return levels;
}

const properties = (error: Making["error"]): Record<string, PropertyDescription> => ({
  tolerance_error: {
    needs: "tolerances",
    text: "tolerance.error",
    short: "tolerance.error_short",
    term: "tolerance_error",
    larger_is_better: false,
    requirement: "max_tolerance_error",
    quantity: "error",
    in_degrees: error === "angle",
    logarithmic: true,
    span(_, typical, {tolerances = {}}) {
      const from = round_step(plain_error(tolerances, typical, error) || 1);
      return [from, spread * from];
    },
    levels: round_levels,
  },
  yield: {
    needs: "limit",
    text: "region.by_yield",
    short: "region.by_yield",
    term: "yield",
    larger_is_better: true,
    requirement: "min_yield",
    quantity: "percent",
    of_meeting: true,
    sampled: true,
    span: () => [0, 1],
    levels: () => [0.1, 0.25, 0.5, 0.75, 0.9, 0.99],
  },
});
const requirements = (error: Making["error"]) =>
  limits({
    max_tolerance_error: {
      term: "tolerance_error",
      bound: "most",
      quantity: "error",
      in_degrees: error === "angle",
      from: 0,
      needs: "tolerances",
    },
    min_yield: {term: "yield", bound: "least", quantity: "percent", from: 0, needs: "limit"},
  });
const objectives: Record<string, ObjectiveDescription> = {
  tolerance_error: {name: "req.objective.tolerance_error", measure: "tolerance_error", needs: "tolerances"},
  yield: {name: "req.objective.yield", measure: "yield", needs: "limit"},
};
export function criteria({error}: Making): Criteria {
  return {properties: properties(error), requirements: requirements(error), objectives};
}
