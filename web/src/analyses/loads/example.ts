// Loads for the tests of this folder.
import type {CarriedPoint, Loads} from "./block";

export const stud = (on: CarriedPoint["on"], x: number, y: number): CarriedPoint => ({on, at: [x, y]});
export const strut = {
  kind: "gas" as const,
  name: "strut",
  count: 2,
  from: stud("ground", 150, 115),
  to: stud("body", 60, 298),
  extended_length: 325,
  stroke: 128,
  measured_at: 5,
  F1: 375,
  F2: 500,
  F3: 425,
  F4: 560,
  rod_diameter: 8,
};
/** Something of everything. */
export const all: Loads = {
  gravity: {direction_deg: -80, acceleration: 9.8},
  body: {mass: 24, center: [40, 120], inertia: 1},
  links: {input: {kg_per_m: 1.2}, output: {mass: 0.5, center: [60, 4]}},
  extra: [
    {name: "snow", on: "body", at: [70, 200], mass: 3},
    {name: "cable", on: "body", at: [0, 10], force: [5, 0], frame: "body", always: true},
    {name: "wind", on: "body", at: [0, 10], force: [10, 0]},
  ],
  handle: {point: [-5, -70], direction: {fixed_deg: 135}},
  springs: [
    {...strut, percent_per_10K: null},
    {kind: "coil", from: stud("ground", 0, 0), to: stud("body", 0, 9), rate: 2, free_length: 100, acts: "tension"},
    {kind: "torsion", joint: "input_ground", rate_per_deg: -0.1, torque_at_position_1: 3},
  ],
  pins: {radius: 6, friction: 0.15},
  drive: {cylinder: {from: stud("ground", 1, 2), to: stud("body", 3, 4)}},
  rpm: null,
  motion: {law: "trapezoid", duration_s: 2.5, ramp: 0.2},
  cases: [
    {name: "room"},
    {
      name: "cold",
      temperature_C: -30,
      slope_deg: 6,
      extra: ["snow"],
      spring_percent: 90,
      gas_exponent: 1.2,
      for: ["hold_open"],
    },
  ],
  stations: 13,
};
/** What the tailgate carries, in two cases. */
export const struts: Loads = {
  body: {mass: 24, center: [40, 120]},
  links: {input: {kg_per_m: 1.2}, output: {kg_per_m: 1.5}},
  extra: all.extra!.slice(0, 1),
  handle: {point: [-5, -70], direction: "tangential"},
  springs: [strut],
  pins: all.pins,
  cases: [{name: "room"}, {name: "cold", temperature_C: -30}],
};
