import {describe, expect, it} from "vitest";
import type {Drive, Linkage, Point} from "../contract/messages";
import {four_bar, plate_orders} from "../figure/four_bar";
import {sample_drive} from "../transport/sample_drive";
import {crossings, moments_of, plan_layers, point_distance, segment_distance} from "./layers";

const longest = 100;
const linkage = {
  input: {center: [0, 0], circle: [0, 50], center_homogeneous: [1, 0, 0], circle_homogeneous: [1, 0, 50]},
  output: {center: [100, 0], circle: [100, 50], center_homogeneous: [1, 100, 0], circle_homogeneous: [1, 100, 50]},
} as unknown as Linkage;
/** All links over each other and over both ground pivots. */
const flat: [Point, Point] = [
  [105, 1],
  [-5, 2],
];
/** Rows with the moving pivots given outright. */
function drive_through(pivots: [number, Point, Point][], ticks = [0, pivots.length - 1]) {
  return sample_drive(
    pivots.map(([input_deg, a, b]) => ({input_deg, ax: a[0], ay: a[1], bx: b[0], by: b[1]})),
    ticks,
  );
}
const plan_of = (drive: Drive) => plan_layers(four_bar, linkage, drive, plate_orders, longest)!;
const moments = (drive: Drive) => moments_of(four_bar, linkage, drive);

describe("distances", () => {
  it("of a point from a segment", () => {
    expect(
      point_distance(
        [
          [0, 0],
          [10, 0],
        ],
        [5, 3],
      ),
    ).toBe(3);
    expect(
      point_distance(
        [
          [0, 0],
          [10, 0],
        ],
        [13, 4],
      ),
    ).toBe(5);
    expect(
      point_distance(
        [
          [2, 2],
          [2, 2],
        ],
        [5, 6],
      ),
    ).toBe(5);
  });
  it("of segments, zero where they cross", () => {
    expect(
      segment_distance(
        [
          [0, 0],
          [10, 10],
        ],
        [
          [0, 10],
          [10, 0],
        ],
      ),
    ).toBe(0);
    expect(
      segment_distance(
        [
          [0, 0],
          [10, 0],
        ],
        [
          [0, 4],
          [10, 4],
        ],
      ),
    ).toBe(4);
    expect(
      segment_distance(
        [
          [0, 0],
          [10, 0],
        ],
        [
          [13, 4],
          [20, 4],
        ],
      ),
    ).toBe(5);
  });
});

describe("a plan", () => {
  it("puts both grounded links on one layer where they stay apart", () => {
    const plan = plan_of(
      drive_through([
        [0, [0, 50], [100, 50]],
        [20, [-10, 49], [90, 49]],
      ]),
    );
    expect(plan).toEqual({order: {input: 1, coupler: 2, output: 1}, over: "travel", crossings: []});
  });
  it("lifts the output where the grounded links cross", () => {
    const plan = plan_of(
      drive_through([
        [0, [0, 50], [100, 50]],
        [40, [70, 60], [30, 60]],
      ]),
    );
    expect(plan.order).toEqual({input: 1, coupler: 2, output: 3});
    expect(plan.crossings).toEqual([]);
  });
  it("puts the coupler on top where it sweeps over the ground pins", () => {
    // The coupler passes over the output's ground pivot while the grounded links cross.
    const plan = plan_of(
      drive_through([
        [0, [40, 30], [100, 60]],
        [30, [60, -30], [140, 30]],
      ]),
    );
    expect(crossings(plate_orders[1]!, moments(drive_through([[30, [60, -30], [140, 30]]])), longest)).toEqual([
      {link: "coupler", obstacle: "output_ground_pin", from_deg: 30, to_deg: 30},
    ]);
    expect(plan.crossings).toEqual([]);
  });
  it("holds for the task where nothing lasts the whole travel", () => {
    const rows: [number, Point, Point][] = [
      [-40, [40, 40], [60, 45]],
      [-30, ...flat],
      [0, [0, 50], [100, 50]],
      [20, [-10, 49], [90, 49]],
    ];
    const plan = plan_of(drive_through(rows, [2, 3]));
    expect(plan.over).toBe("task");
    expect(plan.order).toEqual({input: 1, coupler: 2, output: 1});
    expect(plan.crossings).toEqual([]);
  });
  it("says where they cross when no order is free of collisions", () => {
    const rows: [number, Point, Point][] = [
      [0, [0, 50], [100, 50]],
      [31, ...flat],
      [44, ...flat],
      [60, [0, 50], [100, 50]],
    ];
    const plan = plan_of(drive_through(rows));
    expect(plan.crossings.length).toBeGreaterThan(0);
    expect(plan.crossings.every((c) => c.from_deg === 31 && c.to_deg === 44)).toBe(true);
  });
});

describe("crossings", () => {
  it("come with the angles between which they last", () => {
    const apart: [Point, Point] = [
        [0, 50],
        [100, 50],
      ],
      across: [Point, Point] = [
        [70, 60],
        [30, 60],
      ];
    const states = moments(
      drive_through([
        [0, ...apart],
        [10, ...across],
        [20, ...across],
        [30, ...apart],
        [40, ...across],
      ]),
    );
    expect(crossings(plate_orders[0]!, states, longest)).toEqual([
      {link: "input", obstacle: "output", from_deg: 10, to_deg: 20},
      {link: "input", obstacle: "output", from_deg: 40, to_deg: 40},
    ]);
  });
  it("count the pins that reach through a layer", () => {
    const states = moments(drive_through([[5, [60, 40], [140, -40]]]));
    expect(crossings({input: 1, coupler: 2, output: 3}, states, longest)).toEqual([
      {link: "coupler", obstacle: "output_ground_pin", from_deg: 5, to_deg: 5},
    ]);
    expect(crossings({input: 3, coupler: 2, output: 1}, states, longest)).toEqual([]);
  });
});
