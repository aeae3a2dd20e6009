// Points that run straight, on the page: examples, the line, the cases, layers, colours, links, phone.
import {readFileSync} from "node:fs";
import type {Page} from "@playwright/test";
import type {StraightLineTask} from "../src/tasks/straight_line/task";
import {
  drag,
  example,
  expect,
  expect_accessible,
  keep_screenshot,
  map_hash,
  map_pixel,
  middle_of,
  open_settled,
  open_workbench,
  read_state,
  solve,
  test,
  type_into,
  until_mapped,
  until_settled,
} from "./support";

async function open_example(page: Page, name: string): Promise<void> {
  await open_settled(page);
  await page.getByTestId("file.menu").click();
  await page.getByTestId("file.examples").click();
  await page.getByTestId(`example.${name}`).click();
  await until_settled(page);
}
const task_of = (page: Page) => read_state(page, ({problem}) => problem.task as StraightLineTask);
const line_of = (page: Page) => read_state(page, ({hand}) => hand!.straight_line!);

test("an example shows its line, its path and numbers that the program has as well", async ({page}) => {
  await open_example(page, "straight_watt_suspension");
  await expect(page.getByTestId("straight.line")).toBeAttached();
  await expect(page.getByTestId("straight.usable")).toBeAttached();
  await expect(page.getByTestId("straight.magnifier")).toBeVisible();
  await expect(page.getByTestId("straight.num.contact")).toHaveText("5");
  await expect(page.getByTestId("plot.profile")).toHaveAttribute("aria-selected", "true");
  const line = await line_of(page),
    problem = example("straight_watt_suspension"),
    there = solve({...problem, options: {...problem.options, region_samples: 16, at: line.place}}),
    [found] = there.linkages;
  expect(found.usable.length).toBeCloseTo(line.usable.length, 6);
  expect(found.contact_points).toBe(line.contact_points);
  expect(found.stroke.max_deviation).toBeCloseTo(line.stroke!.max_deviation, 9);
  const [cognate] = line.cognates;
  expect(cognate!.pivots.input_fixed).toEqual(found.cognates[0].pivots.input_fixed);
  const shown = page.getByTestId("straight.shown_cognate");
  await expect(shown).toHaveCount(0);
  await page.getByTestId("straight.cognate.0").click();
  await expect(shown).toBeAttached();
  await keep_screenshot(page, "straight_line");
  await expect_accessible(page);
  await page.getByTestId("straight.cognate.0").click();
  await expect(shown).toHaveCount(0);
});

test("the line is dragged and turned on the drawing, and each is one step", async ({page}) => {
  await open_example(page, "straight_luffing_crane");
  const before = await task_of(page),
    map = await map_hash(page);
  const point = await middle_of(page.getByTestId("drawing.line_point"));
  await drag(page, point, {x: point.x - 20, y: point.y + 30});
  const moved = await task_of(page);
  expect(moved.line.point[1]).toBeLessThan(before.line.point[1]);
  expect(moved.line.direction_deg).toBe(before.line.direction_deg);
  const knob = await middle_of(page.getByTestId("drawing.line_direction"));
  await drag(page, knob, {x: knob.x, y: knob.y - 40});
  expect((await task_of(page)).line.direction_deg).toBeGreaterThan(5);
  await until_mapped(page);
  expect(await map_hash(page)).not.toBe(map);
  await page.keyboard.press("Control+z");
  expect(await task_of(page)).toEqual(moved);
  await page.keyboard.press("Control+z");
  expect(await task_of(page)).toEqual(before);
});

test("each linkage under the pointer is shown with its numbers", async ({page}) => {
  await open_example(page, "straight_indicator");
  const place = await read_state(page, ({picked}) => picked!.place!),
    picked = await page.getByTestId("straight.num.usable").textContent();
  const {x, y} = await map_pixel(page, place);
  await page.mouse.move(x + 60, y - 40);
  await page.mouse.move(x + 40, y - 20);
  await expect
    .poll(() =>
      page
        .getByTestId("straight.num.usable")
        .textContent()
        .catch(() => null),
    )
    .not.toBe(picked);
  await page.mouse.move(5, 5);
  await expect(page.getByTestId("straight.num.usable")).toHaveText(picked!);
});

test("the map is coloured by what straight lines are worth", async ({page}) => {
  await open_example(page, "straight_indicator");
  const types = await map_hash(page);
  await page.getByTestId("straight.stroke_over_longest").click();
  await until_mapped(page);
  await expect.poll(() => map_hash(page)).not.toBe(types);
  await page.getByTestId("region.map").focus();
  for (let press = 0; press < 3; ++press) await page.keyboard.press("c");
  await expect.poll(() => read_state(page, ({map}) => map!.property)).toBe("deviation");
});

