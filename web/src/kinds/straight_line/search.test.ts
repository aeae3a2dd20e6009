import {describe, expect, it} from "vitest";
import type {Replies} from "../../contract/messages";
import {searching_workbench} from "../../state/round_search_bench";
import {forms, with_form} from "./cases";
import {straight_line_kind} from "./kind";
import {LineSearch, problem_of} from "./search.svelte";
import type {StraightLineTask} from "./task";

const problem = straight_line_kind.beginnings.find(({id}) => id === "straight_search")!.make(),
  sought = problem.task as StraightLineTask,
  task = with_form(
    sought,
    forms.find(({id}) => id === "six_point")!,
  );
const entry = {
  tau: [1.25, 0.5],
  type: "crank_rocker",
  min_transmission_angle_deg: 40,
  link_ratio: 3,
  longest: 500,
  usable_strip: 100,
  stroke_over_longest: 0.2,
  straight_line: {task, window: null},
};
const found = {linkages: [entry], notices: []} as unknown as Replies["best"];

function search_with() {
  const bench = searching_workbench(problem, () => found);
  return {...bench, search: new LineSearch(bench.workbench)};
}

describe("a search over all cases", () => {
  it("opens the map of what it has found, measured by what was wanted, and goes back", async () => {
    const {workbench, search, asked} = search_with();
    await search.start();
    expect(search.end).toBe("done");
    expect(asked.map((text) => JSON.parse(text).options.effort)).toEqual([20_000, 200_000]);
    const [one] = search.found_for(workbench.problem);
    search.take(one!);
    expect(workbench.problem.task).toEqual(task);
    expect(workbench.problem.options).toEqual({deviation: 0.05, measure: "strip"});
    expect(workbench.picked!.tau).toEqual([1.25, 0.5]);
    expect(search.found_for(workbench.problem)).toHaveLength(1);
    search.back();
    expect(workbench.problem.task).toEqual(sought);
    expect(workbench.problem.options).toEqual({});
  });
  it("has nothing for another line", async () => {
    const {workbench, search} = search_with();
    await search.start();
    workbench.edit((now) => ({...now, task: {...sought, stroke: 70} as StraightLineTask}));
    expect(search.found_for(workbench.problem)).toEqual([]);
  });
  it("keeps the axes as wide as its linkages need them", () => {
    const window: [[number, number], [number, number]] = [
      [0, 9],
      [-1, 2],
    ];
    expect(problem_of(problem, sought, {task, window}).options!.window).toEqual(window);
  });
});
