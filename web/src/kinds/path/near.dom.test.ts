// A path that passes near its points: the bean, its numbers, the four-bars that trace it, and what is given of it.
import {beforeEach, expect, test, vi} from "vitest";
import {
  begin,
  click,
  faults,
  focus,
  is_there,
  open_settled,
  press,
  read_state,
  text,
  type_into,
  until,
  until_mapped,
  until_settled,
  until_there,
  workbench,
} from "../../../tests/page/support";
import {stroke_drag, stroke_of} from "./stroke.svelte";
import {points_of, with_point} from "./points";
import type {PathTask} from "./task";

const task = () => workbench.problem.task as PathTask;
const fit = () => workbench.hand!.path!.fit!;
const pivots = () => [workbench.hand!.input.center!, workbench.hand!.output.center!];
const rounded = (values: readonly number[]) => values.map((value) => value.toPrecision(6));
const number_in = (part: string) => Number(/[\d.e−-]+/.exec(text(part))![0].replace("−", "-"));

beforeEach(async () => {
  await open_settled();
  await begin("path_near");
  await until_settled();
});

test("a crank-rocker follows the bean within half a per cent, and its numbers say so", () => {
  expect(task().points).toHaveLength(16);
  expect([text("num.type"), text("path.full_turn")]).toEqual(["Crank-rocker", "yes"]);
  expect(number_in("path.rms_share")).toBeLessThan(0.5);
  expect(number_in("path.rms")).toBeCloseTo(fit().error.rms, 1);
  expect(text("path.largest")).toMatch(/mm at point \d+$/);
  expect([is_there("path.within_tolerance"), is_there("path.tube")]).toEqual([false, false]);
  expect([is_there("path.wanted"), is_there("path.misses"), is_there("path.dial")]).toEqual([true, true, false]);
  expect(workbench.problem.options).toBeUndefined();
  expect(read_state((of) => [of.task!.axes.input.quantity, of.task!.axes.output.quantity])).toEqual([
    "fitted_curve",
    "realisation",
  ]);
});

test("where the path is nearest lies as far from each point as is told", () => {
  expect(fit().at).toHaveLength(16);
  for (const {point, place, distance} of fit().at) {
    const {x, y} = task().points[point - 1]!;
    expect(Math.hypot(place![0] - x, place![1] - y)).toBeCloseTo(distance, 9);
  }
  const worst = Math.max(...fit().at.map(({distance}) => distance));
  expect(fit().error.max).toBeCloseTo(worst, 9);
});

test("the four-bars of one path are flicked through, and undone", async () => {
  const {rms} = fit().error,
    first = text("path.layer"),
    of_first = rounded(pivots().flat());
  expect(first).toMatch(/^Four-bar \d of 3 that trace this path$/);
  const seen = new Set<string>();
  for (let k = 0; k < 3; ++k) {
    seen.add(rounded(pivots().flat()).join());
    expect(fit().error.rms).toBeCloseTo(rms, 9);
    await press("l");
    await until_settled();
  }
  expect(text("path.layer")).toBe(first);
  expect(seen.size).toBe(3);
  await click("path.layer_after");
  await until_settled();
  expect(rounded(pivots().flat())).not.toEqual(of_first);
  await press("Control+z");
  await until_settled();
  expect(rounded(pivots().flat())).toEqual(of_first);
});

test("tolerance, weights, the polygon, the search and the closing are given", async () => {
  await type_into("path.tolerance", "5");
  await until_mapped();
  expect([text("path.within_tolerance"), is_there("path.tube")]).toEqual(["yes", true]);
  await type_into("path.tolerance", "0.01");
  await until(() => /outside$/.test(text("path.within_tolerance")));
  await type_into("path.tolerance", "");
  expect(task().tolerance).toBeUndefined();
  await click("path.more.2");
  await type_into("path.weight.2", "4");
  expect(task().points[1]!.weight).toBe(4);
  await click("path.effort_quick");
  expect(workbench.problem.options!.fit).toEqual({effort: "quick"});
  await until_mapped();
  await click("path.effort_standard");
  expect(workbench.problem.options!.fit).toBeUndefined();
  await click("path.polyline");
  expect(task().between).toBe("polyline");
  await click("path.closed");
  expect(task().closed).toBeUndefined();
  await until_settled();
  expect(faults()).toBe("");
  expect(workbench.map).not.toBeNull();
});

