// Tolerances: the row that gives them, and what they open.
import type {Page} from "@playwright/test";
import {
  expect,
  keep_screenshot,
  map_pixel,
  open_settled,
  open_workbench,
  read_state,
  test,
  type_into,
  until_settled,
} from "./support";

const tolerances_of = (page: Page) => read_state(page, (workbench) => workbench.problem.tolerances ?? null);
const until_sampled = (page: Page) =>
  page.waitForFunction(() => {
    const {yields} = globalThis.__linkwright!.workbench.answers;
    return yields !== null && yields.done === yields.total;
  });

test.describe("on a wide screen", () => {
  test.beforeEach(({page}) => open_settled(page));

  test("with a limit show yields, coarse to fine", async ({page}) => {
    await page.getByTestId("tolerance.add").click();
    await page.getByTestId("tolerance.set_limit").click();
    expect(await tolerances_of(page)).toEqual({length: 0.5, limit: {position: 2}});
    await page.getByTestId("region.menu").click();
    await page.getByTestId("region.color.yield").click();
    await expect(page.getByTestId("tolerance.sampling")).toContainText("Sampling yields: ");
    await until_sampled(page);
    await expect(page.getByTestId("tolerance.sampling")).toHaveCount(0);
    const {meeting, total, worst, best} = await read_state(page, ({map, census, answers}) => {
      const known = [...map!.value].filter((_, cell) => map!.fails[cell] === 0);
      return {
        meeting: census!.meeting,
        total: answers.yields!.total,
        worst: known.reduce((a, b) => Math.min(a, b)),
        best: known.reduce((a, b) => Math.max(a, b)),
      };
    });
    expect(total).toBe(meeting);
    expect(worst).toBeLessThan(0.5);
    expect(best).toBeGreaterThan(0.99);
    await keep_screenshot(page, "yield");

    const {tau, place} = await read_state(page, ({picked}) => ({tau: picked!.tau, place: picked!.place!}));
    const at = await map_pixel(page, place);
    await page.mouse.move(at.x + 12, at.y + 12);
    await expect(page.getByTestId("region.card_analysis")).toHaveText(
      /^[\d.]+ mm RMS, [\d.]+ mm at worst · yield [\d.]+\u00a0%$/,
    );
    await expect.poll(() => read_state(page, (workbench) => workbench.hand!.tau)).not.toEqual(tau);
    await page.mouse.move(5, 5);

    // What is required by yield leaves fewer, and goes with the limit.
    await type_into(page, "req.min_yield", "90");
    await until_settled(page);
    await until_sampled(page);
    expect(await read_state(page, (workbench) => workbench.problem.requirements!.min_yield)).toBe(0.9);
    const left = await read_state(page, (workbench) => workbench.census!.meeting);
    expect(left).toBeGreaterThan(0);
    expect(left).toBeLessThan(meeting);
    await page.getByTestId("tolerance.each").click();
    await page.getByTestId("tolerance.limit").fill("");
    await page.getByTestId("tolerance.limit").press("Enter");
    await until_settled(page);
    expect(await read_state(page, ({problem}) => problem.requirements)).not.toHaveProperty("min_yield");
    expect(await read_state(page, (workbench) => workbench.census!.meeting)).toBe(meeting);
  });
});

test.describe("on a phone", () => {
  test.use({viewport: {width: 390, height: 844}, hasTouch: true, isMobile: true});

  test("have targets for fingers, and a place in the line", async ({page}) => {
    await open_workbench(page);
    await until_settled(page);
    await read_state(page, (workbench) => {
      workbench.edit((problem) => ({...problem, tolerances: {length: 0.5, limit: {position: 2}}}));
      workbench.sheet = "limits";
    });
    await page.getByTestId("tolerance.each").click();
    const low = await page
      .locator("[data-testid='tolerance.row'] :is(button, input, select):not(.unseen)")
      .evaluateAll((all) =>
        all.filter((one) => one.getBoundingClientRect().height < 43.5).map((one) => one.outerHTML.slice(0, 80)),
      );
    expect(low).toEqual([]);
    await page.evaluate(() => ((globalThis as any).__linkwright.preferences.colour_by = "tolerance_error"));
    await expect(page.getByTestId("region.upper_end")).toHaveCount(1);
    expect(await page.evaluate(() => document.querySelector(".app")!.scrollWidth)).toBe(390);
    await until_settled(page);
    await expect(page.getByTestId("num.line_analysis")).toContainText("mm");
  });
});
