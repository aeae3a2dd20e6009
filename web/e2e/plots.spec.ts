// What stands at a plot, and how finely it is drawn.
import type {Page} from "@playwright/test";
import {expect, keep_screenshot, open_workbench, read_state, test, until_settled} from "./support";

/** What canvases were told to write and where lines were to go, from the next start of the page on. */
async function watch(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const seen = {texts: [] as string[], heights: [] as number[]};
    Object.assign(globalThis, {seen});
    const {fillText} = CanvasRenderingContext2D.prototype,
      {lineTo} = Path2D.prototype;
    CanvasRenderingContext2D.prototype.fillText = function (text, ...rest) {
      seen.texts.push(text);
      fillText.call(this, text, ...rest);
    };
    Path2D.prototype.lineTo = function (x, y) {
      seen.heights.push(y);
      lineTo.call(this, x, y);
    };
  });
}
const seen = (page: Page) =>
  page.evaluate(() => (globalThis as unknown as {seen: {texts: string[]; heights: number[]}}).seen);

test("a plot has titles with units, no steps of a pixel, labels of its own range, and room beside its legends", async ({
  page,
}) => {
  await watch(page);
  await open_workbench(page);
  await page.getByTestId("plot.velocity").click();
  await expect.poll(async () => (await seen(page)).texts).toContain("Velocity ratio dψ/dφ");
  const {texts, heights} = await seen(page);
  expect(texts).toContain("Transmission angle γ (°)");
  expect(texts).toContain("Driver angle from position 1 (°)");
  expect(heights.some((height) => Math.abs(height - Math.round(height)) > 0.05)).toBe(true);

  // The legends of an instant and of samples lie beside each other.
  await page.getByTestId("tolerance.add").click();
  await expect(page.getByTestId("samples.legend")).toBeVisible();
  await page.keyboard.press("i");
  await expect(page.getByTestId("drawing.instant_legend")).toBeVisible();
  const [instant, samples] = await Promise.all(
    ["drawing.instant_legend", "samples.legend"].map(async (name) => (await page.getByTestId(name).boundingBox())!),
  );
  expect(instant!.y + instant!.height <= samples!.y + 1 || samples!.y + samples!.height <= instant!.y + 1).toBe(true);

  // A function's plot counts the input's angle.
  await page.getByTestId("file.menu").click();
  await page.getByTestId("file.examples").click();
  await page.getByTestId("example.log_generator").click();
  await until_settled(page);
  expect(await read_state(page, ({hand}) => hand!.function!.curve.length)).toBeGreaterThan(0);
  await expect.poll(async () => (await seen(page)).texts).toContain("Input angle φ (°)");
  const range = await read_state(page, ({hand}) => hand!.function!.curve.map(([input]) => input));
  const labels = (await seen(page)).texts
    .filter((text) => /^−?[\d.]+°$/.test(text))
    .map((text) => parseFloat(text.replace("−", "-")));
  for (const round of [10, 20]) expect(labels).toContain(round);
  expect(Math.min(...range)).toBeLessThan(1);
  await keep_screenshot(page, "plot-of-a-function");

  // Tabs and values have room on a small screen.
  await page.setViewportSize({width: 800, height: 600});
  const boxes = await page
    .locator(".plot .head")
    .locator("[role=tab], output, .small")
    .evaluateAll((all) => all.map((one) => one.getBoundingClientRect().toJSON() as DOMRect));
  for (const [i, a] of boxes.entries())
    for (const b of boxes.slice(i + 1))
      expect(a.right <= b.left + 1 || b.right <= a.left + 1 || a.bottom <= b.top + 1 || b.bottom <= a.top + 1).toBe(
        true,
      );
});
