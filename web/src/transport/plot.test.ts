import {expect, it} from "vitest";
import {dial_splits, nearest_on_path, plot_csv, plot_of, round_between} from "./plot";
import {sample_drive} from "./sample_drive";

const drive = sample_drive(
  [-30, 0, 10, 20, 30, 90].map((input_deg, i) => ({
    input_deg,
    transmission_angle_deg: 40 + i,
    x: 10 * i,
    y: i * i,
    velocity_ratio: i === 2 ? 0 : i,
  })),
  [1, 2, 3, 4],
);

it("shows the task, and the travel on request", () => {
  const plot = plot_of(drive, "transmission", false);
  expect(plot.angles).toEqual([0, 10, 20, 30]);
  expect(plot.values).toEqual([[41, 42, 43, 44]]);
  expect(plot.y).toEqual([0, 90]);
  expect(plot.dots.map((d) => [d.pose, d.angle, d.values[0]])).toEqual([
    [0, 0, 41],
    [1, 10, 42],
    [2, 20, 43],
    [3, 30, 44],
  ]);
  expect(plot_of(drive, "transmission", true).angles).toEqual([-30, 0, 10, 20, 30, 90]);
});
it("leaves a gap at a dead point", () => {
  expect(plot_of(drive, "velocity", false).values[0]).toEqual([1, null, 3, 4]);
});
it("writes what is shown as CSV", () => {
  expect(plot_csv(plot_of(drive, "velocity", false))).toBe("input_deg,velocity_ratio\n0,1\n10,\n20,3\n30,4\n");
  expect(plot_csv(plot_of(drive, "path", false))).toBe("input_deg,x,y\n0,10,1\n10,20,4\n20,30,9\n30,40,16\n");
});
it("finds the path under the pointer", () => {
  expect(nearest_on_path(plot_of(drive, "path", false), 31, 8)).toBe(20);
});
it("stands at round angles of the task's dial, whichever way that runs", () => {
  expect(round_between(-3, 21, 4)).toEqual([0, 10, 20]);
  expect(dial_splits({zero_deg: 2.5, sense: 1}, -2.5, 60, 4)).toEqual([-2.5, 17.5, 37.5, 57.5]); // 0°, 20°, 40°, 60°
  expect(dial_splits({zero_deg: 2.5, sense: -1}, -20, 2.5, 3)).toEqual([-17.5, -7.5, 2.5]); // 20°, 10°, 0°
});
it("gives a path the room of both axes", () => {
  const plot = plot_of(drive, "path", false);
  expect(plot.x[0]).toBeCloseTo(10 - 0.08 * 30);
  expect(plot.y[1]).toBeCloseTo(16 + 0.08 * 15);
});
