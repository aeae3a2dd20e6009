// A function on the sphere: in place of a universal joint, from the gallery to the files, and from the plane and back.
import type {Page} from "@playwright/test";
import type {SphericalFunctionTask} from "../src/kinds/spherical_function/task";
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

test("in place of a universal joint: shafts and scales are dragged, the map is pointed at, and it fits a phone, in Chinese", async ({
  page,
}) => {
  await open_joint(page);
  const best = solve(example("universal_joint_like")).linkages[0];
  expect(await error(page)).toBeCloseTo(best.max_structural_error_deg, 6);
  await expect(page.getByTestId("num.verdict")).toContainText("✓");
  await expect(page.getByTestId("num.reach")).toHaveText("whole range");
  await expect(page.getByTestId("plot.error")).toHaveAttribute("aria-selected", "true");
  const first = await task(page);

  // The angle between the shafts is dragged, one step.
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

  await expect_accessible(page);
  await keep_screenshot(page, "spherical-function");

  await page.getByTestId("view.language").click();
  await expect(page.getByTestId("function.on_sphere")).toHaveText("球面");
  await page.setViewportSize({width: 390, height: 844});
  await expect(page.getByTestId("region.ribbon")).toBeInViewport();
  await expect(page.getByTestId("spherical.stage")).toBeInViewport();
  await expect.poll(() => page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
  await keep_screenshot(page, "spherical-function-phone");
});
