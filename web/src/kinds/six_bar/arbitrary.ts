// For tests.
import fc from "fast-check";
import {point, poses, record} from "../../state/arbitrary_values";
import type {SixBarTask} from "./task";

const chain = fc.record(
  {a: point, b: point, d: point, elbow: fc.array(fc.constantFrom(-1, 1), {minLength: 4, maxLength: 4})},
  {requiredKeys: ["a", "b", "d"]},
);
export const arbitrary_task = record<SixBarTask>(
  {
    kind: fc.constant("motion"),
    mechanism: fc.constant("six_bar"),
    poses,
    added: fc.constantFrom(["0-2", "0-3"] as const, ["1-3", "0-2"] as const),
  },
  {chain},
);
