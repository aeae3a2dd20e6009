// The panels by the mouse, as they lie, and for everybody. What is in them: src/*/*.dom.test.ts.
import {readFileSync} from "node:fs";
import type {Page} from "@playwright/test";
import {
  expect,
  expect_accessible,
  keep_screenshot,
  open_settled,
  poses_of_page,
  read_state,
  set_theme,
  test,
  type_into,
  until_settled,
} from "./support";

type Hooked = {__linkwright: {workbench: any; preferences: any}};

test.beforeEach(({page}) => open_settled(page));

const meeting = (page: Page): Promise<number> => read_state(page, (workbench) => workbench.census!.meeting);

test("positions are dragged into another order, and Escape gives a drag up; the pattern explains itself", async ({
  page,
}) => {
  const before = await poses_of_page(page),
    [a, b, c, d] = before;
  const from = (await page.getByTestId("task.reorder.4").boundingBox())!,
    to = (await page.getByTestId("task.reorder.2").boundingBox())!;
  await page.mouse.move(from.x + 8, from.y + 12);
  await page.mouse.down();
  await page.mouse.move(to.x + 8, to.y + 12, {steps: 5});
  expect(await poses_of_page(page)).toEqual([a, d, b, c]);
  await page.keyboard.press("Escape");
  expect(await poses_of_page(page)).toEqual(before);
  await page.mouse.up();
  await page.mouse.move(from.x + 8, from.y + 12);
  await page.mouse.down();
  await page.mouse.move(to.x + 8, to.y + 12, {steps: 5});
  await page.mouse.up();
  expect(await poses_of_page(page)).toEqual([a, d, b, c]);
  await read_state(page, (workbench) => workbench.undo()); // one drag, one step
  expect(await poses_of_page(page)).toEqual(before);

  await page.getByTestId("task.pattern").hover();
  await expect(page.getByRole("tooltip")).toBeVisible();
});

test("a requirement's slider is live, one drag is one undo, Esc takes it back; rows and hints keep their places", async ({
  page,
}) => {
  const before = await read_state(page, (workbench) => JSON.stringify(workbench.problem));
  const slider = page.getByTestId("req.min_transmission"),
    box = (await slider.boundingBox())!;
  const at = (share: number) => [box.x + 8 + share * (box.width - 16), box.y + box.height / 2] as const;
  await page.mouse.move(...at(30 / 89));
  await page.mouse.down();
  const seen = new Set<number>(),
    asked = () => read_state(page, (workbench) => workbench.problem.requirements!.min_transmission_angle_deg);
  for (const share of [0.45, 0.6, 0.75]) {
    const last = await asked();
    await page.mouse.move(...at(share));
    await expect.poll(asked).not.toBe(last); // a slider hears of the pointer with the next frame
    await until_settled(page);
    seen.add(await meeting(page));
  }
  expect(seen.size).toBe(3);
  await page.keyboard.press("Escape");
  expect(await read_state(page, (workbench) => JSON.stringify(workbench.problem))).toBe(before);
  await page.mouse.up();
  await expect(slider).toHaveValue("30");
  await page.mouse.move(...at(30 / 89));
  await page.mouse.down();
  for (const share of [0.45, 0.6, 0.75]) await page.mouse.move(...at(share));
  await page.mouse.up();
  await page.waitForFunction(() => !(globalThis as unknown as Hooked).__linkwright.workbench.gesture);
  expect(await asked()).toBeGreaterThan(50);
  await read_state(page, (workbench) => workbench.undo());
  expect(await read_state(page, (workbench) => [JSON.stringify(workbench.problem), workbench.can_undo])).toEqual([
    before,
    false,
  ]);

  // Rows stay where they are under the hand that types, whatever becomes of the counts.
  await type_into(page, "req.min_transmission.number", "89");
  await until_settled(page);
  await page.getByTestId("req.relax.min_transmission_angle_deg").click();
  await until_settled(page);
  const tops = () =>
      page
        .locator("[data-testid^='req.row.']")
        .evaluateAll((rows) => rows.map((row) => row.getBoundingClientRect().top)),
    stood = await tops();
  await type_into(page, "req.max_length", "5");
  await until_settled(page);
  expect(await meeting(page)).toBe(0);
  expect(await tops()).toEqual(stood);
  await keep_screenshot(page, "none-left");

  await read_state(page, (workbench) => {
    while (workbench.can_undo) workbench.undo();
    workbench.edit((problem) => ({
      ...problem,
      requirements: {...problem.requirements, ground_pivots_within: {x: [-45, -44.5], y: [175, 175.5]}},
    }));
  });
  const hint = page.getByTestId("req.relax.ground_pivots_within");
  await expect(hint).toBeVisible();
  const hinted = (await hint.boundingBox())!,
    card = (await page.getByTestId("req.title").boundingBox())!;
  expect(hinted.x + hinted.width).toBeLessThanOrEqual(card.x + card.width);
  expect(await hint.evaluate((one) => one.scrollWidth - one.clientWidth)).toBeLessThanOrEqual(0);
});

test("the panels and what they open are accessible, light and dark; files and the clipboard get what is taken", async ({
  page,
  context,
}) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.getByTestId("pin.add").click();
  await until_settled(page);
  await keep_screenshot(page, "wide-light");
  await page.getByTestId("tolerance.add").click();
  await page.getByTestId("tolerance.each").click();
  for (const theme of ["light", "dark"] as const) {
    await set_theme(page, theme);
    const panels = ["task.title", "req.title", "pin.title", "num.title"];
    await expect_accessible(page, "footer", ...panels.map((name) => `[data-testid='${name}']`));
  }
  await set_theme(page, "light");
  await page.getByTestId("num.copy_lengths").click();
  const row = (await page.evaluate(() => navigator.clipboard.readText())).split("\t");
  expect(row.map(Number).every((length) => length > 0)).toBe(true);

  await page.getByTestId("pin.compare").click();
  const dialog = page.getByTestId("pin.compare_dialog");
  await expect(dialog.locator(".u-over")).toBeVisible();
  await expect_accessible(page, "[data-testid='pin.compare_dialog']");
  await keep_screenshot(page, "compare");
  const [table] = await Promise.all([page.waitForEvent("download"), page.getByTestId("pin.export_table").click()]);
  expect(readFileSync(await table.path(), "utf8")).toContain("Longest link");
});
