import {expect, it} from "vitest";
import {convex_hull} from "./hull";

it("is the outermost corners, counter-clockwise", () => {
  expect(
    convex_hull([
      [1, 1],
      [0, 0],
      [2, 0],
      [2, 2],
      [0, 2],
      [1, 0],
    ]),
  ).toEqual([
    [0, 0],
    [2, 0],
    [2, 2],
    [0, 2],
  ]);
});
