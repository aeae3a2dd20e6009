// A kind of task is a folder and a line: one that the frame has never heard of is read, shown, required of, pinned, printed
// and taken away, with its own stage and without a map.
import type {Component} from "svelte";
import {afterAll, beforeAll, describe, expect, it, vi} from "vitest";
import type {RequestMessage, TaskAnswer} from "../src/contract/messages";
import type {Workbench} from "../src/state/workbench.svelte";
import {new_problem, swinging, type SwingTask} from "./swing/index";

let workbench: Workbench;
let part_of_page: (part: {default: Component}) => string;
let page: () => string;
const problem = new_problem(),
  linkage = swinging(problem.task as SwingTask);

/** The page as it is with one more line in its registry. */
beforeAll(async () => {
  vi.resetModules();
  vi.doMock("../src/kinds/registry", async (original) => {
    const {task_modules} = await original<typeof import("../src/kinds/registry")>();
    return {task_modules: [...task_modules, (await import("./swing/index")).swing]};
  });
  vi.doMock("../src/shell/start", () => ({begin: () => () => {}}));
  await (await import("../src/kinds/view_dispatch")).load_views();
  const {context_of} = await import("../src/state/context"),
    {Workbench} = await import("../src/state/workbench.svelte"),
    {default: App} = await import("../src/App.svelte");
  workbench = new Workbench(problem);
  const {render} = await import("svelte/server");
  part_of_page = ({default: Part}) => render(Part, {context: context_of(workbench)}).body;
  page = () => part_of_page({default: App});
});
afterAll(() => {
  vi.doUnmock("../src/kinds/registry");
  vi.doUnmock("../src/shell/start");
  vi.resetModules();
});
function take(): void {
  const axis = {quantity: "nothing", ticks: null, order: 0, branches: [], blocks: []},
    task = {status: "solved", reason: null, warnings: [], requirements: {}, axes: {input: axis, output: axis}};
  workbench.show_stored(task as unknown as TaskAnswer, null, linkage);
}

describe("a kind of its own", () => {
  it("is read again, with what is required of it", async () => {
    const {read_problem} = await import("../src/state/problem_shape");
    expect(read_problem(JSON.parse(JSON.stringify(problem)))).toEqual(problem);
    const wrong = {...problem, requirements: {max_swing_deg: "far"}};
    expect(read_problem(wrong)!.requirements).toEqual({});
  });
  it("has its stage in place of the drawing, its editor and its requirements, and no map", () => {
    const before = page();
    for (const own of ["swing.stage", "swing.editor", "swing.max_swing_deg"]) expect(before).toContain(own);
    expect(before).toContain("120°");
    for (const planar of ["drawing.title", "region.map", "req.row.max_length"])
      expect(before).not.toContain(`data-testid="${planar}"`);
    const stage = () => /data-testid="swing\.stage"[^]*?<\/svg>/.exec(page())![0];
    expect(stage()).not.toContain("<path");
    take();
    expect(stage()).toContain("<path");
  });
  it("can be begun", async () => {
    expect(part_of_page(await import("../src/shell/NewTask.svelte"))).toContain("swing.picture.swing");
  });
  it("is pinned with its own pivots, which are read again and show it without the engine", async () => {
    take();
    workbench.pin();
    const [pin] = workbench.pins;
    expect(pin!.pivots).toEqual({hinge: [10, 20]});
    expect(page()).toContain(`pin.row.${pin!.name}`);
    const {read_problem} = await import("../src/state/problem_shape"),
      {task_view} = await import("../src/kinds/view_dispatch");
    const [read] = read_problem(JSON.parse(JSON.stringify(workbench.whole_problem)))!.view!.pins!;
    expect(read).toEqual(JSON.parse(JSON.stringify(pin)));
    expect(task_view(read!.task).mechanism.ghost(read!.pivots, [], 0).joints).toHaveLength(1);
  });
  it("may be one without linkages: nothing is required, pinned, driven or measured", async () => {
    const {swing} = (await import("./swing/index")) as {swing: {without_linkages?: true}};
    swing.without_linkages = true;
    try {
      const alone = page();
      for (const own of ["swing.stage", "swing.editor"]) expect(alone).toContain(own);
      for (const part of ["swing.max_swing_deg", "req.title", "pin.title", "drive.title", "num.title", "status.snap"])
        expect(alone).not.toContain(`data-testid="${part}"`);
    } finally {
      delete swing.without_linkages;
    }
  });
  it("is printed with its table and its dimensions", async () => {
    take();
    const sheet = part_of_page(await import("../src/exports/PrintSheet.svelte"));
    for (const part of ["A gate", "swing °", "radius of the gate"]) expect(sheet).toContain(part);
  });
  it("is taken away as the engine writes it, and as a film", async () => {
    const {made_file, targets} = await import("../src/exports/take_away"),
      {picture_of} = await import("../src/exports/picture"),
      {task_view} = await import("../src/kinds/view_dispatch");
    const asked: Omit<RequestMessage, "id">[] = [];
    const run = async (job: Omit<RequestMessage, "id">) => (asked.push(job), {text: "<svg/>", extension: "svg"});
    workbench.driver_client = {run} as unknown as NonNullable<Workbench["driver_client"]>;
    const [target] = targets(workbench),
      {blob} = await made_file(workbench, target!, "svg", {} as never);
    expect(await blob.text()).toBe("<svg/>");
    expect(asked).toMatchObject([{kind: "export", format: "svg", tau: linkage.tau}]);
    const subject = {linkage, mechanism: task_view(problem.task).mechanism, outline: [], poses: []};
    expect(picture_of(subject, true, 640, 480, {} as never)!.figure_at(90).bodies).toHaveLength(1);
  });
});
