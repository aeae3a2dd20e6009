// For tests.
import fc, {type Arbitrary} from "fast-check";
import {number, point, poses, positive, record} from "../../state/arbitrary_values";
import type {Given, MotionTask} from "./task";

const given: Arbitrary<Given> = fc.oneof(
  fc.record({side_lengths: fc.tuple(positive(), positive())}),
  fc.record({side_length: positive()}),
  fc.record(
    {side_angle_deg: number(), directed: fc.boolean(), input_length: positive()},
    {requiredKeys: ["side_angle_deg"]},
  ),
  fc.record({instant_center: point}),
  fc.record({instant_center: point, at_infinity: fc.constant(true)}),
) as Arbitrary<Given>;
export const arbitrary_task = record<MotionTask>(
  {kind: fc.constant("motion"), mechanism: fc.constant("four_bar"), poses},
  {given, freed_pose: fc.integer({min: 1, max: 5})},
);
