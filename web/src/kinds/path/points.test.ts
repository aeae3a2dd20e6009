// Points and what is given beside them, as values.
import {describe, expect, it} from "vitest";
import type {Linkage} from "../../contract/messages";
import type {Problem} from "../../state/problem";
import {anchors_of, incompleteness, kind_of, map_of} from "../kind_dispatch";
import {path_kind} from "./kind";
import {reordered} from "./angles";
import {layer_at} from "./layers";
import {
  clicked_anew,
  continued,
  path_task,
  points_of,
  with_angle_turned,
  with_angles_of,
  with_clicked,
  with_form,
  with_pivot,
  with_pivot_of,
  with_point,
  with_points,
} from "./points";
import {form_of, pivots_of, place_of, type PathTask} from "./task";

const [timed, mixer, feeder, leg] = path_kind.beginnings.map((beginning) => beginning.make()) as [
  Problem,
  Problem,
  Problem,
  Problem,
];
const task_of = (problem: Problem) => path_task(problem)!;
const place = ({x, y}: {x: number; y: number}) => ({x, y});
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
    expect([1, 3, 4, 5, 6].map((n) => missing(passing(both, n)))).toEqual([
      ["too_few", 2],
      null,
      ["too_few", 1],
      null,
      ["too_many", 1],
    ]);
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

