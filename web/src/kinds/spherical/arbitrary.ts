// For tests.
import fc, {type Arbitrary} from "fast-check";
import {sequences, type Quaternion} from "../../orientation/orientation";
import {identity, type Vec3} from "../../sphere/vectors";
import {number, record} from "../../state/arbitrary_values";
import type {Cone} from "./replies";
import type {PrescribedOrientation, Rates, SphericalTask} from "./task";

const vector: Arbitrary<Vec3> = fc.tuple(number(), number(), number());
const two = fc.tuple(vector, vector);
const orientation = fc.oneof(
  fc.record({quaternion: fc.tuple(number(), number(), number(), number()) as Arbitrary<Quaternion>}),
  fc.record({axis: vector, angle_deg: number()}),
  fc.record({rotation_vector: vector}),
  fc.record({matrix: fc.constant(identity)}),
  fc.record({euler_deg: vector, sequence: fc.constantFrom(...sequences)}),
);
const rates: Arbitrary<Rates> = fc.oneof(
  fc.constant({}),
  fc.record({angular_velocity: vector}),
  fc.record({angular_velocity: vector, angular_acceleration: vector}),
);
const prescribed = fc.tuple(orientation, rates).map(([one, more]): PrescribedOrientation => ({...one, ...more}));
export const arbitrary_task = record<SphericalTask>(
  {
    kind: fc.constant("motion"),
    mechanism: fc.constant("spherical_four_bar"),
    orientations: fc.array(prescribed, {maxLength: 5}),
  },
  {given: fc.oneof(fc.record({fixed_axes: two}), fc.record({moving_axes: two}))},
);
const cone: Arbitrary<Cone> = fc.record({axis: vector, half_angle_deg: fc.double({min: 1e-9, max: 90, noNaN: true})});
export const arbitrary_requirements = {fixed_axes_within: cone, moving_axes_within: cone};
