// The instant of the linkage in hand, where it leaves the screen. What it shows: src/drawing/instant.dom.test.ts.
import {readFileSync} from "node:fs";
import {expect, open_workbench, read_state, test} from "./support";

test.beforeEach(async ({page}) => {
  await open_workbench(page);
  await read_state(page, (workbench) => {
    workbench.tour = null;
  });
});

test("what is shown of it is in the picture, in the drawing as a file, and on paper", async ({page}) => {
  await page.evaluate(() => (window.print = () => {}));
  const svg = async () => {
    await page.getByTestId("export.title").click();
    const [download] = await Promise.all([page.waitForEvent("download"), page.getByTestId("export.svg").click()]);
    await page.keyboard.press("Escape");
    return readFileSync(await download.path(), "utf8");
  };
  const without = await svg();
  await page.keyboard.press("i");
  const curve = await page.getByTestId("drawing.instant_circling").getAttribute("d");
  expect(without).not.toContain(curve);
  expect(await svg()).toContain(curve);
  const width = (picture: SVGSVGElement | HTMLImageElement) =>
      "naturalWidth" in picture ? picture.naturalWidth : picture.clientWidth,
    on_screen = await page.locator("svg.drawing").evaluate(width),
    printed = page.getByTestId("export.sheet").locator(".drawing img");
  await page.keyboard.press("Control+p");
  await expect.poll(() => printed.evaluate(width).catch(() => 0)).toBe(on_screen);
  await page.keyboard.press("i");
  expect(await svg()).toBe(without);
});
