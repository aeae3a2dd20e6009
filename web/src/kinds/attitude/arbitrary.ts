// For tests.
import fc, {type Arbitrary} from "fast-check";
import {sequences, type Orientation, type Quaternion} from "../../orientation/orientation";
import {identity, type Vec3} from "../../sphere/vectors";
import {number} from "../../state/arbitrary_values";
import type {AttitudeTask} from "./task";

const vector: Arbitrary<Vec3> = fc.tuple(number(), number(), number());
const sequence = fc.constantFrom(...sequences);
const orientation: Arbitrary<Orientation> = fc.oneof(
  fc.record({quaternion: fc.tuple(number(), number(), number(), number()) as Arbitrary<Quaternion>}),
  fc.record({axis: vector, angle_deg: number()}),
  fc.record({rotation_vector: vector}),
  fc.record({matrix: fc.constant(identity)}),
  fc.record({euler_deg: vector, sequence}),
  fc.record({euler_deg: vector, sequence, turning: fc.constant("extrinsic" as const)}),
);
export const arbitrary_task: Arbitrary<AttitudeTask> = fc.record({
  kind: fc.constant("attitude"),
  mechanism: fc.constant("body"),
  orientation,
  sequence,
  turning: fc.constantFrom("intrinsic", "extrinsic"),
  vector,
  from: fc.record({orientation, translation: vector}),
  translation: vector,
  rates_deg: vector,
});
