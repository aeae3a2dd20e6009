import {describe, expect, it} from "vitest";
import {incompleteness, kind_of, lengths_of, joints_of, read_task} from "../kind_dispatch";
import type {Linkage} from "../../contract/messages";
import {is_cone} from "./kind";
import {with_next_rate, with_orientations, without_rate, type PrescribedOrientation, type SphericalTask} from "./task";

const euler = {euler_deg: [10, 20, 30], sequence: "zyx"} as const,
  turn = {axis: [0, 0, 1], angle_deg: 40} as const,
  quaternion = {quaternion: [1, 0, 0, 0]} as const,
  matrix = {
    matrix: [
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ],
  } as const;
const task = (orientations: readonly object[], more: object = {}): SphericalTask =>
  ({kind: "motion", mechanism: "spherical_four_bar", orientations, ...more}) as SphericalTask;
const state = (of: SphericalTask) => incompleteness({linkwright: 1, task: of})?.state ?? null;

describe("orientations", () => {
  it("are read in the form in which they were typed, with their rates", () => {
    const mixed = task([euler, {...turn, angular_velocity: [1, 2, 3]}, quaternion, matrix]);
    expect(read_task(JSON.parse(JSON.stringify(mixed)))).toEqual(mixed);
    const skipped = task([{...euler, angular_acceleration: [1, 2, 3]}]);
    expect(read_task(skipped)).toEqual(task([euler]));
    expect(read_task(task([{...euler, ...turn}]))).toBeNull();
    expect(read_task({...mixed, mechanism: "four_bar"})).toBeNull();
  });
  it("are too few, or too many, derivatives counted", () => {
    const moving = {...euler, angular_velocity: [1, 0, 0]};
    expect(state(task([]))).toBe("empty");
    expect(state(task([euler, turn]))).toBe("too_few");
    expect(state(task([euler, turn, quaternion]))).toBe("no_given");
    expect(
      state(
        task([euler, turn, quaternion], {
          given: {
            fixed_axes: [
              [0, 0, 1],
              [1, 0, 0],
            ],
          },
        }),
      ),
    ).toBeNull();
    expect(state(task([moving, turn, quaternion]))).toBeNull();
    expect(state(task([moving, moving, euler, turn]))).toBe("too_many");
    expect(kind_of(task([moving, turn])).pattern(task([moving, turn]))).toBe("PP-P");
  });
  it("lose what is given when they are no longer three", () => {
    const given = task([euler, turn, quaternion], {
      given: {
        moving_axes: [
          [0, 0, 1],
          [1, 0, 0],
        ],
      },
    });
    expect(with_orientations(given, [euler, turn]).given).toBeUndefined();
    expect(with_orientations(given, [turn, euler, quaternion]).given).toEqual(given.given);
  });
  it("get and lose derivatives in order", () => {
    let one: PrescribedOrientation = euler;
    for (const count of [1, 2, 3, 3]) {
      one = with_next_rate(one);
      expect(Object.keys(one)).toHaveLength(2 + count);
    }
    expect(without_rate(one, 1)).toEqual({...euler, angular_velocity: [0, 0, 1]});
    expect(without_rate(one, 0)).toEqual(euler);
  });
});

describe("a spherical linkage", () => {
  const spherical = {
    angles_deg: {ground: 50, input: 20, coupler: 60, output: 40},
    min_link_angle_deg: 20,
    triple_rocker: null,
    input_fixed: [0, 0, 1],
    input_moving: [1, 0, 0],
    output_moving: [0, 1, 0],
    output_fixed: [0, 0, -1],
  };
  it("has angles for lengths, and axes for joints", () => {
    const linkage = {type: "crank_rocker", spherical} as unknown as Linkage;
    expect(lengths_of(linkage)!.map(({key, length}) => [key, length])).toEqual(Object.entries(spherical.angles_deg));
    expect(joints_of(linkage)!.map(({at}) => at)).toEqual([
      [0, 0, 1],
      [1, 0, 0],
      [0, 0, -1],
      [0, 1, 0],
    ]);
  });
  it("is kept by its axes", () => {
    const kept = kind_of(task([euler])).kept_pivots!({spherical} as unknown as Linkage);
    expect(kept).toEqual({
      input_fixed: [0, 0, 1],
      input_moving: [1, 0, 0],
      output_fixed: [0, 0, -1],
      output_moving: [0, 1, 0],
    });
  });
});

it("a cone has an axis and a half angle", () => {
  expect(is_cone({axis: [0, 0, 2], half_angle_deg: 30})).toBe(true);
  for (const wrong of [
    null,
    {axis: [0, 0]},
    {axis: [0, 0, 1], half_angle_deg: 0},
    {axis: [0, 0, 1], half_angle_deg: 91},
  ])
    expect(is_cone(wrong)).toBe(false);
});
