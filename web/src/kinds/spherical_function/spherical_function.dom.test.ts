// A function on the sphere: in place of a universal joint, from the gallery to the files, and from the plane and back.
import {expect, test} from "vitest";
import {
  begin,
  choose,
  click,
  download,
  get,
  is_there,
  open_example,
  open_settled,
  press,
  reload,
  text,
  type_into,
  until,
  until_settled,
  until_there,
  workbench,
} from "../../../tests/page/support";
import {example, solve} from "../../../tests/program";
import type {SphericalFunctionTask} from "./task";

const task = () => workbench.problem.task as SphericalFunctionTask;
const error = () => workbench.hand!.function!.max_structural_error_deg!;
const meeting = () => workbench.census!.meeting;

test("in place of a universal joint: the program's best, its numbers, an angle between the shafts, and back", async () => {
  await open_example("universal_joint_like");
  const best = solve(example("universal_joint_like")).linkages[0].max_structural_error_deg,
    first = task();
  expect(error()).toBeCloseTo(best, 6);
  expect(text("num.verdict")).toContain("✓");
  expect(text("num.reach")).toBe("whole range");
  expect(get("plot.error").getAttribute("aria-selected")).toBe("true");
  await type_into("function.ground_angle", "=30+15");
  await until_settled();
  expect(task().ground_angle_deg).toBe(45);
  expect(error()).not.toBeCloseTo(best, 4);
  await press("Control+z");
  await until_settled();
  expect(task()).toEqual(first);
  await click("num.best");
  await until_settled();
  expect(error()).toBeCloseTo(best, 6);
});

test("its linkage is taken away, and a reload brings it back", async () => {
  await open_example("universal_joint_like");
  const first = task();
  await click("export.title");
  for (const format of ["csv", "svg", "json", "result", "stl"])
    expect((await download(() => click(`export.${format}`))).bytes.length, format).toBeGreaterThan(500);
  expect(is_there("export.dxf")).toBe(false);
  await press("Escape");
  await reload();
  await until_settled();
  expect(task()).toEqual(first);
  await click("view.language");
  await until(() => text("function.on_sphere") === "球面");
});

test("five pairs, a free parameter, a requirement, and what generates nothing", async () => {
  await open_settled();
  await begin("spherical_function");
  await until_settled();
  expect(is_there("req.row.max_length")).toBe(false);
  const many = meeting();
  await type_into("req.min_link_angle", "60");
  await until_settled();
  expect(meeting()).toBeLessThan(many);
  await press("Control+z");
  await until_settled();

  await choose("function.free", "output_scale");
  await until_settled();
  expect([workbench.map!.columns > 99, workbench.task!.axes.output.quantity]).toEqual([true, "output_scale"]);
  await choose("function.free", "none");

  await click("function.add");
  await type_into("function.input_deg.5", "90");
  await type_into("function.output_deg.5", "84");
  await until_settled();
  expect(text("task.pattern")).toBe("P-P-P-P-P");
  expect(workbench.map!.rows).toBeLessThan(6);
  expect(workbench.hand!.function!.precision_error_deg).toBeLessThan(1e-9);
  await click("function.add");
  await until_there("task.missing");
});

test("from the plane to the sphere and back, a pin of each", async () => {
  await open_example("sine_generator");
  await click("pin.add");
  const planar = JSON.stringify(workbench.problem);
  await click("function.on_sphere");
  await until_settled();
  expect(is_there("spherical.stage")).toBe(true);
  expect(task().function!.expression).toBe(JSON.parse(planar).task.function.expression);
  expect(workbench.hand!.spherical!.angles_deg.ground).toBeCloseTo(60);
  await click("pin.add");
  await click("pin.compare");
  await until(() => is_there("pin.value.ground.B") && text("pin.value.ground.B") !== "–");
  expect(text("pin.value.ground.A")).toBe("100.00");
  expect(text("pin.value.ground.B")).toBe("60.0°"); // and no difference
  await press("Escape");
  await click("function.in_plane");
  await until_settled();
  expect(is_there("drawing.canvas")).toBe(true);
  for (let step = 0; step < 3; ++step) await press("Control+z");
  await until_settled();
  expect(JSON.stringify(workbench.problem)).toBe(planar);
});
