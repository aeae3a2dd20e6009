import {expect, it} from "vitest";
import type {Linkage} from "../../contract/messages";
import {driver_angle, error_at, error_plot} from "./error_plot";
import {plot_csv} from "../../transport/plot";

const made = {
  pairs: [
    [10, 5, 0],
    [30, 20, 0],
    [50, 40, null],
  ],
  precision_error_deg: 0,
  reaches_pairs: false,
  max_structural_error_deg: 2,
  worst_input_deg: 20,
  unreached_deg: [[40, 60]],
  curve: [
    [0, 0, -1],
    [10, 5, 5],
    [20, 12, 14],
    [30, 20, 20],
    [40, 30, null],
  ],
} satisfies Linkage["function"];

it("runs over the driver angle, whichever way the driver turns", () => {
  const ccw = {function: made, drive_sense: "ccw"} as const,
    cw = {function: made, drive_sense: "cw"} as const;
  expect(error_plot(ccw)).toMatchObject({angles: [-10, 0, 10, 20, 30], values: [[-1, 0, 2, 0, null]], x: [-10, 30]});
  expect(error_plot(ccw)!.dots.map((dot) => [dot.angle, dot.values[0]])).toEqual([
    [0, 0],
    [20, 0],
    [40, null],
  ]);
  expect(error_plot(cw)).toMatchObject({angles: [-30, -20, -10, 0, 10], values: [[null, 0, 2, 0, -1]]});
  expect(driver_angle(cw, 10)).toBe(0);
  expect(plot_csv(error_plot(ccw)!)).toBe("input_deg,error_deg\n-10,-1\n0,0\n10,2\n20,0\n30,\n");
});
it("is known between its samples, and nowhere else", () => {
  const generator = {function: made, drive_sense: "either"} as const;
  expect(error_at(generator, 5)).toBe(1);
  expect(error_at(generator, 25)).toBeNull();
  expect(error_at(generator, -11)).toBeNull();
  expect(error_at({...generator, function: {...made, curve: []}}, 0)).toBeNull();
});
