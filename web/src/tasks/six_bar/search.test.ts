import {readFileSync} from "node:fs";
import {describe, expect, it} from "vitest";
import {Crashed, type EngineClient} from "../../engine/client";
import {engine_text, with_options, with_pose, type Problem} from "../../state/problem";
import {Workbench} from "../../state/workbench.svelte";
import {new_problem as new_motion} from "../motion/kind";
import {six_bar_kind} from "./kind";
import {ChainSearch, default_effort, most_seed, round_of, rounds_of} from "./search.svelte";

const problem = with_options(six_bar_kind.beginnings[0].make(), {effort: 1500});
const entry = {tau: [0.25, 0.5], type: "double_crank", min_transmission_angle_deg: 40, link_ratio: 3, longest: 500, chain: {a: [0, 0], b: [1, 0], d: [3, 2]}};

/** A search in an engine that answers so. */
function search_with(answer: (kind: string) => unknown, of: Problem = problem) {
  const workbench = new Workbench(of), asked: string[] = [];
  const client = {close() {}, request: (kind: string, content: {problem: string}) => (asked.push(content.problem), Promise.resolve().then(() => answer(kind)))};
  workbench.start_engine = () => client as unknown as EngineClient;
  return {workbench, search: new ChainSearch(workbench), asked};
}
const found_one = (kind: string) => (kind === "best" ? {linkages: [entry]} : {linkage: {}});

describe("a search for a chain", () => {
  it("has found for the positions that it was begun with only", async () => {
    const {workbench, search} = search_with(found_one);
    await search.start();
    expect(search.end).toBe("done");
    expect(search.found_for(workbench.problem)).toHaveLength(2); // one a round
    const moved = with_pose(workbench.problem, 1, {x: 7});
    expect(search.found_for(moved)).toEqual([]);
    expect(search.found_for(with_options(workbench.problem, {seed: 5}))).toHaveLength(2);
  });
  it("ends where its engine dies, with what it has", async () => {
    let rounds = 0;
    const {workbench, search} = search_with((kind) => {
      if (kind === "best" && ++rounds === 2) throw new Crashed("killed");
      return found_one(kind);
    });
    await expect(search.start()).resolves.toBeUndefined();
    expect([search.end, search.running, search.found_for(workbench.problem).length]).toEqual(["failed", false, 1]);
  });
  it("stops once another task is in hand: nobody could stop it there", async () => {
    const {workbench, search, asked} = search_with((kind) => {
      if (kind === "best") workbench.open(new_motion()); // through the same positions
      return found_one(kind);
    });
    await search.start();
    expect([search.end, search.running, asked.length]).toEqual(["stopped", false, 2]);
    expect(search.is_for(workbench.problem)).toBe(false);
    workbench.undo();
    expect(search.found_for(workbench.problem)).toHaveLength(1);
  });
  it("tries as many chains as the schema says where the file does not", () => {
    const {properties} = JSON.parse(readFileSync("../schema/problem.schema.json", "utf8")).$defs.options;
    expect(default_effort).toBe(properties.effort.default);
    expect(most_seed).toBe(properties.seed.maximum);
  });
  it("tries every round with a seed that the engine takes", () => {
    const last = with_options(problem, {seed: most_seed});
    const seeds = Array.from({length: rounds_of(last)}, (_, round) => round_of(last, round).options!.seed!);
    expect(seeds).toEqual([999_999_999, 0]);
    expect(engine_text(round_of(last, 1))).toContain('"effort":500');
  });
});
