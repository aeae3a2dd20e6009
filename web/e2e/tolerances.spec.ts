// Tolerances: the row that gives them, and what they open.
import type {Page} from "@playwright/test";
import {expect, keep_screenshot, map_pixel, open_settled, read_state, test, type_into, until_settled} from "./support";

const tolerances_of = (page: Page) => read_state(page, (workbench) => workbench.problem.tolerances ?? null);
const until_sampled = (page: Page) =>
  page.waitForFunction(() => {
    const {yields} = globalThis.__linkwright!.workbench.answers;
    return yields !== null && yields.done === yields.total;
  });

test("tolerances with a limit show yields, coarse to fine", async ({page}) => {
  await open_settled(page);
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
  await until_settled(page);
  expect(await read_state(page, (workbench) => workbench.hand!.tau)).not.toEqual(tau);
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
