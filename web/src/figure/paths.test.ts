import {expect, it} from "vitest";
import {fitting} from "./paths";

it("points are fitted into a picture, and nothing has no numbers that are none", () => {
  const at = fitting(
    [
      [0, 0],
      [10, 5],
    ],
    120,
    100,
    10,
  );
  expect([at([0, 0]), at([10, 5])]).toEqual([
    [10, 75],
    [110, 25],
  ]);
  expect(fitting([], 120, 100, 10)([3, 4])).toEqual([60, 50]);
});
