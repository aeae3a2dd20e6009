import {describe, expect, it} from "vitest";
import {state_columns, state_width, type Drive} from "../contract/messages";
import {angle_at_stage, joints_at, row_count, row_joints, row_state, stage_at_angle, state_at, travel} from "./drive";

/** Angles −10…50; every other column is a line of the angle. Positions at 0, 20, 30; the fourth is not reached. */
function drive(reached = [true, true, true, false]): Drive {
  const angles = [-10, 0, 7, 20, 30, 42, 50];
  const states = new Float64Array(angles.length * state_width);
  angles.forEach((angle, row) =>
    state_columns.forEach(
      (_, column) => (states[row * state_width + column] = column === 0 ? angle : column * angle + 1),
    ),
  );
  const rows = [1, 3, 4, -1];
  return {
    states,
    width: state_width,
    full_turn: false,
    limits: {low: null, high: "dead_point"},
    task: [1, 4],
    ticks: rows.map((state, i) => ({position: i + 1, state: reached[i] ? state : -1, reached: reached[i]!})),
  };
}

describe("a drive table", () => {
  it("knows its extent", () => {
    expect(row_count(drive())).toBe(7);
    expect(travel(drive())).toEqual([-10, 50]);
  });
  it("gives its own rows exactly", () => {
    const d = drive();
    for (let row = 0; row < 7; ++row) expect(state_at(d, row_state(d, row).input_deg)).toEqual(row_state(d, row));
  });
  it("is linear between them", () => {
    const state = state_at(drive(), 13.5);
    expect(state.input_deg).toBeCloseTo(13.5, 12);
    state_columns.forEach((name, column) => column > 0 && expect(state[name]).toBeCloseTo(column * 13.5 + 1, 9));
  });
  it("is held to its ends", () => {
    expect(state_at(drive(), -100)).toEqual(row_state(drive(), 0));
    expect(state_at(drive(), 100)).toEqual(row_state(drive(), 6));
  });
});

it("the hinges of a six-bar follow the columns of every state", () => {
  const width = state_width + 4,
    states = new Float64Array(2 * width).fill(9);
  states[0] = 0;
  states[width] = 10;
  states.set([1, 2, 3, 4], state_width);
  states.set([2, 2, 5, 0], width + state_width);
  const wide: Drive = {...drive(), states, width};
  expect(row_count(wide)).toBe(2);
  expect(row_joints(wide, 1)).toEqual([
    [2, 2],
    [5, 0],
  ]);
  expect(joints_at(wide, 5)).toEqual([
    [1.5, 2],
    [4, 2],
  ]);
  expect(joints_at(wide, 10)).toEqual([
    [2, 2],
    [5, 0],
  ]);
});

describe("the stage", () => {
  it("is whole at the positions", () => {
    expect([0, 1, 2].map((stage) => angle_at_stage(drive(), stage))).toEqual([0, 20, 30]);
    expect([0, 20, 30].map((angle) => stage_at_angle(drive(), angle))).toEqual([0, 1, 2]);
  });
  it("goes there and back", () => {
    for (let angle = -10; angle <= 50; angle += 0.5)
      expect(angle_at_stage(drive(), stage_at_angle(drive(), angle))).toBeCloseTo(angle, 10);
  });
  it("runs on outside, to the ends of the travel", () => {
    expect(angle_at_stage(drive(), -0.2)).toBeCloseTo(-6, 12);
    expect(angle_at_stage(drive(), -5)).toBe(-10);
    expect(angle_at_stage(drive(), 9)).toBe(50);
  });
  it("stands still where nothing is reached", () => {
    const nowhere = drive([false, false, false, false]);
    expect(angle_at_stage(nowhere, 1.5)).toBe(0);
    expect(stage_at_angle(nowhere, 10)).toBe(0);
  });
  it("works with one position", () => {
    const one = drive([true, false, false, false]);
    expect(angle_at_stage(one, 0)).toBe(0);
    expect(angle_at_stage(one, 0.5)).toBe(15);
    expect(stage_at_angle(one, 15)).toBe(0.5);
  });
});
