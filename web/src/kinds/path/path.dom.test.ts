// Paths: the film claw from the gallery, timed; its table, its points and crank on the drawing, its numbers; and a mixer's
// blade about a given pivot.
import {beforeEach, describe, expect, test} from "vitest";
import {
  all,
  begin,
  click,
  faults,
  focus,
  get,
  is_there,
  open_example,
  open_settled,
  press,
  read_state,
  text,
  type_into,
  until,
  until_mapped,
  until_settled,
  value_of,
  workbench,
} from "../../../tests/page/support";
import {example, solve} from "../../../tests/program";
import {box_of_pivot} from "./pivot_search.svelte";
import {pivots_of, type PathTask} from "./task";

const task = () => workbench.problem.task as PathTask;
const path = () => workbench.hand!.path!;

describe("at given angles of the crank", () => {
  beforeEach(() => open_example("film_claw"));

  test("the best is the program's, with its numbers", async () => {
    const [best] = solve(example("film_claw")).linkages;
    await press("b");
    await until_settled();
    expect(workbench.hand!.min_transmission_angle_deg).toBeCloseTo(best.min_transmission_angle_deg, 3);
    expect(path().cognate!.size_ratio).toBeCloseTo(best.cognate.size_ratio, 3);
    expect(path().full_turn).toBe(true);
    expect([text("path.full_turn"), text("path.circuit_order")]).toEqual(["yes", "in order"]);
  });

  test("the point is where the table says, with the crank as it says", async () => {
    const {states, width, ticks} = workbench.hand!.drive!,
      reached = ticks.filter(({reached}) => reached);
    expect(reached).toHaveLength(4);
    task().points.forEach(({x, y, input_deg = NaN}, j) => {
      const rows = Array.from({length: states.length / width}, (_, row) => states.subarray(row * width)),
        sense = workbench.hand!.drive_sense === "cw" ? -1 : 1;
      const nearest = rows.reduce((a, b) => {
        const off = (row: Float64Array) => Math.abs(row[0]! - sense * (input_deg - task().points[0]!.input_deg!));
        return off(b) < off(a) ? b : a;
      });
      expect(Math.hypot(nearest[5]! - x, nearest[6]! - y), `point ${j + 1}`).toBeLessThan(0.2);
    });
  });

  test("numbers are typed, points added, taken away, timed evenly and put in another order", async () => {
    await type_into("path.input_deg.3", "72");
    await until_mapped();
    expect(task().points[2]!.input_deg).toBe(72);
    await click("path.even");
    expect(task().points.map(({input_deg}) => input_deg)).toEqual([0, 35, 70, 105]);
    await click("path.earlier.3");
    expect(task().points.map(({y}) => y)).toEqual([9.5, -3.3, 3.2, -9.5]);
    expect(task().points.map(({input_deg}) => input_deg)).toEqual([0, 35, 70, 105]);
    await press("Control+z");
    await click("path.add");
    expect(task().points[4]).toEqual({x: -0.1, y: -15.7, input_deg: 140});
    await until_settled();
    expect(read_state((of) => of.incomplete)).toBeNull();
    await click("path.remove.5");
    await click("path.remove.4");
    expect(read_state((of) => of.incomplete?.state)).toBe("too_few");
    await press("Control+z");
    await until_settled();
    expect(workbench.map).not.toBeNull();
  });

  test("a direction of travel counts as one more position", async () => {
    await click("path.remove.4");
    await click("path.add_direction.1");
    await until_settled();
    expect(text("task.pattern")).toBe("PP-P-P");
    expect(task().points[0]!.derivatives).toHaveLength(1);
    expect(get("path.point_1").querySelector("path")).not.toBeNull();
    await type_into("path.rate.x.1.1", "0.5");
    expect(task().points[0]!.derivatives![0]!.x).toBe(0.5);
    await click("path.remove_rate.1");
    expect(task().points[0]!.derivatives).toBeUndefined();
  });

  test("points and crank are moved by keys on the drawing", async () => {
    await focus("drawing.point_2");
    const {x} = task().points[1]!;
    await press("ArrowRight");
    expect(task().points[1]!.x).toBeGreaterThan(x);
    await until_settled();
    await focus("drawing.crank_3");
    await press("ArrowUp");
    expect(task().points[2]!.input_deg).toBeGreaterThan(70);
  });

  test("a full turn is required or not, and said where the crank lacks it", async () => {
    await click("full_turn.wanted");
    expect(workbench.problem.requirements!.full_turn).toBeUndefined();
    await until_settled();
    const more = workbench.census!.meeting;
    await click("full_turn.wanted");
    await until_settled();
    expect(workbench.census!.meeting).toBeLessThanOrEqual(more);
  });

  test("what is wrong is said at the field", async () => {
    await type_into("path.input_deg.2", "0");
    await until(() => /same crank angle/.test(document.body.textContent));
    expect(is_there("path.dial")).toBe(true);
    expect(value_of("path.input_deg.2")).toBe("0");
  });

  test("it speaks Chinese", async () => {
    await click("view.language");
    await until(() => /\p{Script=Han}/u.test(text("path.numbers")));
    expect(all("path.numbers")[0]!.textContent.replace(/\bmm\b|e-\d+/g, "")).not.toMatch(/[a-z]{3}/i);
  });

  test("what is given is changed, with the points kept", async () => {
    const places = task().points.map(({x, y}) => [x, y]);
    await click("path.given_pivot");
    expect(pivots_of(task()).input).toBeDefined();
    expect(task().points.map(({x, y}) => [x, y])).toEqual(places);
    expect([is_there("path.input_deg.1"), is_there("path.dial"), is_there("path.even")]).toEqual([false, false, false]);
    expect(text("task.missing")).toContain("1 is missing");
    await click("path.pivot_of_output");
    expect(Object.keys(pivots_of(task()))).toEqual(["output"]);
    await click("path.given_pivots");
    expect(text("task.missing")).toContain("three points or with five");
    await click("path.given_angles");
    expect(task().points.map(({input_deg}) => input_deg)).toEqual([0, 40, 80, 120]);
    for (let steps = 0; steps < 4; ++steps) await press("Control+z");
    await until_settled();
    expect(value_of("path.input_deg.4")).toBe("105");
  });
});

