// For tests.
import fc from "fast-check";
import {number, point, record} from "../../state/arbitrary_values";
import {case_names, type Contact, type StraightLineTask} from "./task";

const contact = record<Contact>(
  {s: number(), multiplicity: fc.integer({min: 1, max: 4})},
  {side: fc.constantFrom(-1, 1)},
);

export const arbitrary_task = record<StraightLineTask>(
  {
    kind: fc.constant("straight_line"),
    mechanism: fc.constant("four_bar"),
    case: fc.constantFrom(...case_names),
    line: fc.record({point, direction_deg: number()}),
  },
  {
    ground_pivots: fc.record({input: point, output: point}),
    input_pivot: point,
    contacts: fc.array(contact, {maxLength: 4}),
    pole_distance: number(),
    point_ray_deg: number(),
    cubic_n: fc.oneof(fc.constant(null), number()),
    half_frame: number(),
    output_arm: number(),
    input_offset: number(),
    output_offset: number(),
    coupler_angle_deg: number(),
    stroke: number(),
    deviation: number(),
    crank_range_deg: fc.oneof(fc.constant(null), number()),
  },
);
