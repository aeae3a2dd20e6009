import {describe, expect, it} from "vitest";
import {cut, multiple, no_keys, snapped_angle, snapped_point, wrapped_deg, type Grid} from "./snapping";

const grid: Grid = {step: 5, xs: [-125, 0], ys: [75, 0], near: 3, on: true};
const shift = {...no_keys, shift: true},
  alt = {...no_keys, alt: true},
  fine = {...no_keys, fine: true};

describe("points", () => {
  it("go to the grid", () => {
    expect(snapped_point([0, 0], [-218.9, 222], grid, no_keys, 0.5).point).toEqual([-220, 220]);
  });
  it("align with other poses before the grid, and say so", () => {
    const {point, guides} = snapped_point([0, 0], [-127.4, 222], {...grid, xs: [-126.5]}, no_keys, 0.5);
    expect(point).toEqual([-126.5, 220]);
    expect(guides).toEqual([{axis: "x", value: -126.5}]);
  });
  it("keep one coordinate with Shift", () => {
    expect(snapped_point([1.23, 4.56], [31, 9], grid, shift, 0.5).point).toEqual([30, 4.56]);
    expect(snapped_point([1.23, 4.56], [3, 49], grid, shift, 0.5).point).toEqual([1.23, 50]);
  });
  it("are free with Alt, and when snapping is off", () => {
    const raw = [-218.91234, 222.34567] as const;
    const {point} = snapped_point([0, 0], raw, grid, alt, 0.5);
    expect(Math.abs(point[0] - raw[0])).toBeLessThan(0.01);
    expect(point[0] % 5).not.toBe(0);
    expect(snapped_point([0, 0], raw, {...grid, on: false}, no_keys, 0.5).point).toEqual(point);
  });
  it("go to a tenth of the grid with Ctrl", () => {
    expect(snapped_point([0, 0], [10.72, 0.2], {...grid, xs: [], ys: []}, fine, 0.5).point).toEqual([10.5, 0]);
  });
});

describe("angles", () => {
  it("are whole degrees, multiples of 15 with Shift, free with Alt", () => {
    expect(snapped_angle(-52.3, [], 1, true, no_keys).angle).toBe(-52);
    expect(snapped_angle(-52.3, [], 1, true, shift).angle).toBe(-45);
    expect(snapped_angle(-52.3456, [], 1, true, alt).angle).toBe(-52.346);
    expect(snapped_angle(-52.34, [], 1, true, fine).angle).toBe(-52.3);
    expect(snapped_angle(-24.6, [-24.5], 1, true, no_keys)).toEqual({angle: -24.5, aligned: true});
  });
  it("stay within half a turn", () => {
    expect([190, -190, 180, -180, 540, 0].map(wrapped_deg)).toEqual([-170, 170, 180, 180, 180, 0]);
  });
});

it("multiples carry no dust", () => {
  expect(multiple(0.30000001, 0.1)).toBe(0.3);
  expect(Object.is(multiple(-0.1, 5), 0)).toBe(true);
  expect(cut(1.23456, 0.5)).toBe(1.23);
});
