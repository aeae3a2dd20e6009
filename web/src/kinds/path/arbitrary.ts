// For tests.
import fc, {type Arbitrary} from "fast-check";
import {number, point, record} from "../../state/arbitrary_values";
import type {GroundPivots, PathPoint, PathRate, PathTask} from "./task";

const direction = {x: number(), y: number()};
function points_of(place: Arbitrary<PathPoint>): Arbitrary<PathPoint[]> {
  return fc.array(place, {maxLength: 12});
}
function rates_of(rate: Arbitrary<PathRate>): {derivatives: Arbitrary<PathRate[]>} {
  return {derivatives: fc.array(rate, {minLength: 1, maxLength: 4})};
}
const kind = {kind: fc.constant("path" as const), mechanism: fc.constant("four_bar" as const)};
const timed_point = record<PathPoint>(
  {...direction, input_deg: number()},
  rates_of(record<PathRate>(direction, {input: number()})),
);
const timed_task = record<PathTask>({...kind, points: points_of(timed_point)});
const ground_pivots: Arbitrary<GroundPivots> = fc.oneof(
  fc.record({input: point}),
  fc.record({output: point}),
  fc.record({input: point, output: point}),
);
const untimed_task = record<PathTask>({
  ...kind,
  points: points_of(record<PathPoint>(direction, rates_of(record<PathRate>(direction)))),
  given: fc.record({ground_pivots}),
});
const posed_point = record<PathPoint>(
  {...direction},
  {theta_deg: number(), ...rates_of(record<PathRate>(direction, {theta: number()}))},
);
const posed_task = record<PathTask>({...kind, points: points_of(posed_point)});
const near_task = record<PathTask>(
  {...kind, points: points_of(record<PathPoint>(direction, {tolerance: number(), weight: number()}))},
  {
    closed: fc.boolean(),
    tolerance: number(),
    between: fc.constantFrom("free" as const, "polyline" as const),
    map: fc.constantFrom("curves" as const, "pivots" as const),
  },
);
export const arbitrary_task = fc.oneof(timed_task, untimed_task, posed_task, near_task);
export const arbitrary_requirements = {full_turn: fc.boolean()};