describe("about a given pivot", () => {
  beforeEach(async () => {
    await open_settled();
    await begin("path_pivot");
    await until_settled();
  });

  test("a blade is found whose crank turns fully, with its numbers", () => {
    expect(workbench.census!.meeting).toBeGreaterThan(0);
    expect(workbench.hand!.fails).toBe(0);
    expect(workbench.hand!.input.center!.map((value) => Number(value.toFixed(6)))).toEqual([40, 90]);
    expect([text("path.full_turn"), is_there("path.cognate_size")]).toEqual(["yes", false]);
    expect([is_there("path.dial"), is_there("path.input_deg.1")]).toEqual([false, false]);
    expect(text("num.tau")).toMatch(/^u 0\.\d+ · v −?\d/);
  });

  test("the linkages at a place are taken in hand one after the other, at one place of the map", async () => {
    const {place} = workbench.picked!,
      first = text("path.layer"),
      [, k, n] = /^Linkage (\d+) of (\d+) at this place$/.exec(first)!.map(Number) as [number, number, number];
    expect(n).toBeGreaterThan(1);
    await click("path.layer_after");
    await until_settled();
    expect(text("path.layer")).toContain(`Linkage ${(k % n) + 1} of ${n}`);
    expect(workbench.picked!.tau[0]).toBeGreaterThan(1);
    expect(workbench.picked!.place![0]).toBeCloseTo(place![0], 9);
    expect(text("path.elbows")).toMatch(/^[+−]{5} \d$/);
    expect(text("path.layer_meets")).toBe(
      workbench.hand!.fails === 0 ? "meets all requirements" : "misses a requirement",
    );
    await click("path.layer_before");
    await until_settled();
    expect(text("path.layer")).toBe(first);
    await press("Control+z");
    await until_settled();
    expect(text("path.layer")).toBe(first);
  });

  test("the pivot is typed and moved by keys, and what is wrong with it is said", async () => {
    await focus("drawing.pivot_input_center");
    await press("ArrowRight");
    const [x] = pivots_of(task()).input!;
    expect(x).toBeGreaterThan(40);
    await until_settled();
    expect(workbench.hand!.input.center![0]).toBeCloseTo(x, 6);
    await type_into("path.pivot_input.x", "0");
    await type_into("path.pivot_input.y", "0");
    await until(() => /point 1 lies at a ground pivot/.test(faults()));
    await type_into("path.pivot_input.y", "35");
    await until(() => faults() === "");
  });

  test("a place for it is looked for, given with its best linkage, and taken back", async () => {
    await click("path.seek_pivot");
    await until(() => is_there("path.sought"));
    expect(text("path.sought")).toContain("220 000 arms");
    const [x, y] = pivots_of(task()).input!;
    expect([x, y]).not.toEqual([40, 90]);
    await until_settled();
    expect(workbench.hand!.input.center![0]).toBeCloseTo(x, 6);
    expect(workbench.hand!.fails).toBe(0);
    const box = box_of_pivot(workbench.problem);
    expect([x >= box.x[0], x <= box.x[1], y >= box.y[0], y <= box.y[1]]).toEqual([true, true, true, true]);
    await press("Control+z");
    await until_settled();
    expect(pivots_of(task()).input).toEqual([40, 90]);
    await click("path.pivot_of_output");
    expect(is_there("path.seek")).toBe(false);
  });

  test("a direction counts as one more, and has no rate of the crank", async () => {
    await click("path.remove.5");
    expect(text("task.missing")).toContain("1 is missing");
    await click("path.add_direction.1");
    await until_mapped();
    expect(text("task.pattern")).toBe("PP-P-P-P");
    expect(Object.keys(task().points[0]!.derivatives![0]!)).toEqual(["x", "y"]);
    await click("path.click");
    expect(task().points).toEqual([]);
    expect(text("task.missing")).toContain("5 are missing");
  });

  test("it speaks Chinese", async () => {
    await click("view.language");
    await until(() => /\p{Script=Han}/u.test(text("path.layers")));
    for (const part of ["path.layers", "path.seek_pivot", "path.given_pivots", "path.pivot_of_output", "path.click"])
      expect(text(part)).not.toMatch(/[a-z]{3}/i);
  });
});

