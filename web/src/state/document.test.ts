import {describe, expect, it} from "vitest";
import type {Axis} from "../contract/messages";
import {straight_axis} from "../../tests/axes";
import {differs, from_problem, same_tau, settled_on, to_problem, type TaskDocument} from "./document";
import {new_problem} from "../kinds/motion/kind";
import {with_view, type Pin} from "./problem";
import {with_pose} from "../kinds/kind_dispatch";

const shifted: Axis = {
  ...straight_axis,
  blocks: [
    {
      branch: 0,
      from: 0,
      to: 1,
      knots: [
        [0, 0.25],
        [1, 1.25],
      ],
    },
  ],
};
const no_curve: Axis = {...straight_axis, branches: [], blocks: []};
const both = (one: Axis) => ({input: one, output: one});

const problem = new_problem();
const pin = {name: "A", tau: [0.5, 0.75], task: problem.task} as unknown as Pin;
const document: TaskDocument = {problem, picked: {tau: [0.25, 0.5], place: null}, pins: [pin], order: null};

describe("a document", () => {
  it("is a problem with pick, pins and order taken out of its view, and becomes it again", () => {
    const file = with_view(problem, {traced: [[1, 2]], picked: [0.25, 0.5], pins: [pin], order: 3});
    const opened = from_problem(file);
    expect(opened).toEqual({
      problem: with_view(problem, {traced: [[1, 2]]}),
      picked: {tau: [0.25, 0.5], place: null},
      pins: [pin],
      order: 3,
    });
    expect(to_problem(opened)).toEqual(file);
    expect(from_problem(problem)).toEqual({problem, picked: null, pins: [], order: null});
    expect("view" in from_problem(with_view(problem, {order: 3})).problem).toBe(false);
  });
  it("differs from another in what makes a step", () => {
    expect(differs(document, {...document, problem: {...problem}})).toBe(false);
    expect(differs(document, {...document, order: 3, picked: {tau: [0.25, 0.5], place: [0, 0]}})).toBe(false);
    expect(differs(document, {...document, problem: with_pose(problem, 0, {x: 1})})).toBe(true);
    expect(differs(document, {...document, pins: []})).toBe(true);
    expect(differs(document, {...document, picked: null})).toBe(true);
    expect(differs(document, {...document, picked: {tau: [0.25, 0.51], place: null}})).toBe(true);
  });
});

describe("on the axis of an answer", () => {
  it("what was loaded gets its place from τ", () => {
    const settled = settled_on(both(straight_axis), document);
    expect(settled.picked).toEqual({tau: [0.25, 0.5], place: [0.25, 0.5]});
    expect(settled.pins[0]!.place).toEqual([0.5, 0.75]);
    expect(settled.order).toBe(3);
    expect(settled_on(both(straight_axis), settled)).toBe(settled);
  });
  it("what has a place keeps it, and τ follows, the picked linkage's only", () => {
    const settled = settled_on(both(shifted), settled_on(both(straight_axis), document));
    expect(settled.picked).toEqual({tau: [0.5, 0.75], place: [0.25, 0.5]});
    expect(settled.pins[0]).toMatchObject({tau: [0.5, 0.75], place: [0.5, 0.75]});
  });
  it("τ stays to the last bit where it has not moved", () => {
    const tau = [0.25 + 1e-12, 0.5] as const,
      settled = settled_on(both(straight_axis), {...document, picked: {tau, place: [0.25, 0.5]}});
    expect(settled.picked!.tau).toBe(tau);
  });
  it("what was loaded with a τ that is none of the axes is not in hand as another", () => {
    expect(settled_on(both(straight_axis), {...document, picked: {tau: [1.25, 0.5], place: null}}).picked).toBeNull();
  });
  it("without a curve everything waits for one", () => {
    expect(settled_on(both(no_curve), document)).toBe(document);
  });
});

describe("two τ", () => {
  it("are the same to the last bit, or both nothing", () => {
    expect(same_tau([1, 2], [1, 2])).toBe(true);
    expect(same_tau(null, null)).toBe(true);
    expect(same_tau([1, 2], [1, 2 + 1e-15])).toBe(false);
    expect(same_tau([1, 2], null)).toBe(false);
    expect(same_tau(undefined, [1, 2])).toBe(false);
  });
});
