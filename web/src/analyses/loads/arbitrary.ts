// For tests: loads as files have them, drawn at random.
import fc from "fast-check";
import {
  driver_laws,
  four_bar_joints,
  loaded_bodys,
  read_outs,
  type LoadCase,
  type Loads,
  type Spring,
} from "../../contract/problem";
import {number, point, positive, record, text} from "../../state/arbitrary_values";

const half = fc.double({min: 0, max: 1e9, noNaN: true}),
  name = text(20),
  on = fc.constantFrom(...loaded_bodys);
const stud = fc.record({on, at: point}),
  link = fc.oneof(fc.record({kg_per_m: half}), fc.record({mass: half, center: point})),
  links = fc.record({input: link, coupler: link, output: link}, {requiredKeys: []});
const gas = fc.record({
  kind: fc.constant("gas" as const),
  from: stud,
  to: stud,
  extended_length: positive(),
  stroke: positive(),
  F1: positive(),
  F2: positive(),
  friction: half,
  percent_per_10K: fc.oneof(fc.constant(null), number()),
});
const coil = fc.record({
  kind: fc.constant("coil" as const),
  from: stud,
  to: stud,
  rate: half,
  free_length: half,
  acts: fc.constantFrom("both" as const, "tension" as const, "compression" as const),
});
const torsion = fc.record({
  kind: fc.constant("torsion" as const),
  joint: fc.constantFrom(...four_bar_joints),
  rate_per_deg: number(),
});
const extra = fc.oneof(
  fc.record({name, on, at: point, mass: half}),
  fc.record({name, on, at: point, force: point, frame: fc.constantFrom("fixed" as const, "body" as const)}),
);
const load_case = record<LoadCase>(
  {name},
  {
    temperature_C: number(),
    slope_deg: number(),
    extra: fc.array(name, {maxLength: 3}),
    spring_percent: half,
    gas_exponent: positive(2),
    for: fc.subarray([...read_outs]),
  },
);
const loads = record<Loads>(
  {},
  {
    gravity: fc.oneof(fc.constant(null), fc.record({direction_deg: number(), acceleration: half})),
    body: fc.record({mass: half, center: point}),
    links,
    extra: fc.array(extra, {maxLength: 3}),
    handle: fc.record({
      point,
      direction: fc.oneof(
        fc.constantFrom("tangential" as const, "vertical" as const),
        fc.record({fixed_deg: number()}),
      ),
    }),
    springs: fc.array(fc.oneof(gas, coil, torsion) as fc.Arbitrary<Spring>, {maxLength: 4}),
    pins: fc.record({radius: half, friction: half}),
    drive: fc.oneof(
      fc.constantFrom("hand" as const, "input" as const, "output" as const),
      fc.record({cylinder: fc.record({from: stud, to: stud})}),
    ),
    rpm: fc.oneof(fc.constant(null), number()),
    motion: fc.oneof(
      fc.record({law: fc.constantFrom(...driver_laws), duration_s: positive()}),
      fc.record({table: fc.array(point, {maxLength: 4})}),
    ),
    cases: fc.array(load_case, {maxLength: 4}),
    stations: fc.integer({min: 2, max: 200}),
  },
);
export const arbitrary_block = {loads};
