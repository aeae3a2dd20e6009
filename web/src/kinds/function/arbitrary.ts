// For tests.
import fc, {type Arbitrary} from "fast-check";
import {number, point, points, record, text} from "../../state/arbitrary_values";
import type {AnglePair, FreeParameter, FunctionTask, NamedFunction} from "./task";

const range = fc.tuple(number(), number());
const rates = fc.array(fc.record({input: number(), output: number()}), {minLength: 1, maxLength: 4});
const angle_pair = record<AnglePair>({input_deg: number(), output_deg: number()}, {derivatives: rates});
const named = record<NamedFunction>(
  {input_range_deg: range, output_range_deg: range},
  {
    expression: text(200),
    table: points(1, 50),
    interpolation: fc.constantFrom("linear", "monotone_cubic"),
    x: range,
    y: range,
    points: fc.integer({min: 4, max: 5}),
    spacing: fc.oneof(
      fc.constantFrom("chebyshev" as const, "even" as const),
      fc.array(number(), {minLength: 1, maxLength: 5}),
    ),
  },
);
const free = record<FreeParameter>(
  {number: fc.constantFrom("output_scale", "pair_output")},
  {pair: fc.integer({min: 1, max: 4}), range},
);
const function_ends = {ground_pivots: fc.record({input: point, output: point}), free};
const head = {kind: fc.constant("function" as const), mechanism: fc.constant("four_bar" as const)};
export const arbitrary_task: Arbitrary<FunctionTask> = fc.oneof(
  record<FunctionTask>({...head, pairs: fc.array(angle_pair, {maxLength: 12})}, function_ends),
  record<FunctionTask>({...head, function: named}, function_ends),
);
