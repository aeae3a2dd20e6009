// Points and what is given beside them, as values.
import {describe, expect, it} from "vitest";
import type {Linkage} from "../../contract/messages";
import type {Problem} from "../../state/problem";
import {anchors_of, incompleteness, kind_of, map_of} from "../kind_dispatch";
import {path_kind} from "./kind";
import {continued, layer_at, path_task, points_of, reordered, with_clicked, with_form, with_pivot_of} from "./points";
import {form_of, pivots_of, place_of, type PathTask} from "./task";

const [timed, mixer] = path_kind.beginnings.map((beginning) => beginning.make()) as [Problem, Problem];
const task_of = (problem: Problem) => path_task(problem)!;
const passing = (problem: Problem, count: number): Problem => ({
  ...problem,
  task: {...problem.task, points: Array.from({length: count}, (_, i) => ({x: i, y: i * i}))} as PathTask,
});
const missing = (problem: Problem) => {
  const {state, n} = incompleteness(problem) ?? {};
  return state ? [state, n] : null;
};

describe("what is given beside the points", () => {
  it("goes with so many of them, derivatives counted", () => {
    const both = with_form(mixer, "pivots", null);
    expect([4, 5, 7].map((n) => missing(passing(mixer, n)))).toEqual([["too_few", 1], null, ["too_many", 2]]);
    expect([1, 3, 4].map((n) => missing(passing(both, n)))).toEqual([["too_few", 2], null, ["too_many", 1]]);
    const [first, ...rest] = task_of(mixer).points,
      directed = {...first!, derivatives: [{x: 1, y: 0}]};
    expect(missing({...mixer, task: {...mixer.task, points: [directed, ...rest]} as PathTask})).toEqual([
      "too_many",
      1,
    ]);
  });
  it("is changed with the points kept", () => {
    const one = with_form(timed, "pivot", null),
      both = with_form(one, "pivots", null),
      back = with_form(both, "angles", null);
    for (const problem of [one, both, back])
      expect(points_of(problem).map(place_of)).toEqual(points_of(timed).map(place_of));
    expect([one, both, back].map((problem) => form_of(task_of(problem)))).toEqual(["pivot", "pivots", "angles"]);
    for (const point of points_of(one)) expect(point).not.toHaveProperty("input_deg");
    expect(pivots_of(task_of(both)).input).toEqual(pivots_of(task_of(one)).input);
    expect(task_of(back)).not.toHaveProperty("given");
    expect(points_of(back).map(({input_deg}) => input_deg)).toEqual([0, 40, 80, 120]);
    expect(with_form(one, "pivot", null).task).toBe(one.task);
  });
  it("begins at none of the points, or where the linkage in hand has it", () => {
    const at_left = {...timed, task: {...timed.task, points: [-20, 0, 20].map((x) => ({x, y: 0}))} as PathTask};
    const {input, output} = pivots_of(task_of(with_form(at_left, "pivots", null)));
    for (const at of [input!, output!])
      for (const {x, y} of points_of(at_left)) expect(Math.hypot(at[0] - x, at[1] - y)).toBeGreaterThan(2);
    expect(input).not.toEqual(output);
    const hand = {input: {center: [1.23456, 2]}, output: {center: null}} as unknown as Linkage;
    expect(pivots_of(task_of(with_form(timed, "pivot", hand)))).toEqual({input: [1.235, 2]});
  });
  it("keeps no rate of the crank without its angle", () => {
    const [first, ...rest] = points_of(timed),
      rated = {...first!, derivatives: [{x: 1, y: 2, input: 3}]};
    const one = with_form({...timed, task: {...timed.task, points: [rated, ...rest]} as PathTask}, "pivot", null);
    expect(points_of(one)[0]!.derivatives).toEqual([{x: 1, y: 2}]);
  });
  it("is a pivot of either link, and lies among what is shown, moves and tells maps apart", () => {
    const other = with_pivot_of(mixer, "output");
    expect(pivots_of(task_of(other))).toEqual({output: [40, 90]});
    expect(with_pivot_of(other, "input").task).toEqual(mixer.task);
    expect(anchors_of(mixer.task)).toContainEqual([40, 90]);
    const maps = [timed, mixer, other, with_form(mixer, "pivots", null)].map(({task}) => map_of(task));
    expect(new Set(maps).size).toBe(4);
    const moved = kind_of(mixer.task).moved(mixer.task, ([x, y]) => [x + 1, -y]) as PathTask;
    expect(pivots_of(moved)).toEqual({input: [41, -90]});
  });
});

describe("points", () => {
  it("are clicked until there are enough, timed where the others are", () => {
    let problem = passing(mixer, 0);
    for (let clicks = 0; clicks < 5; ++clicks) problem = with_clicked(problem, [10 * clicks, clicks * clicks])!;
    expect(points_of(problem)[4]).toEqual({x: 40, y: 16});
    expect(with_clicked(problem, [1, 1])).toBeNull();
    const three = {...timed, task: {...timed.task, points: points_of(timed).slice(0, 3)} as PathTask};
    expect(points_of(with_clicked(three, [7, 8])!)[3]).toEqual({x: 7, y: 8, input_deg: 105});
    const bare = passing(with_form(mixer, "angles", null), 0);
    expect(points_of(with_clicked(bare, [7, 8])!)).toEqual([{x: 7, y: 8, input_deg: 0}]);
  });
  it("go on and change places without angles, too", () => {
    expect(continued(task_of(mixer), 1)).toEqual({x: -200, y: 150});
    expect(reordered(points_of(mixer), 1, 0)[0]).toEqual({x: 95, y: 40});
  });
  it("are read without angles and with pivots, and left alone where they are none", () => {
    expect(path_kind.read({...mixer.task} as never)).toEqual(mixer.task);
    const stray = {...mixer.task, given: {ground_pivots: {input: [1], output: [2, 3], more: 1}}};
    expect((path_kind.read(stray as never) as PathTask).given).toEqual({ground_pivots: {output: [2, 3]}});
    expect(path_kind.read({...mixer.task, given: {ground_pivots: {}}} as never)).not.toHaveProperty("given");
    expect(path_kind.read({...mixer.task, points: [{x: 1, y: 2, input_deg: "3"}]} as never)).toBeNull();
    expect(path_kind.table(mixer.task as PathTask, "mm")).toMatchObject({head: ["x mm", "y mm"]});
  });
});

it("tells which of the linkages at a place is meant", () => {
  const layers = [4, 17, 90].map((k) => ({tau: [k + 0.42, 0.3] as const}));
  expect([[0.42, 0.3] as const, ...layers.map(({tau}) => tau)].map((tau) => layer_at(layers, tau))).toEqual([
    0, 0, 1, 2,
  ]);
});
