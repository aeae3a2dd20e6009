import {readFileSync} from "node:fs";
import {describe, expect, it} from "vitest";
import {Crashed} from "../../engine/client";
import type {Replies} from "../../contract/messages";
import {with_options, type Problem} from "../../state/problem";
import {searching_workbench} from "../../state/round_search_bench";
import {new_problem as new_motion} from "../motion/kind";
import {six_bar_kind} from "./kind";
import {ChainSearch, most_seed} from "./search.svelte";
import {with_pose} from "../kind_dispatch";

const problem = with_options(six_bar_kind.beginnings[0]!.make(), {effort: 1500});
const entry = {
  tau: [0.25, 0.5],
  type: "double_crank",
  min_transmission_angle_deg: 40,
  link_ratio: 3,
  longest: 500,
  chain: {a: [0, 0], b: [1, 0], d: [3, 2]},
};

const found = {linkages: [entry], notices: []} as unknown as Replies["best"];

function search_with(find: () => Replies["best"]) {
  const bench = searching_workbench(problem, find);
  return {...bench, search: new ChainSearch(bench.workbench)};
}

describe("a search for a chain", () => {
  it("has found for the positions that it was begun with only", async () => {
    const {workbench, search} = search_with(() => found);
    await search.start();
    expect(search.end).toBe("done");
    const all_found = search.found_for(workbench.problem); // the answer of the last round
    expect(all_found).toEqual([{...entry, added: expect.anything(), problem: expect.anything()}]);
    expect(search.linkage_of(all_found[0]!)).toEqual({});
    const moved = with_pose(workbench.problem, 1, {x: 7});
    expect(search.found_for(moved)).toEqual([]);
    expect(search.found_for(with_options(workbench.problem, {seed: 5}))).toHaveLength(1);
  });
  it("ends where its engine dies, with what it has", async () => {
    let rounds = 0;
    const {workbench, search} = search_with(() => {
      if (++rounds === 2) throw new Crashed("killed");
      return found;
    });
    await expect(search.start()).resolves.toBeUndefined();
    expect([search.end, search.running, search.found_for(workbench.problem).length]).toEqual(["failed", false, 1]);
  });
  it("stops once another task is in hand: nobody could stop it there", async () => {
    const {workbench, search} = search_with(() => {
      workbench.open(new_motion()); // through the same positions
      return found;
    });
    await search.start();
    expect([search.end, search.running, search.tried]).toEqual(["stopped", false, 375]);
    expect(search.is_for(workbench.problem)).toBe(false);
    workbench.undo();
    expect(search.found_for(workbench.problem)).toHaveLength(1);
  });
  it("takes the seeds that the schema allows", () => {
    const {properties} = JSON.parse(readFileSync("../schema/problem.schema.json", "utf8")).$defs.options;
    expect(most_seed).toBe(properties.seed.maximum);
  });
  it("asks last for what the program would be asked", async () => {
    const {search, asked} = search_with(() => found);
    await search.start();
    const searches = asked.map((text) => JSON.parse(text) as Problem);
    expect(searches.every(({task}) => !("chain" in task))).toBe(true);
    expect(searches.map(({options}) => options!.effort)).toEqual([375, 1500]);
    expect(searches.at(-1)!.options!.seed).toBe(problem.options!.seed);
    expect([search.tried, search.to_try]).toEqual([1875, 1875]);
  });
});
