import {expect, it} from "vitest";
import type {Linkage, Point} from "../engine/protocol";
import {far, useful_pivots} from "./fit";

const around: Point[] = [
  [0, 0],
  [100, 100],
];
const linkage = {
  input: {center: [-500, 0], circle: [20, 20]},
  output: {center: [1e5, 0], circle: null},
  drive: null,
} as unknown as Linkage;

it("shows all of a linkage when one asks for it, but for what lies out of the world", () => {
  expect(useful_pivots(linkage, around, [])).toEqual([[20, 20]]);
  expect(useful_pivots(linkage, around, [], far)).toEqual([
    [-500, 0],
    [20, 20],
  ]);
});
