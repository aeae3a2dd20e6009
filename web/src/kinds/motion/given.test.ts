import {describe, expect, it} from "vitest";
import type {Linkage} from "../../contract/messages";
import type {Problem} from "../../state/problem";
import {poses_of} from "../../state/task";
import {properties_of} from "../kind_dispatch";
import {given_lines, given_pivots, lines_of, moved_given, pivots_of, read_lines, read_pivots} from "./pivots";
import type {Given, Line, MotionTask} from "./task";
import {relaxable, relaxed_pose_of, with_relaxed_pose} from "./freed";
import {
  form_of,
  free_parameter_count,
  fresh_given,
  GivenMemory,
  given_forms,
  given_of,
  has_form,
  lengths_of,
  memory_of,
  takes_given,
  takes_lines,
  with_given,
  with_length,
} from "./given";
import {motion_kind, new_problem} from "./kind";
import {with_poses, with_task_poses} from "../kind_dispatch";

const four = new_problem(),
  three = with_poses(four, poses_of(four.task).slice(1));
const {problem: five} = motion_kind.beginnings
  .filter(({id}) => id === "five_positions")
  .map((beginning) => ({problem: beginning.make()}))[0]!;
const floor: Line = {point: [0, -20], direction_deg: 0};
const travel = [{x: 1, y: 0, theta: 0}];

describe("what is given beside three positions", () => {
  it("belongs to three positions, an instant centre to such without a direction of travel", () => {
    expect([three, four, five].map(takes_given)).toEqual([true, false, false]);
    const mixed = with_poses(three, [{...poses_of(three.task)[0]!, derivatives: travel}, poses_of(three.task)[1]!]);
    expect(takes_given(mixed)).toBe(true);
    expect(given_forms.filter((form) => has_form(mixed, form))).toEqual([
      "side_lengths",
      "side_length",
      "side_angle",
      "pivots",
      "pivot_lines",
    ]);
  });
  it("begins in each form with numbers of the task's size, or those of the linkage in hand", () => {
    for (const form of given_forms) {
      const given = fresh_given(form, three, null);
      expect(form_of(given)).toBe(form);
      expect(given_of(with_given(three, given))).toEqual(given);
      for (const length of Object.values(lengths_of(given))) expect(length === null || length > 10).toBe(true);
    }
    const hand = {input: {length: 12.3456}, output: {length: 78.9}} as Linkage;
    expect(fresh_given("side_lengths", three, hand)).toEqual({side_lengths: [12.3, 78.9]});
  });
  it("keeps its numbers to the last digit from two lengths to one and back, whatever the linkage in hand has", () => {
    const memory = new GivenMemory(),
      hand = {input: {length: 12.3456}, output: {length: 313.4}} as Linkage;
    const two = with_given(three, {side_lengths: [200.123456, 320]}),
      one = with_given(three, memory.chosen("side_length", two, hand));
    expect(given_of(one)).toEqual({side_length: 200.123456});
    expect(memory.chosen("side_lengths", one, hand)).toEqual({side_lengths: [200.123456, 320]});
    expect(memory.chosen("side_lengths", with_given(three, {side_length: 210}), hand)).toEqual({
      side_lengths: [210, 320],
    }); // R₁ was changed meanwhile
    expect(new GivenMemory().chosen("side_lengths", one, hand)).toEqual({side_lengths: [200.123456, 313]});
    const angle = with_given(three, memory.chosen("side_angle", one, hand));
    expect(given_of(angle)).toEqual({side_angle_deg: 60, directed: true});
    expect(memory.chosen("side_lengths", angle, hand)).toEqual({side_lengths: [200.123456, 320]});
  });
  it("is remembered as long as the task is open", () => {
    const workbench = {opened: 1},
      memory = memory_of(workbench);
    expect(memory_of(workbench)).toBe(memory);
    workbench.opened = 2;
    expect(memory_of(workbench)).not.toBe(memory);
  });
  it("leaves so many numbers free, and a length that is open can be set", () => {
    const all: [Given, number, Given][] = [
      [{side_lengths: [1, 2]}, 2, {side_lengths: [1, 9]}],
      [{side_length: 1}, 3, {side_lengths: [1, 9]}],
      [{side_angle_deg: 30}, 3, {side_angle_deg: 30}],
      [{side_angle_deg: 30, input_length: 4}, 2, {side_angle_deg: 30, input_length: 4}],
      [{instant_center: [0, 1]}, 2, {instant_center: [0, 1]}],
      [{ground_pivots: {input: [0, 1], output: [2, 3]}}, 0, {side_length: 1}],
      [{input_ground_pivot: [0, 1], output_moving_pivot: [2, 3]}, 0, {side_length: 1}],
      [{output_moving_pivot: [2, 3]}, 2, {side_length: 1}],
      [{ground_pivot_on: floor}, 2, {side_length: 1}],
      [{ground_pivot_on: floor, moving_pivot_on: floor}, 0, {side_length: 1}],
    ];
    for (const [given, free, longer] of all) {
      expect(free_parameter_count(given)).toBe(free);
      if ("output" in lengths_of(given)) expect(with_length(given, "output", 9)).toEqual(longer);
    }
    expect(lengths_of({side_length: 5})).toEqual({input: 5, output: null});
    expect(with_length({side_angle_deg: 30}, "input", 7)).toEqual({side_angle_deg: 30, input_length: 7});
  });
});