describe("at angles at some points", () => {
  beforeEach(async () => {
    await open_settled();
    await begin("path_poses");
    await until_settled();
  });
  const angles = () => task().points.map(({theta_deg}) => theta_deg);

  test("three poses and two points are kept, by handles on the drawing where poses have theirs", async () => {
    expect(workbench.census!.meeting).toBeGreaterThan(0);
    expect(["path.turn_1", "path.turn_3", "path.turn_4", "path.dial"].map(is_there)).toEqual([
      true,
      true,
      false,
      false,
    ]);
    expect(text("num.tau")).toMatch(/^y −?[\d.]+ · x −?[\d.]+$/);
    const turned = workbench.hand!.path!.theta_deg_at_points!;
    expect([turned[1], turned[2]].map((angle) => angle!.toFixed(6))).toEqual(["-25.000000", "-60.000000"]);
    await focus("drawing.turn_2");
    await press("ArrowUp");
    expect(angles()[1]).toBeGreaterThan(-25);
    await until_settled();
    await type_into("path.theta_deg.2", "-25");
    await until_mapped();
    expect(angles()).toEqual([0, -25, -60, undefined, undefined]);
  });

  test("an angle is hung on a point and taken off, and what is missing is said", async () => {
    await click("path.angle.3");
    expect(text("task.missing")).toContain("1 angle is missing");
    await click("path.angle.4");
    expect(angles()).toEqual([0, -25, undefined, -50, undefined]);
    await until_settled();
    expect(workbench.map).not.toBeNull();
    await click("path.remove.5");
    expect(text("task.missing")).toContain("1 point is missing");
    await click("path.angle.3");
    expect(text("task.missing")).toContain("a point is missing");
    await click("path.add");
    await until_mapped();
    expect(text("task.pattern")).toBe("P-P-P-P-P");
    expect(workbench.task!.axes.output.quantity).toBe("layer");
  });

  test("the angles are of the crank or of the coupler, and its rate goes with a direction", async () => {
    await click("path.angle_of_input");
    expect(task().points.map(({input_deg}) => input_deg)).toEqual([0, -25, -60, undefined, undefined]);
    await until_settled();
    expect([is_there("path.turn_1"), is_there("path.dial")]).toEqual([false, workbench.hand?.path != null]);
    await press("Control+z");
    await click("path.remove.5");
    await click("path.remove.2");
    await click("path.add_direction.1");
    expect(task().points[0]!.derivatives![0]).toHaveProperty("theta", 0);
    await type_into("path.rate.theta.1.1", "-0.01");
    expect(task().points[0]!.derivatives![0]!.theta).toBe(-0.01);
  });

  test("the linkages of a place are flicked through by a key", async () => {
    const first = text("path.layer"),
      n = Number(/of (\d+)/.exec(first)![1]),
      center = workbench.hand!.input.center!;
    expect(n).toBeGreaterThan(1);
    await press("l");
    await until_settled();
    expect(text("path.layer")).not.toBe(first);
    expect(workbench.hand!.input.center!.map((value) => value.toFixed(6))).toEqual(
      center.map((value) => value.toFixed(6)),
    );
    await press("Shift+L");
    await until_settled();
    expect(text("path.layer")).toBe(first);
    expect(get("path.layer_after").title).toContain("(L)");
  });

  test("it speaks Chinese", async () => {
    await click("view.language");
    await until(() => /\p{Script=Han}/u.test(text("path.given_some")));
    for (const part of ["path.given_some", "path.angle_of_coupler", "path.layers"])
      expect(text(part)).not.toMatch(/[a-z]{3}/i);
    await click("path.angle.1");
    expect(text("task.missing")).toMatch(/\p{Script=Han}/u);
  });
});

describe("between both pivots", () => {
  test("all linkages through five points are listed, and the best turns fully", async () => {
    await open_settled();
    await begin("path_pivots");
    await until_settled();
    expect(workbench.map!.columns).toBe(24);
    expect(text("path.layer")).toMatch(/of 24 at this place$/);
    expect([text("num.type"), text("path.full_turn")]).toEqual(["Crank-rocker", "yes"]);
    expect(all("region.ribbon_bar").length).toBeGreaterThan(0);
    await click("path.remove.5");
    expect(text("task.missing")).toContain("three points or with five");
    await click("path.remove.4");
    await until_settled();
    expect(workbench.task!.axes.input.quantity).toBe("arm_reach");
    for (const i of [1, 2, 3]) await click(`path.angle.${i}`);
    expect(task().points.every(({input_deg}) => input_deg !== undefined)).toBe(true);
    await type_into("path.input_deg.2", "-40");
    await type_into("path.input_deg.3", "-80");
    await until_mapped();
    expect([workbench.map!.rows, workbench.map!.columns]).toEqual([1, 1]);
  });
});
