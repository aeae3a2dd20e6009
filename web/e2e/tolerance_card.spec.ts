// What tolerances do: the card of the linkage in hand, bars to drag, samples on the drawing, the front of two objectives.
import {writeFileSync} from "node:fs";
import {readFileSync} from "node:fs";
import {join} from "node:path";
import type {Page} from "@playwright/test";
import type {ToleranceStudy} from "../src/analyses/tolerances/study.svelte";
import {
  examples,
  expect,
  expect_accessible,
  middle_of,
  open_settled,
  open_files,
  read_state,
  test,
  until_settled,
} from "./support";

const tolerances = {length: 0.5, limit: {position: 2}, cost: {exponent: 1}};

/** The example with tolerances, as somebody else has saved it. */
async function open_tailgate(page: Page): Promise<void> {
  const text = readFileSync(join(examples, "tailgate.json"), "utf8").replace(/^\s*\/\/.*$/gm, ""),
    path = test.info().outputPath("tailgate.json");
  writeFileSync(path, JSON.stringify({...JSON.parse(text), tolerances}));
  await open_files(page, path);
  await expect(page.getByTestId("tolerances.tab")).toBeVisible();
  await until_settled(page);
}
/** Of all samples, of the linkage in hand. */
const figures = (page: Page) =>
  read_state(page, ({studies}) => {
    const {figures} = studies.tolerances as ToleranceStudy;
    return figures && {error: figures.error, good: figures.yield};
  });
const until_sampled = (page: Page) =>
  expect
    .poll(() => read_state(page, ({studies}) => (studies.tolerances as ToleranceStudy | undefined)?.figures?.samples))
    .toBe(100_000);
const length_of = (page: Page) => read_state(page, ({problem}) => problem.tolerances?.length);

test("a bar that is dragged changes its tolerance, and all figures follow; the map points at the plot of the front", async ({
  page,
}) => {
  await open_settled(page);
  await open_tailgate(page);
  await page.getByTestId("tolerances.tab").click();
  await until_sampled(page);
  const before = (await figures(page))!;
  const bar = page.getByTestId("study.bar_output");
  await bar.scrollIntoViewIfNeeded();
  const track = (await bar.boundingBox())!,
    {y} = await middle_of(bar),
    end = track.x + (await bar.locator(".bar").boundingBox())!.width;
  await page.mouse.move(end, y);
  await page.mouse.down();
  await page.mouse.move(track.x + 0.3 * (end - track.x), y, {steps: 8});
  await expect.poll(async () => (await figures(page))!.error).toBeLessThan(0.95 * before.error);
  await page.mouse.up();
  const length = (await length_of(page)) as Record<string, number>;
  expect(length.output).toBeLessThan(0.35);
  expect(length.input).toBe(0.5);
  await until_sampled(page);
  expect((await figures(page))!.good).toBeGreaterThan(before.good!);
  await page.getByTestId("edit.undo").click();
  expect(await length_of(page)).toBe(0.5);

  await until_settled(page);
  await expect_accessible(page, "[data-testid='study.card']");

  // The plot of the front: a linkage that is pointed at on the map is shown in it, too.
  await page.getByTestId("front.tab").click();
  await expect(page.getByTestId("front.plot")).toBeVisible();
  await expect(page.getByTestId("front.hand")).toHaveCount(0);
  const box = (await page.getByTestId("region.map").boundingBox())!;
  await page.mouse.move(box.x + 0.22 * box.width, box.y + 0.2 * box.height);
  await expect(page.getByTestId("front.hand")).toHaveCount(1);
  await expect_accessible(page, "[data-testid='front.card']");
});