test("another case keeps the line and has its own fields, and its layers are shown one at a time", async ({page}) => {
  await open_example(page, "straight_indicator");
  const {line} = await task_of(page);
  await page.getByTestId("straight.case").selectOption("six_point");
  await until_settled(page);
  expect(await task_of(page)).toEqual({
    kind: "straight_line",
    mechanism: "four_bar",
    case: "six_point",
    line,
    pole_distance: expect.any(Number),
  });
  await type_into(page, "straight.pole_distance", "80");
  expect((await task_of(page)).pole_distance).toBe(80);
  await until_settled(page);
  const rows = await read_state(page, ({map}) => map!.rows);
  await page.getByTestId("region.sheet.II").click();
  await expect.poll(() => read_state(page, ({map}) => map!.window.input[0])).toBeCloseTo(1 / 3, 9);
  expect(await read_state(page, ({map}) => map!.rows)).not.toBe(rows);
  await page.getByTestId("straight.case").selectOption("pole_at_given_pivot");
  await until_mapped(page);
  await page.getByTestId("straight.case").selectOption("mixed");
  await until_settled(page);
  await page.getByTestId("straight.pattern").selectOption("PP-PP");
  expect((await task_of(page)).contacts!.map(({multiplicity}) => multiplicity)).toEqual([2, 2]);
  await until_settled(page);
  await page.getByTestId("straight.contact.2.side").click();
  expect((await task_of(page)).contacts![1]!.side).toBe(-1);
});

test("deviation, stroke and ranges are asked for, and a link brings them all back", async ({page, context}) => {
  await open_example(page, "straight_watt_suspension");
  const before = await line_of(page);
  await type_into(page, "straight.deviation", "0.2");
  await until_settled(page);
  expect((await line_of(page)).deviation).toBe(0.2);
  expect((await line_of(page)).usable.length).toBeLessThan(before.usable.length);
  await type_into(page, "straight.range.input.1", "300");
  await until_settled(page);
  const problem = await read_state(page, ({problem: {task, options}}) => ({task, options}));
  expect(problem.options!.window).toEqual([
    [60, 300],
    [-400, -60],
  ]);
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.getByTestId("share.link").click();
  const link = await page.evaluate(() => navigator.clipboard.readText());
  const other = await context.newPage();
  await open_workbench(other, new URL(link).pathname + new URL(link).hash);
  await until_settled(other);
  expect(await read_state(other, ({problem: {task, options}}) => ({task, options}))).toMatchObject(problem);
  await other.close();
});

test("a search over all cases lists linkages, and each opens the map of its case", async ({page}) => {
  await open_settled(page);
  await page.getByTestId("bar.new").click();
  await page.getByTestId("new.straight_search").click();
  await page.getByTestId("new.create").click();
  await page.getByTestId("straight.start").click();
  await expect(page.getByTestId("straight.ended")).toContainText("found");
  await expect(page.getByTestId("region.notice").getByTestId("straight.found.2")).toBeVisible();
  await page.getByTestId("straight.found.2").click();
  await until_settled(page);
  const line = await line_of(page);
  expect(line.usable_strip.length).toBeGreaterThan(99.9);
  expect(line.deviation).toBe(0.05);
  expect((await task_of(page)).case).not.toBe("search");
  expect(await read_state(page, ({hand}) => hand!.fails)).toBe(0);
  await keep_screenshot(page, "straight_search");
  await expect_accessible(page);
  await page.keyboard.press("Control+z");
  expect((await task_of(page)).case).toBe("search");
  await page.getByTestId("straight.start").click();
  await page.getByTestId("straight.stop").click();
  await expect(page.getByTestId("straight.start")).toBeVisible();
});

test("its linkages are taken away as files", async ({page}) => {
  await open_example(page, "straight_stage");
  await page.getByTestId("export.title").click();
  for (const [format, mark] of [
    ["svg", "<svg"],
    ["dxf", "SECTION"],
    ["csv", ","],
    ["json", '"pivots"'],
  ] as const) {
    const [download] = await Promise.all([page.waitForEvent("download"), page.getByTestId(`export.${format}`).click()]);
    expect(readFileSync(await download.path(), "utf8")).toContain(mark);
  }
});

test("it speaks Chinese", async ({page}) => {
  await open_example(page, "straight_walking_leg");
  await page.getByTestId("view.language").click();
  const panel = page.getByTestId("straight.about");
  await expect(panel).toHaveText(/\p{Script=Han}/u);
  for (const part of ["straight.numbers", "straight.measuring"])
    expect((await page.getByTestId(part).innerText()).replace(/\b(mm|e)\b|[SδeE]/g, "")).not.toMatch(/[a-z]{3}/i);
});

test.describe("on a phone", () => {
  test.use({viewport: {width: 390, height: 844}, hasTouch: true});
  test("drawing and map are both there, and the magnifier opens", async ({page}) => {
    await open_workbench(page);
    const problem = example("straight_luffing_crane");
    await read_state(page, (workbench, opened) => workbench.open(opened as never), problem);
    await until_settled(page);
    await expect(page.getByTestId("straight.line")).toBeAttached();
    const head = page.getByTestId("straight.magnifier_open");
    expect((await head.boundingBox())!.height).toBeGreaterThanOrEqual(44);
    await head.tap();
    await expect(page.getByTestId("straight.stretch_value")).toContainText("×");
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    expect(wide).toBeLessThanOrEqual(390);
    await keep_screenshot(page, "straight_line_phone");
  });
});