test("a deeper search says what it showed, and what it found joins the list in one step", async () => {
  const {problem} = workbench,
    {error} = fit();
  await click("fit.deep");
  await until_there("fit.verdict");
  expect(text("fit.verdict")).toMatch(/^[\d ,.]+ starts led to [\d ,.]+ linkages/);
  const {starts} = workbench.problem.options!.fit!;
  expect(text("fit.starts")).toBe(`begins with ${starts!.length} more linkages`);
  await until_settled();
  expect(workbench.map!.type.length).toBeGreaterThan(0);
  expect(fit().error.rms).toBeLessThanOrEqual(error.rms * (1 + 1e-9));
  workbench.undo();
  expect(workbench.problem).toEqual(problem);
  workbench.redo();
  await click("fit.starts_drop");
  expect(workbench.problem).toEqual({...problem, options: {}});
});

test("distances stand at the points, in a plot", async () => {
  const bars = document.querySelectorAll('[data-testid="path.distances"] rect');
  expect(bars).toHaveLength(16);
  expect(document.querySelector('[data-testid="path.distances"]')!.getAttribute("aria-label")).toContain("at point");
});

test("the map is the plane of the input's pivot, and a pivot is bolted where it stands", async () => {
  const best = fit().error.rms;
  await click("path.map_pivots");
  await until_settled();
  expect(task().map).toBe("pivots");
  expect(read_state((of) => [of.task!.axes.input.quantity, of.task!.axes.output.quantity])).toEqual([
    "center_y",
    "center_x",
  ]);
  expect(fit().error.rms).toBeCloseTo(best, 6);
  expect(read_state((of) => of.map!.rows)).toBeLessThanOrEqual(100);
  await click("path.bolted_input");
  await until_settled();
  expect(task().map).toBeUndefined();
  const given = task().given!.ground_pivots.input!;
  pivots()[0]!.forEach((value, axis) => expect(value).toBeCloseTo(given[axis]!, 3));
  expect(fit().error.rms).toBeLessThan(3 * best);
  expect(document.querySelector<HTMLButtonElement>('[data-testid="path.map_pivots"]')!.disabled).toBe(true);
  await focus("drawing.pivot_input_center");
  await press("ArrowRight");
  await until_settled();
  expect(task().given!.ground_pivots.input![0]).toBeGreaterThan(given[0]);
  expect(pivots()[0]![0]).toBeCloseTo(task().given!.ground_pivots.input![0], 3);
  await click("path.bolted_input");
  expect(task().given).toBeUndefined();
});

test("a distance is required, and lets what is farther off fail", async () => {
  workbench.edit((problem) => ({...problem, requirements: {...problem.requirements, max_path_error: 1e-6}}));
  await until_settled();
  expect(workbench.hand!.fails).not.toBe(0);
  expect(text("req.row.max_path_error")).toContain("Distance from the points");
});

test("points are moved by keys, taken away, put between the ends, made smooth and cleared", async () => {
  await focus("drawing.point_2");
  const {x} = task().points[1]!;
  await press("ArrowRight");
  expect(task().points[1]!.x).toBeGreaterThan(x);
  await click("path.remove.16");
  await click("path.add");
  const [first, before] = [task().points[0]!, task().points[14]!];
  expect(task().points[15]!.x).toBeCloseTo((first.x + before.x) / 2, 3);
  const bumpy = task().points;
  await click("path.smooth");
  expect(task().points).toHaveLength(16);
  expect(task().points).not.toEqual(bumpy);
  await until_settled();
  await click("path.clear");
  expect(text("task.missing")).toContain("3 are missing");
  expect([task().points.length, is_there("path.draw")]).toEqual([0, true]);
  await press("Control+z");
  await until_settled();
  expect(task().points).toHaveLength(16);
});

