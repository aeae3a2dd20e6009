import {expect, it} from "vitest";
import type {Point} from "../contract/messages";
import {far, is_covered, margins, useful_pivots, view_beside, view_of} from "./fit";
import {shows} from "./viewport";

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

it("shows everything beside what lies over the drawing", () => {
  const cover = {left: 500, top: 10, right: 790, bottom: 160},
    points: Point[] = [...around, [100, 95], [0, 0]],
    room = margins(false, false),
    plain = view_of(points, 800, 600, room);
  expect(points.some((point) => is_covered(plain, point, cover))).toBe(true);
  const view = view_beside(points, plain, room, cover);
  for (const point of points) expect([shows(view, point), is_covered(view, point, cover)]).toEqual([true, false]);
  expect(view_beside(points, plain, room, null)).toBe(plain);
  expect(view_beside(points, plain, room, {...cover, left: 780, top: 10, bottom: 20})).toBe(plain);
});
