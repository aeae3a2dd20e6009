// Function generation: the sine generator from the gallery, its fields, its ribbon, its numbers.
import {beforeEach, expect, test} from "vitest";
import {
  all,
  choose,
  click,
  download,
  focus,
  get,
  is_there,
  open_example,
  press,
  text,
  toasts,
  type_into,
  until,
  until_settled,
  until_there,
  value_of,
  workbench,
} from "../../../tests/page/support";
import {example, solve} from "../../../tests/program";
import type {FunctionTask} from "./task";

const task = () => workbench.problem.task as FunctionTask;
const error = () => workbench.hand!.function!.max_structural_error_deg!;

beforeEach(() => open_example("sine_generator"));

test("the best is the program's, by the objective of the file", () => {
  const [best] = solve(example("sine_generator")).linkages;
  expect(error()).toBeCloseTo(best.max_structural_error_deg, 6);
  expect(text("num.max_error")).toBe("0.056°");
  expect(text("num.reach")).toBe("whole range");
  expect(get("plot.error").getAttribute("aria-selected")).toBe("true");
  expect(workbench.hand!.function!.pairs.every(([, , off]) => Math.abs(off!) < 1e-9)).toBe(true);
});

test("a formula that is not understood stays, marked from where on", async () => {
  const was = value_of("function.expression"),
    mark = () => get("function.wrong").querySelector("mark")!.textContent;
  await type_into("function.expression", "2sn_deg");
  await until_there("function.wrong");
  expect(mark()).toBe("sn_deg");
  expect(value_of("function.expression")).toBe("2sn_deg");
  expect(get("function.expression").getAttribute("aria-invalid")).toBe("true");
  await type_into("function.expression", `2${was}`);
  await until_settled();
  expect(is_there("function.wrong")).toBe(false);
  expect(task().function!.expression).toBe(`2${was}`);
  await press("Control+z");
  await until_settled();
  expect(value_of("function.expression")).toBe(was);
});

test("the map is a ribbon, along which arrow keys go, and B takes the best", async () => {
  expect([workbench.map!.columns, workbench.map!.property]).toEqual([1, "max_structural_error_deg"]);
  expect(all("region.ribbon_line").length).toBeGreaterThan(0);
  await focus("region.map");
  const before = workbench.picked!.place![0],
    best = error();
  for (let i = 0; i < 3; ++i) await press("Shift+ArrowLeft");
  await press("Enter");
  await until_settled();
  expect(workbench.picked!.place![0]).toBeLessThan(before);
  expect(error()).toBeGreaterThan(best);
  await press("b");
  await until_settled();
  expect(text("num.max_error")).toBe("0.056°");
});

test("a point of the plot is moved by keys, a field takes arithmetic, and each is one step", async () => {
  const named = task();
  await focus("function.point.3");
  await press("ArrowUp");
  expect(task().pairs![2]!.output_deg).toBeCloseTo(39.813743614 + 1, 6);
  expect(task()).not.toHaveProperty("function");
  expect(toasts()).toContain("independent pairs");
  expect(is_there("plot.error")).toBe(false);
  await press("Control+z");
  await type_into("function.output_range_deg.1", "=90/2+5");
  expect(task().function!.output_range_deg).toEqual([0, 50]);
  await press("Control+z");
  await until_settled();
  expect(task()).toEqual(named);
});

test("a free number makes a square of the ribbon, five points make cards", async () => {
  await choose("function.free", "output_scale");
  await until_settled();
  expect([workbench.map!.columns > 99, workbench.task!.axes.output.quantity]).toEqual([true, "output_scale"]);
  expect(text("region.output_axis")).toContain("×0.5");
  await choose("function.free", "none");
  await choose("function.points", "5");
  await until_settled();
  expect(is_there("region.board")).toBe(true);
  await click("view.language");
  await until(() => text("function.by_name") === "函数");
});

test("its linkage is taken away", async () => {
  await click("export.title");
  await until_there("export.csv");
  for (const format of ["csv", "dxf", "svg", "json"])
    expect((await download(() => click(`export.${format}`))).bytes.length).toBeGreaterThan(500);
});
