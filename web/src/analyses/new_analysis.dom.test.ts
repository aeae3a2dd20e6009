// On the drawing: the layer and the legend of an analysis that the frame has never heard of (tests/new_analysis.test.ts has
// the rest of it).
import {afterAll, beforeAll, expect, test, vi} from "vitest";
import {noise} from "../../tests/noise/index";

beforeAll(() => {
  vi.resetModules();
  vi.doMock("./registry", async (original) => {
    const {analysis_modules} = await original<typeof import("./registry")>();
    return {analysis_modules: [...analysis_modules, noise]};
  });
});
afterAll(() => {
  vi.doUnmock("./registry");
  vi.resetModules();
});

test("an analysis of its own is drawn with the linkage, and its legend beside", async () => {
  const {flushSync, mount, unmount} = await import("svelte"),
    {default: Drawing} = await import("../drawing/Drawing.svelte"),
    {stored_start} = await import("../engine/stored"),
    {context_of} = await import("../state/context"),
    {Workbench} = await import("../state/workbench.svelte"),
    {new_problem} = await import("../kinds/motion/kind"),
    {with_analysis} = await import("../kinds/kind_dispatch"),
    {load_view} = await import("../kinds/view_dispatch"),
    {load_given} = await import("./view_dispatch");
  const workbench = new Workbench(new_problem()),
    {task, map, linkage} = stored_start();
  await load_view(workbench.problem.task);
  workbench.show_stored(task, map, linkage);
  const drawing = mount(Drawing, {target: document.body, context: context_of(workbench)});
  const parts = () => {
    flushSync();
    return ["layer", "legend"].map((part) => document.querySelectorAll(`[data-testid="noise.${part}"]`).length);
  };
  expect(parts()).toEqual([0, 0]);
  workbench.edit((problem) => with_analysis(problem, noise, {rpm: 90}));
  await load_given(workbench.problem);
  expect(parts()).toEqual([1, 1]);
  workbench.undo();
  expect(parts()).toEqual([0, 0]);
  await unmount(drawing);
});
