import {expect, it} from "vitest";
import type {Box} from "../../contract/messages";
import {nudged_box} from "./box_drags";

it("arrow keys move a box or an edge of it, never one edge past the other", () => {
  const box: Box = {x: [0, 10], y: [0, 5]};
  expect(nudged_box(box, {x: 0, y: 0}, 20, 0)).toEqual({x: [20, 30], y: [0, 5]});
  expect(nudged_box(box, {x: -1, y: 0}, 8, 0)).toEqual({x: [8, 10], y: [0, 5]});
  expect(nudged_box(box, {x: -1, y: 0}, 10, 0)).toBeNull();
  expect(nudged_box(box, {x: -1, y: 0}, 20, 0)).toBeNull();
  expect(nudged_box(box, {x: 1, y: 1}, 0, -20)).toBeNull();
});
