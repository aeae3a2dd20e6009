// What the page says, on the page as a whole: once, with a unit, and of keys only where there are keys.
import {afterAll, afterEach, beforeAll, describe, expect, it, vi} from "vitest";
import type {Workbench} from "../src/state/workbench.svelte";
import {first_example} from "../src/gallery/gallery";
import {poses_of} from "../src/state/task";
import {with_poses} from "../src/kinds/kind_dispatch";
import {t} from "../src/texts/texts.svelte";

let workbench: Workbench;
let page: () => string;
const {problem} = first_example,
  poses = poses_of(problem.task);
const times = (text: string) => page().split(text).length - 1;

beforeAll(async () => {
  vi.resetModules();
  vi.stubGlobal("document", {documentElement: {}});
  vi.stubGlobal("getComputedStyle", () => ({getPropertyValue: () => "#000000"}));
  vi.doMock("../src/shell/start", () => ({begin: () => () => {}}));
  await (await import("../src/kinds/view_dispatch")).load_views();
  await (await import("../src/texts/texts.svelte")).load_texts();
  const {context_of} = await import("../src/state/context"),
    {Workbench} = await import("../src/state/workbench.svelte"),
    {default: App} = await import("../src/App.svelte");
  workbench = new Workbench(problem);
  const {render} = await import("svelte/server");
  page = () => render(App, {context: context_of(workbench)}).body;
});
afterEach(async () => {
  const {screen_size} = await import("../src/state/screen.svelte");
  screen_size.width = 1440;
  workbench.open(problem);
});
afterAll(() => {
  vi.unstubAllGlobals();
  vi.doUnmock("../src/shell/start");
  vi.resetModules();
});

describe("the page", () => {
  it("says once what is missing, and offers no best where there can be none", () => {
    const six = with_poses(problem, [...poses, ...poses.slice(0, 2).map((pose) => ({...pose, x: pose.x + 7}))]);
    workbench.open(six);
    expect(workbench.incomplete?.state).toBe("too_many");
    expect(times(t("state.too_many", {n: 6}))).toBe(1);
    expect(page()).not.toContain("press B");
  });
  it("speaks of no keys where there are none", async () => {
    const {screen_size} = await import("../src/state/screen.svelte");
    screen_size.width = 390;
    workbench.sheet = "pins";
    for (const words of ["press B", "Press P"]) expect(page()).not.toContain(words);
    workbench.sheet = null;
  });
  it("ties what is wrong with a requirement to its field", () => {
    const mistake = {
      code: "not_positive",
      place: "requirements.max_length",
      values: {},
      message: "a length is positive",
    };
    workbench.refusal = [mistake];
    const body = page();
    workbench.refusal = null;
    expect(body).toMatch(/<p[^>]*id="req_fault_max_length"/);
    expect(body).toMatch(/<input[^>]*aria-describedby="req_fault_max_length"/);
  });
  it("asks to drag within the green where it is green already", () => {
    const halo = (counts: number[]) => ({
      ...{part: 1, mode: "move" as const, offsets: new Float64Array(3), steps: 3, reach: 1, engine_ms: 1},
      counts: Uint32Array.from(counts),
    });
    workbench.tour = 0;
    workbench.answers.halo = halo([0, 0, 0, 0, 9, 0, 0, 0, 0]);
    expect(page()).toContain(t("tour.drag_within", {n: 2}));
    workbench.answers.halo = halo([9, 0, 0, 0, 0, 0, 0, 0, 0]);
    expect(page()).toContain(t("tour.drag_this", {n: 2}));
    workbench.solid = true;
    expect(page()).toContain(t("tour.drag"));
    workbench.solid = false;
    workbench.answers.halo = null;
    workbench.tour = null;
  });
});
