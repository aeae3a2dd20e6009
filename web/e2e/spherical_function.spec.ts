// A function on the sphere: in place of a universal joint, from the gallery to the files, and from the plane and back.
import type {Page} from "@playwright/test";
import {readFileSync} from "node:fs";
import type {SphericalFunctionTask} from "../src/tasks/spherical_function/task";
import {
  drag,
  example,
  expect,
  expect_accessible,
  file_menu,
  keep_screenshot,
  map_hash,
  map_pixel,
  middle_of,
  open_workbench,
  read_state,
  solve,
  test,
  type_into,
  until_settled,
} from "./support";

const task = (page: Page) => read_state(page, ({problem}) => problem.task as SphericalFunctionTask);
const error = (page: Page) => read_state(page, ({hand}) => hand!.function!.max_structural_error_deg!);

test.beforeEach(async ({page}) => {
  await page.addInitScript(() =>
    localStorage.setItem("linkwright.preferences", JSON.stringify({language: "en", theme: "light", toured: true})),
  );
  await open_workbench(page);
});
async function open_joint(page: Page): Promise<void> {
  await file_menu(page, "file.examples");
  await page.getByTestId("example.universal_joint_like").click();
  await expect(page.getByTestId("spherical.stage")).toBeVisible();
  await until_settled(page);
}

test("in place of a universal joint: the program's best, shafts, scales, map, plot, files, Chinese, phone", async ({
  page,
}) => {
  await open_joint(page);
  const best = solve(example("universal_joint_like")).linkages[0];
  expect(await error(page)).toBeCloseTo(best.max_structural_error_deg, 6);
  await expect(page.getByTestId("num.verdict")).toContainText("✓");
  await expect(page.getByTestId("num.reach")).toHaveText("whole range");
  await expect(page.getByTestId("plot.error")).toHaveAttribute("aria-selected", "true");
  const first = await task(page);

  // The angle between the shafts: typed, by arithmetic; dragged; by keys; each a step.
  await type_into(page, "function.ground_angle", "=30+15");
  await until_settled(page);
  expect((await task(page)).ground_angle_deg).toBe(45);
  expect(await error(page)).not.toBeCloseTo(best.max_structural_error_deg, 4);
  await page.keyboard.press("Control+z");
  await until_settled(page);
  const shaft = page.getByTestId("spherical.view.grip.ground"),
    from = await middle_of(shaft);
  await drag(page, from, {x: from.x - 24, y: from.y + 40}, 8);
  await until_settled(page);
  expect((await task(page)).ground_angle_deg).toBeGreaterThan(38);
  await page.keyboard.press("Control+z");
  await until_settled(page);
  expect(await task(page)).toEqual(first);

  // A mark of a scale makes pairs of the function, and the map follows.
  const hash = await map_hash(page),
    mark = await middle_of(page.getByTestId("spherical.view.grip.mark_output_4"));
  await drag(page, mark, {x: mark.x + 14, y: mark.y + 4}, 6);
  await until_settled(page);
  const moved = await task(page);
  expect(moved).not.toHaveProperty("function");
  expect(moved.pairs![3]!.output_deg).toBe(Math.round(moved.pairs![3]!.output_deg));
  expect(await map_hash(page)).not.toBe(hash);
  await expect(page.getByTestId("toast.title").filter({hasText: "independent pairs"})).toBeVisible();
  await page.keyboard.press("Control+z");
  await until_settled(page);
  expect(await task(page)).toEqual(first);

  await drag(page, mark, {x: mark.x + 14, y: mark.y + 4}, 4, async () => {
    await expect.poll(async () => (await task(page)).pairs).toBeDefined();
    await page.keyboard.press("Escape");
  });
  await until_settled(page);
  expect(await task(page)).toEqual(first);

  // The map: a place is pointed at and taken; the linkage there moves; back to the best.
  const there = await map_pixel(page, [0.9, 0.5]);
  await page.mouse.click(there.x, there.y);
  await until_settled(page);
  expect(await error(page)).toBeGreaterThan(best.max_structural_error_deg);
  await page.getByTestId("num.best").click();
  await until_settled(page);
  expect(await error(page)).toBeCloseTo(best.max_structural_error_deg, 6);
  const pointer = () => page.getByTestId("spherical.stage").getAttribute("data-pointer"),
    stood = await pointer();
  await page.getByTestId("drive.play").click();
  await expect.poll(pointer).not.toBe(stood);
  await page.getByTestId("drive.play").click();

  // Files, of which the result comes back as it went.
  await page.getByTestId("export.title").click();
  for (const format of ["csv", "svg", "json", "result", "stl", "png"]) {
    const [download] = await Promise.all([page.waitForEvent("download"), page.getByTestId(`export.${format}`).click()]);
    expect(readFileSync(await download.path()).length, format).toBeGreaterThan(500);
  }
  await expect(page.getByTestId("export.dxf")).toHaveCount(0);
  await page.keyboard.press("Escape");
  await page.reload();
  await until_settled(page);
  expect(await task(page)).toEqual(first);
  await expect_accessible(page);
  await keep_screenshot(page, "spherical-function");

  await page.getByTestId("view.language").click();
  await expect(page.getByTestId("function.on_sphere")).toHaveText("球面");
  await page.setViewportSize({width: 390, height: 844});
  await expect(page.getByTestId("region.ribbon")).toBeInViewport();
  await expect(page.getByTestId("spherical.stage")).toBeInViewport();
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
  await keep_screenshot(page, "spherical-function-phone");
});

