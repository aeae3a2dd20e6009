import {expect, it} from "vitest";
import {gravity_in, hand_direction, weights_of} from "./arrows";
import {all} from "./example";
import {frames_of} from "./places";

const rounded = (point: readonly number[] | null) => point?.map((value) => Number(value.toFixed(6)) + 0);
const level = {name: "room"},
  frames = frames_of(null, {x: 100, y: 0, theta_deg: 90});

it("gravity is turned clockwise by a ground that rises to the right", () => {
  expect(rounded(gravity_in({}, level))).toEqual([0, -9.81]);
  expect(rounded(gravity_in({}, {...level, slope_deg: 90}))).toEqual([-9.81, 0]);
  expect(gravity_in({gravity: null}, level)).toEqual([0, 0]);
});
it("loads act in the cases that name them, or always", () => {
  const of = (extra: string[]) => weights_of({...all, gravity: {}}, {...level, extra}, frames);
  expect(of([]).map(({kind, at, force}) => [kind, rounded(at), rounded(force)])).toEqual([
    ["weight", [-20, 40], [0, -235.44]],
    ["force", [90, 0], [0, 5]], // it turns with the body
  ]);
  expect(of(["snow", "wind"])).toHaveLength(4);
  expect(weights_of({...all, gravity: null, extra: []}, level, frames)).toEqual([]);
});
it("a hand pulls as its point moves, against gravity or at an angle", () => {
  const direction = (direction: "tangential" | "vertical" | {fixed_deg: number}) =>
    rounded(hand_direction({handle: {point: [0, 0], direction}}, level, [3, 4]));
  expect(direction("tangential")).toEqual([0.6, 0.8]);
  expect(direction("vertical")).toEqual([0, 1]);
  expect(direction({fixed_deg: 180})).toEqual([-1, 0]);
  expect(hand_direction({}, level, [0, 0])).toBeNull();
});
