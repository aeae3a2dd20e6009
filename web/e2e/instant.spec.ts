// The instant of the linkage in hand: shown on demand, of the linkage as it stands, kept between visits.
import {readFileSync} from "node:fs";
import type {Page} from "@playwright/test";
import {expect, file_menu, open_workbench, read_state, test, until_settled} from "./support";

const inflection = (page: Page) => page.getByTestId("drawing.instant_inflection");
const turn_to = (page: Page, angle: number) => read_state(page, (workbench, to) => workbench.set_angle(to), angle);

test.beforeEach(async ({page}) => {
  await open_workbench(page);
  await read_state(page, (workbench) => {
    workbench.tour = null;
  });
});

test("the instant is switched on in the tools, follows the drive, and is there after a reload", async ({page}) => {
  await expect(page.getByTestId("drawing.instant")).toHaveCount(0);
  await page.getByTestId("drawing.tools").click();
  await page.getByRole("menuitemcheckbox", {name: /inflection circle/}).click();
  await expect(inflection(page)).toHaveAttribute("d", /^M.+L/);
  await expect(page.getByTestId("drawing.instant_legend")).toContainText("Ball's point");
  const before = await inflection(page).getAttribute("d");
  await turn_to(page, 12);
  await expect(inflection(page)).not.toHaveAttribute("d", before!);
  await page.reload();
  await expect(inflection(page)).toHaveAttribute("d", /^M.+L/);
});

test("a key shows and hides it, and the moving pivots lie on the circling-point curve", async ({page}) => {
  await page.keyboard.press("i");
  await expect(inflection(page)).toHaveAttribute("d", /^M/);
  const nearest = await page.getByTestId("drawing.instant_circling").evaluate((path: SVGPathElement) => {
    const pivots = [...document.querySelectorAll<SVGRectElement>("[data-testid='drawing.instant'] rect")].map(
      (mark) => ({
        x: mark.x.baseVal.value + 4,
        y: mark.y.baseVal.value + 4,
      }),
    );
    const vertices = [...path.getAttribute("d")!.matchAll(/[ML](\S+) (\S+?)(?=[ML]|$)/g)].map(([, x, y]) => ({
      x: Number(x),
      y: Number(y),
    }));
    return pivots.map((pivot) => Math.min(...vertices.map(({x, y}) => Math.hypot(x - pivot.x, y - pivot.y))));
  });
  expect(nearest.length).toBeGreaterThanOrEqual(2);
  for (const distance of nearest) expect(distance).toBeLessThan(20); // a few vertices apart
  await page.keyboard.press("i");
  await expect(page.getByTestId("drawing.instant")).toHaveCount(0);
});

test("six-bars have none", async ({page}) => {
  await page.keyboard.press("i");
  await expect(page.getByTestId("drawing.instant")).toBeVisible();
  await file_menu(page, "file.examples");
  await page.getByTestId("example.wheel_loader").click();
  await until_settled(page);
  await page.getByTestId("drawing.tools").click();
  await expect(page.getByRole("menuitemcheckbox", {name: /inflection circle/})).toHaveCount(0);
  await expect(page.getByTestId("drawing.instant")).toHaveCount(0);
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
