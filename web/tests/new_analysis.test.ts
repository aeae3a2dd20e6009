// An analysis is a folder and a line: one that the frame has never heard of has its block read, is required, coloured by,
// shown below the map, on the drawing, on paper and in exports.
import type {Component} from "svelte";
import {afterAll, beforeAll, describe, expect, it, vi} from "vitest";
import type {Property, RequirementKey} from "../src/contract/messages";
import type {Problem} from "../src/state/problem";
import type {Workbench} from "../src/state/workbench.svelte";
import {noise, type Noise} from "./noise/index";

type NoisyProblem = Problem & {noise?: Noise};
let workbench: Workbench, problem: NoisyProblem;
let show: () => void;
let part_of_page: (part: {default: Component}) => string;
let page: () => string;

/** The page as it is with one more line in its registry. */
beforeAll(async () => {
  vi.resetModules();
  vi.doMock("../src/analyses/registry", async (original) => {
    const {analysis_modules} = await original<typeof import("../src/analyses/registry")>();
    return {analysis_modules: [...analysis_modules, noise]};
  });
  vi.doMock("../src/shell/start", () => ({begin: () => () => {}}));
  vi.doMock("../src/region/RegionCard.svelte", () => import("./noise/Map.svelte")); // it paints
  await (await import("../src/kinds/view_dispatch")).load_views();
  const {context_of} = await import("../src/state/context"),
    {Workbench} = await import("../src/state/workbench.svelte"),
    {new_problem} = await import("../src/kinds/motion/kind"),
    {stored_start} = await import("../src/engine/stored"),
    {default: App} = await import("../src/App.svelte");
  problem = new_problem();
  workbench = new Workbench(problem);
  const {task, map, linkage} = stored_start();
  show = () => workbench.show_stored(task, map, linkage);
  show();
  const {render} = await import("svelte/server");
  part_of_page = ({default: Part}) => render(Part, {context: context_of(workbench)}).body;
  page = () => part_of_page({default: App});
});
afterAll(() => {
  vi.doUnmock("../src/analyses/registry");
  vi.doUnmock("../src/shell/start");
  vi.doUnmock("../src/region/RegionCard.svelte");
  vi.resetModules();
});
async function give(given: Noise | null): Promise<void> {
  const {with_analysis} = await import("../src/kinds/kind_dispatch"),
    {load_given} = await import("../src/analyses/view_dispatch");
  workbench.edit((before) => with_analysis(before, noise, given));
  await load_given(workbench.problem);
  show();
}

describe("an analysis of its own", () => {
  it("has its block read, and lost by a task of which it says nothing", async () => {
    const {read_problem} = await import("../src/state/problem_shape"),
      {task_kinds, with_other_task} = await import("../src/kinds/kind_dispatch");
    const noisy = {...problem, noise: {rpm: 90}};
    expect(read_problem(JSON.parse(JSON.stringify(noisy)))).toEqual(noisy);
    expect(read_problem({...noisy, noise: {rpm: "loud"}})).toEqual(problem);
    const turned = task_kinds.find(({without_lengths}) => without_lengths)!.beginnings[0]!.make().task;
    expect(with_other_task(noisy, turned)).not.toHaveProperty("noise");
  });
  it("is what can be required, coloured by and the best by, once it is given", async () => {
    const {objectives_of, properties_of, with_analysis} = await import("../src/kinds/kind_dispatch");
    const noisy = {...problem, noise: {rpm: 90}};
    expect([properties_of(problem), objectives_of(problem)].flat()).not.toContain("noise_db");
    expect(properties_of(noisy).at(-1)).toBe("noise_db");
    expect(objectives_of(noisy).at(-1)).toBe("noise");
    const {domain} = await import("../src/region/property");
    expect(domain("noise_db" as Property, {problem: noisy, task: null})).toEqual([0, 90]);
    const required = {...noisy, requirements: {["max_noise_db" as RequirementKey]: 3}};
    expect(with_analysis(required, noise, {rpm: 1}).requirements).toEqual(required.requirements);
    for (const less of [{rpm: 0}, null]) expect(with_analysis(required, noise, less).requirements).toEqual({});
  });
  it("shows nothing until it is given", async () => {
    const before = page();
    expect(before).toContain('data-testid="noise.row"'); // its place
    for (const part of ["noise.layer", "noise.legend", "noise.tab", "noise.card"]) expect(before).not.toContain(part);
    await give({rpm: 0});
    const given = page();
    for (const part of ["noise.block", "noise.tab"]) expect(given).toContain(part);
    const {lines_of} = await import("../src/analyses/view_dispatch");
    expect(lines_of(workbench.problem, workbench.hand!, "mm")).toEqual([
      {text: `a loud ${workbench.hand!.type}`, but: null},
    ]);
  });
  it("stands below the map, and the numbers where it is taken away", async () => {
    workbench.below = "noise";
    expect(workbench.below_map).toBe("noise");
    const {given_cards} = await import("../src/analyses/view_dispatch");
    expect(part_of_page((await given_cards(workbench.problem).noise!()) as {default: Component})).toContain(
      "noise.card",
    );
    await give(null);
    expect(workbench.below_map).toBe("numbers");
    expect(page()).not.toContain("noise.layer");
  });
  it("is printed, and in the page's own picture of the linkage", async () => {
    await give({rpm: 90});
    expect(part_of_page(await import("../src/exports/PrintSheet.svelte"))).toContain("noise of ");
    const {given_views} = await import("../src/analyses/view_dispatch");
    expect(given_views(workbench.problem).some((view) => view.may_be_in_picture?.(workbench.problem))).toBe(true);
  });
});
