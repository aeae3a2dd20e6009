import {expect, it} from "vitest";
import type {Point} from "../engine/protocol";
import {far, useful_pivots} from "./fit";

const around: Point[] = [
  [0, 0],
  [100, 100],
];
const pivots: Point[] = [
  [-500, 0],
  [1e5, 0],
  [20, 20],
];

it("shows all of a linkage when one asks for it, but for what lies out of the world", () => {
  expect(useful_pivots(pivots, around)).toEqual([[20, 20]]);
  expect(useful_pivots(pivots, around, far)).toEqual([
    [-500, 0],
    [20, 20],
  ]);
});