describe("given pivots and lines of pivots", () => {
  const both: Given = {moving_pivots: {input: [60, 223], output: [112, 223]}},
    one: Given = {output_ground_pivot: [3, 4]},
    mixed: Given = {input_ground_pivot: [1, 2], output_moving_pivot: [3, 4]},
    lines: Given = {ground_pivot_on: floor, moving_pivot_on: {point: [1, 2], direction_deg: 90}};
  it("are read in each form that files have, and written back", () => {
    for (const given of [both, one, mixed]) {
      expect(read_pivots({...given})).toEqual(given);
      expect(given_pivots(pivots_of(given)!)).toEqual(given);
      expect(lines_of(given)).toBeNull();
      expect(form_of(given)).toBe("pivots");
    }
    expect(
      read_pivots({
        moving_pivots: [
          [60, 223],
          [112, 223],
        ],
      }),
    ).toEqual(both);
    expect(read_pivots({ground_pivots: [[1, 2]]})).toBeNull();
    expect(read_lines({...lines})).toEqual(lines);
    expect(given_lines(lines_of(lines)!)).toEqual(lines);
    expect([pivots_of(lines), form_of(lines)]).toEqual([null, "pivot_lines"]);
  });
  it("move with the drawing, lines with their directions", () => {
    const turned = ([x, y]: readonly [number, number]): [number, number] => [10 - y, x];
    expect(moved_given(mixed, turned)).toEqual({input_ground_pivot: [8, 1], output_moving_pivot: [6, 3]});
    expect(moved_given(lines, turned)).toEqual({
      ground_pivot_on: {point: [30, 0], direction_deg: 90},
      moving_pivot_on: {point: [8, 1], direction_deg: 180},
    });
  });
  it("tell maps apart by what their axes are", () => {
    const maps = [both, one, mixed, {input_ground_pivot: [3, 4]} as Given, lines, {ground_pivot_on: floor}].map(
      (given) => motion_kind.map_of(with_given(three, given).task as MotionTask),
    );
    expect(new Set(maps).size).toBe(maps.length);
  });
  it("belong to three positions, a line for each link to four", () => {
    const pivot_on = [{which: "input", pivot: "ground", line: floor}] as const,
      lined = {...(four.task as MotionTask), pivot_on};
    expect(motion_kind.read({...lined})).toEqual(lined);
    expect(with_task_poses(lined, lined.poses.slice(1))).not.toHaveProperty("pivot_on");
    expect([three, four, five].map(takes_lines)).toEqual([false, true, false]);
  });
});

describe("a freed position", () => {
  it("is one of five, without derivatives, and back again", () => {
    expect(relaxable(four)).toEqual([]);
    expect(relaxable(five)).toEqual([1, 2, 3, 4, 5]);
    const freed = with_relaxed_pose(five, 3);
    expect([relaxed_pose_of(freed), relaxed_pose_of(with_relaxed_pose(freed, null)), relaxed_pose_of(five)]).toEqual([
      3,
      null,
      null,
    ]);
    expect(properties_of(freed)).toContain("pose_miss");
    expect(properties_of(five)).not.toContain("pose_miss");
    expect(motion_kind.stops(freed.task as MotionTask)).toBe(4);
  });
  it("goes with the fifth position", () => {
    const poses = poses_of(five.task),
      freed = with_relaxed_pose(five, 5) as Problem;
    expect(with_task_poses(freed.task, poses.slice(1))).not.toHaveProperty("freed_pose");
    expect(
      with_task_poses(
        freed.task,
        poses.map((p) => ({...p, x: p.x + 1})),
      ),
    ).toHaveProperty("freed_pose", 5);
    const mixed = poses.slice(1).map((p, i) => (i === 3 ? {...p, derivatives: travel} : p));
    expect(relaxable(with_poses(five, mixed))).toEqual([1, 2, 3]);
    expect(with_task_poses({...freed.task, freed_pose: 4} as MotionTask, mixed)).not.toHaveProperty("freed_pose");
  });
});
