import {describe, expect, it} from "vitest";
import type {Drive, Linkage} from "../../contract/messages";
import {picture_of} from "../../exports/picture";
import {column, dot, length, unit, type Vec3} from "../../sphere/vectors";
import {spherical_four_bar} from "./figure";
import {single_axes, smooth_way, stretches} from "./pictures";
import type {SphericalBars} from "./replies";
import {after, angle_between, arc_frame, rows_of_quaternion, stand_at, stands} from "./space";

const half = Math.SQRT1_2;
const bars: SphericalBars = {
  angles_deg: {ground: 90, input: 90, coupler: 90, output: 90},
  min_link_angle_deg: 90,
  triple_rocker: null,
  input_fixed: [0, 0, 1],
  input_moving: [1, 0, 0],
  output_moving: [0, 1, 0],
  output_fixed: [0, 0, -1],
};
const row = (angle: number, ...numbers: number[]) => [angle, ...Array<number>(12).fill(0), ...numbers];
const drive: Drive = {
  states: Float64Array.from([...row(0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 0), ...row(90, 0, 1, 0, -1, 0, 0, half, 0, 0, half)]),
  width: 23,
  ticks: [
    {position: 1, state: 0, reached: true},
    {position: 2, state: 1, reached: true},
  ],
  full_turn: false,
  limits: {low: null, high: null},
  task: [0, 1],
};
const linkage = {type: "double_crank", spherical: bars, drive} as unknown as Linkage;
const near = (a: Vec3, b: Vec3) => a.forEach((value, k) => expect(value).toBeCloseTo(b[k]!, 9));

describe("a spherical linkage that moves", () => {
  it("stands where its table says, between rows on the ball", () => {
    near(stand_at(bars, drive, 90).input_moving, [0, 1, 0]);
    const between = stand_at(bars, drive, 45);
    expect(length(between.input_moving)).toBeCloseTo(1);
    near(between.input_moving, [half, half, 0]);
    near(column(stand_at(bars, drive, 90).turn, 0), [0, 1, 0]);
  });
  it("carries its coupler and what is on it", () => {
    const {turn, output_moving} = stand_at(bars, drive, 90);
    near(
      column(
        after(turn, [
          [0, 0, 0],
          [1, 0, 0],
          [0, 0, 0],
        ]),
        0,
      ),
      output_moving,
    );
  });
  it("is told row by row to the last", () => {
    expect(stands(linkage, [0, 1])).toHaveLength(2);
    expect(stands(linkage, [0, 1], 5)).toHaveLength(2);
    expect(stands({} as Linkage, [0, 1])).toEqual([]);
  });
  it("is drawn flat with arcs for links", () => {
    const figure = spherical_four_bar.figure(linkage, spherical_four_bar.still(linkage, [], 0));
    expect(figure.bodies.map(({role}) => role)).toEqual(["coupler", "input", "output"]);
    for (const {along, corners} of figure.bodies) expect(along![0]).toEqual(corners[0]);
    expect(spherical_four_bar.ghost({input_fixed: [0, 0, 1]}, [], 0).bodies).toEqual([]);
    expect(
      spherical_four_bar.sketch([
        [1, 2],
        [1, 2],
        [1, 2],
        [1, 2],
      ]).bodies,
    ).toEqual([]);
  });
});

describe("arcs", () => {
  it("have a frame whose y leads from the beginning to the end", () => {
    const from = unit([1, 2, 3]),
      to = unit([-1, 2, 0.5]),
      frame = arc_frame(from, to);
    near(column(frame, 0), from);
    expect(dot(column(frame, 1), to)).toBeGreaterThan(0);
    expect(dot(column(frame, 2), to)).toBeCloseTo(0);
  });
  it("are as long as the angle between their ends", () => {
    expect(angle_between([1, 0, 0], [-1, 0, 0])).toBeCloseTo(Math.PI);
  });
  it("turn as quaternions of any length say", () => {
    near(column(rows_of_quaternion([2, 0, 0, 2]), 0), [0, 1, 0]);
  });
});

describe("an animation", () => {
  it("shows the whole ball, and the linkage on it", () => {
    const [width, height] = [640, 480],
      near_x = [...unit([1, 0, 0.3]), ...unit([1, 0.3, 0.3]), 1, 0, 0, 0],
      small = {
        ...linkage,
        spherical: {...bars, input_fixed: [1, 0, 0], output_fixed: unit([1, 0.3, 0])},
        drive: {...drive, states: Float64Array.from([...row(0, ...near_x), ...row(90, ...near_x)])},
      } as unknown as Linkage,
      subject = {linkage: small, mechanism: spherical_four_bar, outline: [], poses: []},
      {figure_at, at} = picture_of(subject, true, width, height, {} as never)!;
    const {backdrop = [], joints} = figure_at(45);
    expect(joints).toHaveLength(4);
    for (const [x, y] of [...backdrop.flat(), ...joints.map((joint) => joint.at)].map(at)) {
      expect(x).toBeGreaterThan(0);
      expect(x).toBeLessThan(width);
      expect(y).toBeGreaterThan(0);
      expect(y).toBeLessThan(height);
    }
  });
});

describe("curves of axes", () => {
  it("are closed branch by branch, twice: an axis has two ends", () => {
    const points = Float64Array.from([1, 0, 0, 0, 1, 0, 0, 0, 1, -1, 0, 0, 0, 1, 0]),
      branch = Uint8Array.from([0, 0, 0, 1, 1]);
    const ends = stretches(points, branch);
    expect(ends).toHaveLength(4 * (3 + 2));
    for (let k = 0; k < ends.length; k += 2) expect(dot(ends[k]!, ends[k + 1]!)).toBeGreaterThanOrEqual(0);
    expect(stretches(points, branch, (i) => i < 2)).toHaveLength(4);
  });
  it("are points where a branch is one axis, again twice", () => {
    const points = Float64Array.from([1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0]),
      branch = Uint8Array.from([0, 0, 1, 1, 2]);
    const ends = single_axes(points, branch);
    expect(ends).toHaveLength(4);
    near(ends[0]!, [1, 0, 0]);
    near(ends[2]!, [0, 1, 0]);
    near(ends[3]!, [0, -1, 0]);
  });
});

describe("the way of a point over rows", () => {
  it("has few places where it goes evenly, and more where it is fast", () => {
    const at = (angle: number): [number, number, number] => [Math.cos(angle), Math.sin(angle), 0],
      even = smooth_way((row) => at(row / 200), 0, 80),
      fast = smooth_way((row) => at(row < 40 ? row / 200 : 0.2 + (row - 40) / 20), 0, 80);
    expect(even.length).toBeLessThan(20);
    expect(fast.length).toBeGreaterThan(2 * even.length);
    fast.slice(1).forEach((place, k) => expect(angle_between(fast[k]!, place)).toBeLessThan(0.1));
    near(fast.at(-1)!, at(2.2));
  });
});
