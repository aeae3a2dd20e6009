// For tests: tolerances as files have them, drawn at random.
import fc from "fast-check";
import {positive, record} from "../../state/arbitrary_values";
import {distributions, length_entries, limit_kinds, type LengthTolerances, type Tolerances} from "./block";

const half = fc.double({min: 0, max: 1e9, noNaN: true});
const tolerances = record<Tolerances>(
  {},
  {
    length: fc.oneof(
      half,
      record<LengthTolerances>({}, Object.fromEntries(length_entries.map((entry) => [entry, half])) as object),
    ),
    clearance: half,
    driver_deg: half,
    link_angle_deg: half,
    distribution: fc.constantFrom(...distributions),
    turning_length: half,
    limit: fc.tuple(fc.constantFrom(...limit_kinds), positive()).map(([kind, value]) => ({[kind]: value})),
    cost: fc.record({exponent: positive(10)}),
    samples: fc.integer({min: 1000, max: 10_000_000}),
    seed: fc.nat(),
  },
);
export const arbitrary_block = {tolerances};