describe("angles at some points", () => {
  /** So many with the crank's angle, then so many without. */
  const some = (angled: number, plain: number, key: "input_deg" | "theta_deg" = "input_deg"): Problem => ({
    ...feeder,
    task: {
      ...feeder.task,
      points: Array.from({length: angled + plain}, (_, i) => ({
        x: i,
        y: i * i,
        ...(i < angled ? {[key]: 20 * i} : {}),
      })),
    } as PathTask,
  });
  const said = (problem: Problem) => {
    const {text, n} = incompleteness(problem) ?? {};
    return text ? [text, n] : null;
  };

  it("go with so many points without", () => {
    expect(said(feeder)).toBeNull();
    expect(form_of(task_of(feeder))).toBe("some");
    expect([some(4, 1), some(4, 1, "theta_deg"), some(4, 0), some(5, 0)].map(said)).toEqual([null, null, null, null]);
    expect(said(some(0, 5))).toEqual(["state.path_no_angles", 5]);
    expect(said(some(1, 4))).toEqual(["state.path_few_angles", 2]);
    expect(said(some(3, 0, "theta_deg"))).toEqual(["state.path_few_with_3", 2]);
    expect(said(some(3, 1))).toEqual(["state.path_few_with_3", 1]);
    expect(said(some(3, 3))).toEqual(["state.path_many_with_3", 1]);
    expect(said(some(4, 0, "theta_deg"))).toEqual(["state.path_few_with_4", 1]);
    expect(said(some(4, 2))).toEqual(["state.path_many_with_4", 1]);
    expect(said(some(5, 1))).toEqual(["state.path_many_angles", 1]);
    expect(said(some(5, 0, "theta_deg"))).toEqual(["state.path_many_angles", 1]);
    const [first, ...rest] = points_of(feeder),
      directed = {...first!, derivatives: [{x: 1, y: 0, theta: 0}]};
    expect(said({...feeder, task: {...feeder.task, points: [directed, ...rest]} as PathTask})).toEqual([
      "state.path_many_with_4",
      1,
    ]);
  });
  it("go with a ground pivot where all three points have one of the crank", () => {
    const about = (problem: Problem) => with_pivot(problem, "input", [9, 9]);
    expect(said(about(some(3, 0)))).toBeNull();
    expect(said(about(some(2, 0)))).toEqual(["state.path_few_timed", 1]);
    expect(said(about(some(4, 0)))).toEqual(["state.path_many_timed", 1]);
    expect(said(about(some(1, 2)))).toEqual(["state.path_some_and_pivots", 2]);
    expect(said(about(some(3, 0, "theta_deg")))).toEqual(["state.path_coupler_and_pivots", 3]);
  });
  it("are hung on a point between its neighbours and taken off, with the rates that go with them", () => {
    const once = with_angle_turned(feeder, 3);
    expect(points_of(once)[3]).toEqual({x: 60, y: 150, theta_deg: -95}); // as they go on
    const [first, , ...rest] = points_of(feeder),
      gap = {...feeder, task: {...feeder.task, points: [first!, {x: 1, y: 2}, ...rest]} as PathTask};
    expect(points_of(with_angle_turned(gap, 1))[1]).toEqual({x: 1, y: 2, theta_deg: -30});
    expect(with_angle_turned(once, 3).task).toEqual(feeder.task);
    const rated = with_point(feeder, 0, {derivatives: [{x: 1, y: 2, theta: 3}]}),
      off = with_angle_turned(rated, 0);
    expect(points_of(off)[0]).toEqual({x: 0, y: 0, derivatives: [{x: 1, y: 2}]});
    expect(points_of(with_angle_turned(off, 0))[0]!.derivatives).toEqual([{x: 1, y: 2, theta: 0}]);
    expect(points_of(with_angle_turned(timed, 1))[1]).toEqual({x: 1, y: 32});
  });
  it("are of the crank or of the coupler, all of one", () => {
    const crank = with_angles_of(feeder, "input_deg");
    expect(points_of(crank).map(({input_deg}) => input_deg)).toEqual([0, -25, -60, undefined, undefined]);
    expect(points_of(crank).some((point) => "theta_deg" in point)).toBe(false);
    expect(with_angles_of(crank, "theta_deg").task).toEqual(feeder.task);
    expect(map_of(crank.task)).not.toBe(map_of(feeder.task));
    const none = with_angles_of(some(0, 5), "theta_deg");
    expect(said(none)).toBeNull();
  });
  it("are left at three of the points where the form is chosen, and come back at all", () => {
    const of_five = with_form(with_form(mixer, "angles", null), "some", null);
    expect(points_of(of_five).map(({input_deg}) => input_deg)).toEqual([0, undefined, 60, undefined, 120]);
    expect(said(of_five)).toBeNull();
    const of_pivot = with_form(mixer, "some", null);
    expect(said(of_pivot)).toBeNull();
    expect(points_of(of_pivot).filter(({theta_deg}) => theta_deg !== undefined)).toHaveLength(3);
    expect(points_of(with_form(feeder, "angles", null)).map(({input_deg}) => input_deg)).toEqual([0, 30, 60, 90, 120]);
    expect(points_of(with_form(feeder, "pivots", null))).toEqual(
      points_of(leg).map((_, i) => place(points_of(feeder)[i]!)),
    );
  });
  it("are told in the table and read from a file, each in its own words", () => {
    const {head, rows} = path_kind.table(task_of(feeder), "mm");
    expect(head).toEqual(["x mm", "y mm", "θ °"]);
    expect([rows[1], rows[3]]).toEqual([
      ["120", "60", "−25"],
      ["60", "150", ""],
    ]);
    expect(path_kind.table(task_of(timed), "mm").head[2]).toBe("φ °");
    const filed = {...feeder.task, points: [{x: 1, y: 2, theta_deg: 3, derivatives: [{x: 4, y: 5, theta: 6}]}]};
    expect(path_kind.read(filed as never)).toEqual(filed);
    expect(path_kind.read({...filed, points: [{x: 1, y: 2, theta_deg: "3"}]} as never)).toBeNull();
  });
  it("stay where points without are clicked anew", () => {
    const three = with_points(feeder, clicked_anew);
    expect(points_of(three)).toEqual(points_of(feeder).slice(0, 3));
    const four = with_clicked(three, [7, 8])!,
      five = with_clicked(four, [9, 10])!;
    expect(points_of(five).slice(3)).toEqual([
      {x: 7, y: 8},
      {x: 9, y: 10},
    ]);
    expect(with_clicked(five, [1, 1])).toBeNull();
    expect(points_of(with_points(timed, clicked_anew))).toEqual([]);
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
    expect(continued(task_of(mixer), 1, null)).toEqual({x: -200, y: 150});
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
  const few = [0.5, 2.5, 5.5].map((k) => ({tau: [0.3, k] as const}));
  expect(few.map(({tau}) => layer_at(few, tau))).toEqual([0, 1, 2]);
});
