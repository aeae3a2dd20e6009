import "fake-indexeddb/auto";
import {beforeAll, expect, it} from "vitest";
import {degenerate, whole} from "../contract/messages";
import {thinned} from "../engine/stored";
import {with_requirements} from "../state/problem";
import {Workbench} from "../state/workbench.svelte";
import {bench, settled, until} from "../state/workbench_bench";
import {first_example} from "../gallery/gallery";
import {with_pose_moved} from "../kinds/kind_dispatch";
import {keep_view, read_view, soon, view_for, view_of} from "./kept_view.svelte";
import {show_kept} from "./start";

let shown: Workbench;
beforeAll(async () => {
  const on = bench(first_example.problem);
  await settled(on);
  shown = on.workbench;
});
/** The document as the next visit finds it. */
const next_visit = () => new Workbench(shown.steps);

it("is there on the next visit, before the engine", async () => {
  await keep_view(view_of(shown)!);
  const workbench = next_visit(),
    view = view_for(workbench, await read_view())!;
  workbench.show_stored(view.task, view.map, view.linkage, view.live);
  expect(workbench.map!.rows).toBeLessThanOrEqual(250);
  expect(workbench.map!.window).toBe(whole);
  expect(workbench.census).toEqual(shown.census);
  expect(workbench.hand).toEqual(shown.picked_linkage);
  expect(workbench.live).toEqual(shown.live);
  expect(workbench.answers.map_is_of_present && workbench.answers.hand_is_of_present).toBe(true);
  expect(workbench.document).toEqual(shown.document);
});
it("gives way to the best linkage where a change that comes before the engine has cost it", async () => {
  const on = bench(shown.problem),
    {workbench} = on,
    {task, map, linkage, live} = view_of(shown)!;
  workbench.show_stored(task, map, linkage, live);
  const max_length = Math.floor(linkage.longest!) - 1;
  workbench.edit((problem) => with_requirements(problem, {max_length}));
  await until(() => workbench.toasts.some(({key}) => key === "state.went_to_best"));
  await settled(on);
  expect(workbench.picked_linkage!.fails).toBe(0);
});
it("is shown when it is read late, and not over a map that is there", async () => {
  expect(await soon(new Promise(() => {}))).toBeNull();
  const kept = view_of(shown)!,
    workbench = next_visit();
  show_kept(workbench, null);
  expect(workbench.map).toBeNull();
  show_kept(workbench, kept);
  expect(workbench.hand).toEqual(shown.picked_linkage);
  const there = workbench.map;
  show_kept(workbench, kept);
  expect(workbench.map).toBe(there);
});
it("is shown of nothing else", async () => {
  const kept = view_of(shown)!,
    other = new Workbench(with_pose_moved(first_example.problem, 1, [1, 0]));
  expect(view_for(other, kept)).toBeNull();
  expect(view_for(next_visit(), {...kept, build: "another"})).toBeNull();
  expect(view_for(next_visit(), {...kept, linkage: {...kept.linkage, tau: [0.1, 0.2]}})).toBeNull();
  expect(view_for(next_visit(), null)).toBeNull();
});
it("is not kept of what is under way", () => {
  shown.begin_gesture();
  expect(view_of(shown)).toBeNull();
  shown.cancel_gesture();
  expect(view_of(shown)).not.toBeNull();
});
it("keeps cells of the map as they were, with their places", () => {
  const map = shown.map!,
    thin = thinned(map, 90),
    step = Math.ceil(map.rows / 90);
  expect(thin.rows).toBe(Math.ceil(map.rows / step));
  for (const [row, column] of [
    [0, 0],
    [3, 7],
    [thin.rows - 1, thin.columns - 1],
  ] as const) {
    const here = row * thin.columns + column,
      there = row * step * map.columns + column * step;
    expect(thin.input_tau[row]).toBe(map.input_tau[row * step]);
    expect(thin.output_tau[column]).toBe(map.output_tau[column * step]);
    for (const key of ["type", "defects", "fails", "value"] as const) expect(thin[key][here]).toBe(map[key][there]);
  }
  expect([...thin.type].some((type) => type !== degenerate)).toBe(true);
  expect(Buffer.compare(thinned(map, 5000).type, map.type)).toBe(0);
});
