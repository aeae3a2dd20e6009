// Timed paths: the film claw from the gallery, its table, its points and crank on the drawing, its numbers.
import {beforeEach, expect, test} from "vitest";
import {
  all,
  click,
  focus,
  get,
  is_there,
  open_example,
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
import type {PathTask} from "./task";

const task = () => workbench.problem.task as PathTask;
const path = () => workbench.hand!.path!;

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
  task().points.forEach(({x, y, input_deg}, j) => {
    const rows = Array.from({length: states.length / width}, (_, row) => states.subarray(row * width)),
      sense = workbench.hand!.drive_sense === "cw" ? -1 : 1;
    const nearest = rows.reduce((a, b) => {
      const off = (row: Float64Array) => Math.abs(row[0]! - sense * (input_deg - task().points[0]!.input_deg));
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
