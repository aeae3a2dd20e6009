import {expect, it} from "vitest";
import {bar_angle, bar_knots, bar_place, keyed_angle, snapped_angle} from "./bar";
import {stops_of} from "./play";
import {rows_at, sample_drive} from "./sample_drive";

const drive = sample_drive(rows_at([-100, 0, 10, 30, 60, 200]), [1, 2, 3, 4]);
const knots = bar_knots(drive);

it("gives the task three fifths of a long travel", () => {
  expect(bar_place(knots, 60) - bar_place(knots, 0)).toBeCloseTo(0.6);
  expect(bar_place(knots, -100)).toBe(0);
  expect(bar_place(knots, 200)).toBe(1);
});
it("is even where the task is nearly all", () => {
  expect(bar_place(bar_knots(sample_drive(rows_at([-10, 0, 50, 80, 90]), [1, 2, 2, 3])), 40)).toBeCloseTo(0.5);
  expect(bar_place(bar_knots(sample_drive(rows_at([0, 50, 100]), [0, 1, 1, 2])), 25)).toBeCloseTo(0.25);
});
it("goes there and back", () => {
  for (const angle of [-100, -30, 0, 25, 60, 199]) expect(bar_angle(knots, bar_place(knots, angle))).toBeCloseTo(angle);
});
it("snaps to a position within six pixels", () => {
  const at = bar_place(knots, 30);
  expect(snapped_angle(knots, stops_of(drive), at + 5 / 400, 400)).toBe(30);
  expect(snapped_angle(knots, stops_of(drive), at + 7 / 400, 400)).not.toBe(30);
});
it("moves by keys", () => {
  expect(keyed_angle(drive, 12, "ArrowRight", false)).toBe(13);
  expect(keyed_angle(drive, 12, "ArrowRight", true)).toBe(30);
  expect(keyed_angle(drive, 12, "ArrowLeft", true)).toBe(10);
  expect(keyed_angle(drive, 60, "ArrowRight", true)).toBe(200);
  expect(keyed_angle(drive, 12, "End", false)).toBe(200);
  expect(keyed_angle(drive, 12, "x", false)).toBeNull();
});
