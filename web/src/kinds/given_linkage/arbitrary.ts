// For tests.
import fc, {type Arbitrary} from "fast-check";
import {number} from "../../state/arbitrary_values";
import type {LinkageTask} from "./task";

const point = fc.tuple(number(), number());
const axis = fc.tuple(number(), number(), number());
const lengths = fc.record({ground: number(), input: number(), coupler: number(), output: number()});

export const arbitrary_task: Arbitrary<LinkageTask> = fc.oneof(
  fc.record({
    kind: fc.constant("linkage" as const),
    mechanism: fc.constant("four_bar" as const),
    file: fc.oneof(
      fc.record({lengths}),
      fc.record({
        pivots: fc.record({input_center: point, input_circle: point, output_center: point, output_circle: point}),
      }),
    ),
  }),
  fc.record({
    kind: fc.constant("linkage" as const),
    mechanism: fc.constant("spherical_four_bar" as const),
    file: fc.record({
      mechanism: fc.constant("spherical_four_bar"),
      axes: fc.record({input_fixed: axis, input_moving: axis, output_moving: axis, output_fixed: axis}),
    }),
  }),
);
