// Loads: their card, a stud dragged on the drawing, what is required of the hand, and the map by its force.
import {writeFileSync} from "node:fs";
import type {Page} from "@playwright/test";
import type {PlaceStudy} from "../src/analyses/loads/place_study.svelte";
import type {LoadStudy} from "../src/analyses/loads/study.svelte";
import {
  drag,
  example,
  expect,
  expect_accessible,
  map_hash,
  middle_of,
  open_files,
  open_settled,
  read_state,
  test,
  type_into,
  until_settled,
} from "./support";

/** The tailgate with the struts of another example, as somebody else has saved it; nothing is asked of them yet. */
async function open_struts(page: Page, of_strut = {}): Promise<void> {
  const path = test.info().outputPath("struts.json"),
    {loads} = example("tailgate_struts"),
    springs = [{...loads.springs[0], ...of_strut}];
  writeFileSync(path, JSON.stringify({...example("tailgate"), loads: {...loads, springs, cases: [{name: "room"}]}}));
  await open_files(page, path);
  await expect(page.getByTestId("loads.tab")).toBeVisible();
  await until_settled(page);
}
const opens_with = (page: Page) =>
  read_state(page, ({studies}) => (studies.loads as LoadStudy).found?.loads.cases[0]?.max_open_force ?? null);
const stud_of = (page: Page) =>
  read_state(page, ({problem}) => {
    const spring = problem.loads?.springs?.[0];
    return spring && "from" in spring ? spring.from.at : null;
  });

test("a stud that is dragged changes what the hand feels; a requirement on it is red, and colours the map", async ({
  page,
}) => {
  test.slow();
  await open_settled(page);
  // With room for its stud: of a place that it does not reach the engine would have nothing, and no step would be left.
  await open_struts(page, {extended_length: 350, stroke: 175});
  await page.getByTestId("loads.tab").click();
  await expect(page.getByTestId("loads.read_outs")).toBeVisible();
  await expect(page.getByTestId("loads.plot").locator("canvas")).toBeVisible();
  const [before, stud] = [await opens_with(page), await stud_of(page)];

  await expect(page.getByTestId("loads.strip_1")).toBeVisible();
  await expect(page.getByTestId("drawing.force_hand")).toBeAttached();
  await page.getByTestId("loads.over").selectOption("path");
  await expect(page.getByTestId("loads.now")).toContainText("%");
  const angle = () => read_state(page, ({angle}) => angle),
    rested = await angle(),
    over = await middle_of(page.getByTestId("loads.plot").locator(".u-over"));
  await page.mouse.move(over.x, over.y - 20);
  await expect.poll(angle).not.toBe(rested);
  await page.mouse.move(0, 0); // it goes back
  await expect.poll(angle).toBe(rested);

  const handle = page.getByTestId("drawing.load_spring_1_from"),
    {x, y} = await middle_of(handle);
  await drag(page, {x, y}, {x: x + 6, y: y + 4});
  expect(await stud_of(page)).not.toEqual(stud);
  await expect.poll(() => opens_with(page)).not.toBe(before);
  await page.getByTestId("edit.undo").click();
  expect(await stud_of(page)).toEqual(stud);
  await expect.poll(() => opens_with(page)).toBe(before);

  await type_into(page, "req.min_hold_open", "900");
  await expect(page.getByTestId("loads.hold_open_1")).toContainText("needs ≥ 900 N: ");
  await page.getByTestId("edit.undo").click();

  const hash = await map_hash(page);
  await page.getByTestId("region.menu").click();
  await page.getByTestId("region.color.hand_force").click();
  await expect.poll(() => read_state(page, ({map}) => map?.property)).toBe("hand_force");
  await expect.poll(() => map_hash(page)).not.toBe(hash);
  await expect_accessible(page, "[data-testid='loads.card']");

  await page.getByTestId("loads.each").click();
  await page.getByTestId("loads.rare_fold").click();
  await page.getByTestId("loads.extra_fold").click();
  await expect_accessible(page, "[data-testid='loads.row']");
});

test("two struts are placed within boxes: proved, taken as one step, and the boxes are dragged on the drawing", async ({
  page,
}) => {
  test.slow();
  await open_settled(page);
  await open_struts(page);
  await page.getByTestId("loads.tab").click();
  await expect(page.getByTestId("loads.read_outs")).toBeVisible();
  await page.getByTestId("loads.place").click();
  const force = () =>
    read_state(page, ({studies}) => {
      const {found} = studies.loads as LoadStudy,
        of = found?.loads.cases[0];
      return of ? Math.max(of.max_open_force!, of.max_close_force!) : null;
    });
  const before = (await force())!;
  await type_into(page, "loads.place_hold_open", "13");
  const corner = await middle_of(page.getByTestId("drawing.place_ground_ne"));
  await drag(page, corner, {x: corner.x + 20, y: corner.y - 10});
  const high = Number(await page.getByTestId("loads.place_ground_x_high").inputValue());
  expect(high).toBeGreaterThan(230);
  await page.getByTestId("loads.place_map").selectOption("ground");
  await expect(page.getByTestId("drawing.place_map")).toBeAttached();
  await expect(page.getByTestId("loads.place_scale")).toContainText(/N.*N or more/);
  await page.getByTestId("loads.place_map").selectOption("none");

  await page.getByTestId("loads.place_start").click();
  const result = page.getByTestId("loads.place_result");
  await expect(result).toHaveText(/N in the hand.*; nothing below .* N, proved \([\d.]+ %\)\.$/);
  await expect(page.getByTestId("drawing.place_found")).toBeAttached();
  await expect_accessible(page, "[data-testid='loads.card']");
  const stud = await stud_of(page);
  await page.getByTestId("loads.place_take").click();
  await expect(page.getByTestId("loads.place_take")).toBeDisabled();
  expect(await stud_of(page)).not.toEqual(stud);
  // What the engine tells of it beside its search is what the search has told.
  const told = await read_state(page, ({studies}) => (studies.place_springs as PlaceStudy).placed!.max_hand_force);
  await expect.poll(async () => Math.abs((await force())! - told!) < 1e-3 * told!).toBe(true);
  expect(told).toBeLessThan(before);
  await page.getByTestId("edit.undo").click();
  expect(await stud_of(page)).toEqual(stud);
});