test("five pairs, a free parameter, a requirement, and what generates nothing", async ({page}) => {
  await page.getByTestId("bar.new").click();
  await page.getByTestId("new.spherical_function").click();
  await page.getByTestId("new.create").click();
  await until_settled(page);
  await expect(page.getByTestId("req.row.max_length")).toHaveCount(0);
  const meeting = () => read_state(page, ({census}) => census!.meeting),
    many = await meeting();
  await type_into(page, "req.min_link_angle", "60");
  await until_settled(page);
  expect(await meeting()).toBeLessThan(many);
  await page.keyboard.press("Control+z");
  await until_settled(page);

  await page.getByTestId("function.free").selectOption("output_scale");
  await until_settled(page);
  expect(await read_state(page, ({map, task}) => [map!.columns > 99, task!.axes.output.quantity])).toEqual([
    true,
    "output_scale",
  ]);
  await expect(page.getByTestId("spherical.view.grip.mark_output_2")).toBeVisible();
  await page.getByTestId("function.free").selectOption("none");

  await page.getByTestId("function.add").click();
  await type_into(page, "function.input_deg.5", "90");
  await type_into(page, "function.output_deg.5", "84");
  await until_settled(page);
  await expect(page.getByTestId("task.pattern")).toHaveText("P-P-P-P-P");
  expect(await read_state(page, ({map}) => map!.rows)).toBeLessThan(6);
  expect(await read_state(page, ({hand}) => hand!.function!.precision_error_deg)).toBeLessThan(1e-9);
  await page.getByTestId("function.add").click();
  await expect(page.getByTestId("task.missing")).toBeVisible();
});

test("from the plane to the sphere and back, a pin of each", async ({page}) => {
  await file_menu(page, "file.examples");
  await page.getByTestId("example.sine_generator").click();
  await until_settled(page);
  await page.getByTestId("pin.add").click();
  const planar = await read_state(page, ({problem}) => JSON.stringify(problem));
  await page.getByTestId("function.on_sphere").click();
  await until_settled(page);
  await expect(page.getByTestId("spherical.stage")).toBeVisible();
  expect((await task(page)).function!.expression).toBe(JSON.parse(planar).task.function.expression);
  expect(await read_state(page, ({hand}) => hand!.spherical!.angles_deg.ground)).toBeCloseTo(60);
  await page.getByTestId("pin.add").click();
  await page.getByTestId("pin.compare").click();
  await expect(page.getByTestId("pin.value.ground.A")).toHaveText("100.00");
  await expect(page.getByTestId("pin.value.ground.B")).toHaveText("60.0°"); // and no difference
  await page.keyboard.press("Escape");
  await page.getByTestId("function.in_plane").click();
  await until_settled(page);
  await expect(page.getByTestId("drawing.canvas")).toBeVisible();
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+z");
  await until_settled(page);
  expect(await read_state(page, ({problem}) => JSON.stringify(problem))).toBe(planar);
});
