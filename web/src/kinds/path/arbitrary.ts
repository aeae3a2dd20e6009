// For tests.
import fc from "fast-check";
import {number, record} from "../../state/arbitrary_values";
import type {PathPoint, PathRate, PathTask} from "./task";

const rate = record<PathRate>({x: number(), y: number()}, {input: number()});
const path_point = record<PathPoint>(
  {x: number(), y: number(), input_deg: number()},
  {derivatives: fc.array(rate, {minLength: 1, maxLength: 4})},
);
export const arbitrary_task = record<PathTask>(
  {
    kind: fc.constant("path" as const),
    mechanism: fc.constant("four_bar" as const),
    points: fc.array(path_point, {maxLength: 12}),
  },
  {},
);
export const arbitrary_requirements = {full_turn: fc.boolean()};
