import {describe, expect, it} from "vitest";
import {made_to, suggested_limit, suggested_tolerances} from "../analyses/tolerances/editing";
import {preferences} from "../state/preferences.svelte";
import type {Problem} from "../state/problem";
import {read_problem} from "../state/problem_shape";
import {poses_of} from "../state/task";
import type {FunctionTask} from "./function/task";
import type {MotionTask} from "./motion/task";
import {
  anchors_of,
  extent_of,
  first_requirements,
  seeks_linkages,
  incompleteness,
  kind_of,
  map_of,
  objectives_of,
  read_task,
  task_kinds,
  told,
  with_other_task,
  with_poses,
  with_task_poses,
  without_unmet,
} from "./kind_dispatch";
import {new_problem} from "./motion/kind";

const beginnings = task_kinds.flatMap((kind) =>
  kind.beginnings.map((beginning) => ({kind, id: beginning.id, problem: beginning.make()})),
);
const problem = new_problem(),
  poses = poses_of(problem.task);
const of = (task: unknown) => read_task({kind: "motion", mechanism: "four_bar", poses, ...(task as object)});

describe("kinds of tasks", () => {
  it("call what was given by its name in the engine's sentences", () => {
    const lock = {code: "branch_defect", message: "", values: {from: 1, to: 2}},
      order = {code: "order_defect", message: "", values: {order: "1-3-2"}};
    const pairs = {kind: "function", mechanism: "four_bar", pairs: []} as FunctionTask;
    expect(told(problem.task, lock)).toBe("Branch defect: it passes a dead point between positions 1 and 2.");
    expect(told(pairs, lock)).toBe("Branch defect: it passes a dead point between pairs 1 and 2.");
    expect(told(pairs, order)).toBe("Order defect: this linkage reaches the pairs as 1-3-2.");
    preferences.language = "zh";
    expect(told(pairs, lock)).toContain("第 1 对与第 2 对");
    preferences.language = "en";
  });
  it.each(beginnings)("begin with what is read again: $id", ({kind, problem}) => {
    expect(kind_of(problem.task)).toBe(kind);
    expect(read_problem(JSON.parse(JSON.stringify(problem)))).toEqual(problem);
    expect(["not_available", "to_be_sought", undefined]).toContain(incompleteness(problem)?.state);
    if (seeks_linkages(problem.task)) {
      expect(anchors_of(problem.task).length).toBeGreaterThanOrEqual(2);
      expect(extent_of(problem.task)).toBeGreaterThan(1);
      expect({...first_requirements(problem), ...problem.requirements}).toEqual(problem.requirements); // some require more
    } else expect(problem.requirements).toBeUndefined();
    const table = kind.table(problem.task, "mm");
    expect(table.rows.length).toBeGreaterThan(0);
    for (const row of table.rows) expect(row).toHaveLength(table.head.length);
  });
  it("do not take each other's form", () => {
    expect(read_task({kind: "function", mechanism: "six_bar", poses, pairs: []})).toBeNull();
    expect(read_task({kind: "motion", mechanism: "six_bar", poses})).toBeNull();
    expect(read_task({kind: "function", mechanism: "four_bar"})).toBeNull();
    expect(read_task(null)).toBeNull();
  });
  it("leave out what is given in no known form, member by member", () => {
    for (const given of [
      {side_lengths: [1]},
      {side_lengths: [1, "2"]},
      {side_angle_deg: null},
      {instant_center: "x"},
      [1, 2],
      "x",
      {},
    ]) {
      expect(of({given})).not.toHaveProperty("given");
    }
    const read = of({given: {side_angle_deg: 30, directed: "yes", input_length: NaN, more: 1}}) as MotionTask;
    expect(read.given).toEqual({side_angle_deg: 30});
    expect((of({given: {instant_center: [1, 2], at_infinity: true}}) as MotionTask).given).toEqual({
      instant_center: [1, 2],
      at_infinity: true,
    });
    const pairs = read_task({
      kind: "function",
      mechanism: "four_bar",
      pairs: [{input_deg: 1, output_deg: 2, derivatives: "x"}],
      ground_pivots: {input: [0, 0]},
      free: {number: "?"},
    });
    expect(pairs).toEqual({kind: "function", mechanism: "four_bar", pairs: [{input_deg: 1, output_deg: 2}]});
    const named = {
      expression: "x^2",
      x: [0, 1],
      input_range_deg: [0, 60],
      output_range_deg: [0, 90],
      spacing: [0, 0.3, 0.7, 1],
    };
    expect(read_task({kind: "function", mechanism: "four_bar", function: {...named, points: "4", table: 3}})).toEqual({
      kind: "function",
      mechanism: "four_bar",
      function: named,
    });
  });
  it("keep every row of a long table", () => {
    const table = Array.from({length: 5000}, (_, i) => [i, i * i]),
      named = {table, input_range_deg: [0, 60], output_range_deg: [0, 90]};
    expect(read_task({kind: "function", mechanism: "four_bar", function: named})).toEqual({
      kind: "function",
      mechanism: "four_bar",
      function: named,
    });
  });
  it("know what is missing, derivatives counted", () => {
    const moving = {...poses[0]!, derivatives: [{x: 1, y: 0, theta: 0}]};
    const states = [
      [],
      poses.slice(2),
      poses.slice(1),
      poses,
      [moving, ...poses.slice(1)],
      [moving, moving, ...poses.slice(1)],
    ].map((list) => incompleteness(with_poses(problem, list))?.state ?? null);
    expect(states).toEqual(["empty", "too_few", "no_given", null, null, "too_many"]);
    const given: Problem = {
      ...problem,
      task: {kind: "motion", mechanism: "four_bar", poses: poses.slice(1), given: {side_length: 5}} as MotionTask,
    };
    expect(incompleteness(given)).toBeNull();
    const pairs = (n: number): Problem => ({
      ...problem,
      task: {
        kind: "function",
        mechanism: "four_bar",
        pairs: Array.from({length: n}, (_, i) => ({input_deg: i, output_deg: i})),
      } as FunctionTask,
    });
    expect([3, 4, 5, 6].map((n) => incompleteness(pairs(n))?.state ?? null)).toEqual([
      "too_few",
      null,
      null,
      "too_many",
    ]);
  });
  it("tell maps of other things apart", () => {
    const maps = [
      problem.task,
      with_task_poses(problem.task, poses.slice(1)),
      {...problem.task, poses: poses.slice(1), given: {side_lengths: [1, 2]}},
      {...problem.task, poses: poses.slice(1), given: {side_angle_deg: 30}},
      {...problem.task, poses: poses.slice(1), given: {instant_center: [0, 1]}},
    ].map((task) => map_of(task as MotionTask));
    expect(new Set(maps).size).toBe(5);
    expect(
      map_of(
        with_poses(
          problem,
          poses.map((p) => ({...p, x: 1})),
        ).task,
      ),
    ).toBe(maps[0]);
    const pairs: FunctionTask = {kind: "function", mechanism: "four_bar", pairs: []};
    expect(map_of({...pairs, free: {number: "output_scale"}} as FunctionTask)).not.toBe(map_of(pairs));
  });
  it("take away with tolerances what needs them", () => {
    const asked: Problem = {
      ...problem,
      requirements: {...problem.requirements, max_tolerance_error: 2, min_yield: 0.9},
      tolerances: {length: 0.5, limit: {position: 2}},
      options: {objective: "yield"},
    };
    expect(objectives_of(problem)).not.toContain("tolerance_error");
    expect(objectives_of(asked).slice(-2)).toEqual(["tolerance_error", "yield"]);
    const unlimited = made_to(asked, {length: 0.5});
    expect(unlimited.requirements).toEqual({...problem.requirements, max_tolerance_error: 2});
    expect(unlimited.options).toEqual({});
    expect(made_to(asked, null)).toEqual({...problem, options: {}});
    expect(without_unmet(asked)).toBe(asked);
  });
  it("keep of tolerances what another task's linkages have", () => {
    const asked: Problem = {
      ...problem,
      requirements: {max_tolerance_error: 2},
      tolerances: {length: 0.5, driver_deg: 0.1, limit: {position: 2}},
    };
    const beginning = (id: string) => beginnings.find((one) => one.id === id)!.problem.task;
    const turned = with_other_task(asked, beginning("four_orientations"));
    expect(turned.tolerances).toEqual({driver_deg: 0.1});
    expect(turned.requirements).toEqual({});
    expect(with_other_task(turned, beginning("function")).tolerances).toEqual({driver_deg: 0.1});
    const bare = with_other_task({...asked, tolerances: {length: 1}}, beginning("spherical_function"));
    expect(bare).not.toHaveProperty("tolerances");
    expect(with_other_task(asked, beginning("straight_line"))).toMatchObject({
      requirements: {max_tolerance_error: 2},
      tolerances: {length: 0.5, driver_deg: 0.1},
    });
    expect(with_other_task(asked, beginning("straight_search")).requirements).toEqual({});
  });
  it("suggest tolerances by the size of the task", () => {
    expect(suggested_tolerances(problem.task)).toEqual({length: 0.5});
    expect(suggested_limit({task: problem.task, tolerances: {length: 0.5}})).toEqual({position: 2});
    expect(suggested_limit({task: problem.task, tolerances: {length: {coupler: 0.1}}}, "angle_deg")).toHaveProperty(
      "angle_deg",
    );
  });
});
