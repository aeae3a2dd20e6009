// The sphere: a newcomer folds a wing, by hand and on the map, and takes the links away to print them.
import type {Page} from "@playwright/test";
import {readFileSync} from "node:fs";
import type {SphericalTask} from "../src/kinds/spherical/task";
import {
  drag,
  expect,
  expect_accessible,
  file_menu,
  keep_screenshot,
  map_hash,
  middle_of,
  open_workbench,
  read_state,
  test,
  until_settled,
} from "./support";

const task = (page: Page) => read_state(page, ({problem}) => problem.task as SphericalTask);
const nose = (page: Page) => page.getByTestId("spherical.stage").getAttribute("data-nose");

async function open_wing(page: Page): Promise<void> {
  await page.addInitScript(() =>
    localStorage.setItem("linkwright.preferences", JSON.stringify({language: "en", theme: "light", toured: true})),
  );
  await open_workbench(page);
  await file_menu(page, "file.examples");
  await page.getByTestId("example.folding_wing").click();
  await expect(page.getByTestId("spherical.stage")).toBeVisible();
  await until_settled(page);
}
test("a newcomer folds the wing: a ring, the map, a linkage without defects, its motion, its links as STL", async ({
  page,
}) => {
  await open_wing(page);
  expect(await read_state(page, ({census}) => census!.meeting)).toBeGreaterThan(0);
  const before = await map_hash(page),
    first = await task(page);
  await page.getByTestId("spherical.mark.3").click();
  const knob = page.getByTestId("spherical.view.ring.z"),
    from = await middle_of(knob);
  await drag(page, from, {x: from.x + 24, y: from.y - 14}, 30);
  await until_settled(page);
  const turned = await task(page);
  expect(turned.orientations[2]).not.toEqual(first.orientations[2]);
  expect(Object.keys(turned.orientations[2]!)).toEqual(Object.keys(first.orientations[2]!)); // as it was typed
  expect(turned.orientations.toSpliced(2, 1)).toEqual(first.orientations.toSpliced(2, 1));
  expect(await map_hash(page)).not.toBe(before);
  await page.keyboard.press("Control+z");
  await until_settled(page);
  expect(await task(page)).toEqual(first);

  await page.getByTestId("num.best").click();
  await until_settled(page);
  await expect(page.getByTestId("num.verdict")).toContainText("✓");
  await expect(page.getByTestId("num.verified")).toBeAttached();
  const stood = await nose(page);
  await page.getByTestId("drive.play").click();
  await expect.poll(() => nose(page)).not.toBe(stood);
  await page.getByTestId("drive.play").click();
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByTestId("num.stl").click()]);
  expect(download.suggestedFilename()).toMatch(/^folding-wing.*\.stl$/);
  const data = readFileSync(await download.path());
  expect(data.length).toBe(84 + 50 * data.readUInt32LE(80));
  expect(data.readUInt32LE(80)).toBeGreaterThan(1000);
  await keep_screenshot(page, "spherical");

  await page.getByTestId("export.title").click();
  const [picture] = await Promise.all([page.waitForEvent("download"), page.getByTestId("export.png").click()]);
  expect(readFileSync(await picture.path()).readUInt32BE(16)).toBeGreaterThan(800); // the sphere as it is on screen
  await page.keyboard.press("Escape");

  // The cone for the axes is dragged by its handles and dropped; everybody can use it, in the dark too.
  const half = () => read_state(page, ({problem}) => problem.requirements?.fixed_axes_within?.half_angle_deg ?? null);
  const opened = await half();
  expect(opened).not.toBeNull();
  const rim = await middle_of(page.getByTestId("spherical.view.grip.fixed_axes_within.rim")),
    axis = await middle_of(page.getByTestId("spherical.view.grip.fixed_axes_within.axis"));
  await drag(page, rim, {x: (2 * rim.x + axis.x) / 3, y: (2 * rim.y + axis.y) / 3}, 8);
  expect(await half()).toBeLessThan(opened!);
  await page.keyboard.press("Control+z");
  expect(await half()).toBe(opened);
  await page.getByTestId("fixed_axes_within.drop").click();
  await expect(page.getByTestId("spherical.view.grip.fixed_axes_within.rim")).toHaveCount(0);
  await page.getByTestId("moving_axes_within.begin").click();
  await expect(page.getByTestId("spherical.view.grip.moving_axes_within.axis")).toBeVisible();
  await page.getByTestId("spherical.mark.2").click();
  await expect_accessible(page);
  await read_state(page, () => void (document.documentElement.dataset.theme = "dark"));
  await expect_accessible(page);
});