test("while a hand moves it is asked quickly, and at rest as is given", async () => {
  const asked = vi.spyOn(workbench.engine!, "follow");
  const efforts = () =>
    asked.mock.calls.flatMap(([kind, content]) =>
      kind === "explore"
        ? [(JSON.parse((content as {problem: string}).problem) as typeof workbench.problem).options?.fit?.effort]
        : [],
    );
  workbench.begin_gesture();
  workbench.drag((problem) => with_point(problem, 0, {x: 3}));
  await until(() => efforts().length > 0);
  expect(new Set(efforts())).toEqual(new Set(["quick"]));
  workbench.end_gesture();
  await until_settled();
  expect(efforts().at(-1)).toBeUndefined();
  expect(points_of(workbench.problem)[0]!.x).toBe(3);
  expect(workbench.problem.options).toBeUndefined();
});

test("other things are given in its place, with the points kept", async () => {
  const places = task().points.slice(0, 3);
  for (let n = 16; n > 3; --n) await click(`path.remove.${n}`);
  await click("path.given_pivots");
  expect(Object.keys(task()).sort()).toEqual(["given", "kind", "mechanism", "points"]);
  expect(task().points).toEqual(places);
  await until_settled();
  expect(workbench.task!.axes.input.quantity).toBe("arm_reach");
  await click("path.given_near");
  expect(task()).toEqual({kind: "path", mechanism: "four_bar", between: "free", points: places});
  await until_settled();
  expect(workbench.task!.axes.input.quantity).toBe("fitted_curve");
});

test("it speaks Chinese", async () => {
  await type_into("path.tolerance", "5");
  await until_mapped();
  await click("view.language");
  await until(() => /\p{Script=Han}/u.test(text("path.numbers")));
  for (const part of ["path.numbers", "path.layers", "path.draw", "path.given_near", "fit.deep"])
    expect(text(part).replace(/\bmm\b|rms/g, "")).not.toMatch(/[a-z]{3}/i);
});

test("a stroke is the task's points while it is drawn, and one step when it ends", async () => {
  const before = task();
  await click("path.draw");
  expect(workbench.mode).toBe("draw");
  const surface = {
    workbench,
    space: {scale: 1, unproject: ([x, y]: readonly [number, number]) => [x, -y] as const},
    finish: (keep: boolean) => (keep ? workbench.end_gesture() : workbench.cancel_gesture()),
  } as unknown as Parameters<typeof stroke_drag>[0];
  const at = (k: number) => [200 + 90 * Math.cos(k / 10), 200 + 50 * Math.sin(k / 10)] as const;
  const keys = {shift: false, alt: false, fine: false};
  const dropped = stroke_drag(surface, at(0));
  for (let k = 1; k < 40; ++k) dropped.move(at(k), keys);
  expect([workbench.gesture, task().closed, stroke_of(workbench).trail.length]).toEqual([true, undefined, 40]);
  dropped.cancel();
  expect([task(), stroke_of(workbench).trail.length]).toEqual([before, 0]);

  const drawn = stroke_drag(surface, at(0));
  for (let k = 1; k <= 62; ++k) drawn.move(at(k), keys);
  drawn.end();
  expect([task().closed, task().points.length, workbench.mode]).toEqual([true, 24, "point"]);
  for (const {x, y} of task().points) expect(((x - 200) / 90) ** 2 + ((y + 200) / 50) ** 2).toBeCloseTo(1, 1);
  await until_settled();
  expect(number_in("path.rms_share")).toBeLessThan(0.5);
  await press("Control+z");
  expect(task()).toEqual(before);
});
