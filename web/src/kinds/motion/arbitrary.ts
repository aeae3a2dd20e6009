// For tests.
import fc, {type Arbitrary} from "fast-check";
import {number, point, poses, positive, record} from "../../state/arbitrary_values";
import type {Given, MotionTask, PivotOnLine} from "./task";

const line = fc.record({point, direction_deg: number()});
const pivot_on = fc.array(
  fc.record({which: fc.constantFrom("input", "output"), pivot: fc.constantFrom("ground", "moving"), line}),
  {minLength: 1, maxLength: 2},
) as Arbitrary<PivotOnLine[]>;
const given: Arbitrary<Given> = fc.oneof(
  fc.record({side_lengths: fc.tuple(positive(), positive())}),
  fc.record({side_length: positive()}),
  fc.record(
    {side_angle_deg: number(), directed: fc.boolean(), input_length: positive()},
    {requiredKeys: ["side_angle_deg"]},
  ),
  fc.record({instant_center: point}),
  fc.record({instant_center: point, at_infinity: fc.constant(true)}),
  fc.record({ground_pivots: fc.record({input: point, output: point})}),
  fc.record({moving_pivots: fc.record({input: point, output: point})}),
  fc.record({input_moving_pivot: point}),
  fc.record({input_ground_pivot: point, output_moving_pivot: point}),
  fc.record({ground_pivot_on: line}),
  fc.record({ground_pivot_on: line, moving_pivot_on: line}),
) as Arbitrary<Given>;
export const arbitrary_task = record<MotionTask>(
  {kind: fc.constant("motion"), mechanism: fc.constant("four_bar"), poses},
  {given, pivot_on, freed_pose: fc.integer({min: 1, max: 5})},
);
