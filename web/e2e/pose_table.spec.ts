// The table of positions.
import type {Page} from "@playwright/test";
import {example, expect, open_settled, poses_of_page, read_state, test, type_into, until_settled} from "./support";

test.beforeEach(({page}) => open_settled(page));

async function paste_into(page: Page, name: string, text: string): Promise<void> {
  await page.getByTestId(name).focus();
  await page.getByTestId(name).evaluate((field, pasted) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData("text/plain", pasted);
    field.dispatchEvent(new ClipboardEvent("paste", {clipboardData, bubbles: true, cancelable: true}));
  }, text);
}

test("takes arithmetic, units and steps; Enter goes down; undo goes back", async ({page}) => {
  const before = await poses_of_page(page);
  await type_into(page, "task.x.3", "=-440/2+5");
  expect((await poses_of_page(page))[2]!.x).toBe(-215);
  await expect(page.getByTestId("task.x.4")).toBeFocused();
  await type_into(page, "task.theta_deg.2", "-0,5rad");
  expect((await poses_of_page(page))[1]!.theta_deg).toBeCloseTo((-0.5 * 180) / Math.PI, 12);
  await type_into(page, "task.y.2", "80 mm", "Tab");
  expect((await poses_of_page(page))[1]!.y).toBe(80);
  for (let steps = 0; steps < 3; ++steps) await page.keyboard.press("Control+z");
  expect(await poses_of_page(page)).toEqual(before);

  await page.getByTestId("task.x.4").focus();
  for (const key of ["ArrowUp", "Shift+ArrowUp", "Alt+ArrowDown"]) await page.keyboard.press(key);
  expect((await poses_of_page(page))[3]!.x).toBe(-209.1);
  await page.keyboard.press("Control+z"); // steps within a second are one
  expect(await poses_of_page(page)).toEqual(before);
});

test("says what is wrong and keeps the last good value", async ({page}) => {
  const before = await poses_of_page(page);
  await type_into(page, "task.y.2", "12elve", "Tab"); // a letter alone is handed on to the page
  await expect(page.getByTestId("task.y.2")).toHaveAttribute("aria-invalid", "true");
  await expect(page.getByTestId("task.fault")).toContainText(
    "must be a number between −1 000 000 000 and 1 000 000 000. The last valid value is kept.",
  );
  expect(await poses_of_page(page)).toEqual(before);
  await page.getByTestId("task.y.2").focus();
  await page.keyboard.press("Escape");
  await expect(page.getByTestId("task.fault")).toHaveCount(0);
  await expect(page.getByTestId("task.y.2")).toHaveValue("75");
  await type_into(page, "task.y.2", "1e10", "Tab");
  await expect(page.getByTestId("task.fault")).toBeVisible();
  await type_into(page, "task.y.2", "75", "Tab");
  await expect(page.getByTestId("task.fault")).toHaveCount(0);

  // Refused by the engine: the same pose twice. Typed cell by cell, only the last one makes it so.
  await paste_into(page, "task.x.2", "0\t0\t0");
  await expect(page.getByTestId("task.fault").first()).toContainText("Position 2 is the same as an earlier one.");
  await expect(page.getByTestId("task.x.2")).toHaveAttribute("aria-invalid", "true");
  expect(await poses_of_page(page)).toEqual(before);
});

test("takes a pasted block as one step", async ({page}) => {
  const before = await poses_of_page(page);
  await paste_into(
    page,
    "task.x.1",
    "x\ty\tθ\r\n0\t0\t0\r\n-120,5\t80\t-25\r\n-210\t225,25\t-50\r\n-220\t440\t-80\r\n",
  );
  expect(await poses_of_page(page)).toEqual([
    {x: 0, y: 0, theta_deg: 0},
    {x: -120.5, y: 80, theta_deg: -25},
    {x: -210, y: 225.25, theta_deg: -50},
    {x: -220, y: 440, theta_deg: -80},
  ]);
  await page.keyboard.press("Control+z");
  expect(await poses_of_page(page)).toEqual(before);
  await paste_into(page, "task.y.3", "221; -53\n451; -83");
  expect((await poses_of_page(page)).slice(2)).toEqual([
    {x: -220, y: 221, theta_deg: -53},
    {x: -220, y: 451, theta_deg: -83},
  ]);
  await page.keyboard.press("Control+z");
  await paste_into(page, "task.x.1", "1\t2\t3\n4\tfive\t6");
  await expect(page.getByTestId("task.fault")).toHaveText(
    "Row 2, column 2: “five” is not a number. Nothing was pasted.",
  );
  expect(await poses_of_page(page)).toEqual(before);
});

test("reorders by keys and by drag, doubles, adds, removes, changes the reference", async ({page}) => {
  const before = await poses_of_page(page),
    [a, b, c, d] = before;
  await page.getByTestId("task.reorder.1").focus();
  await page.keyboard.press("Alt+ArrowDown");
  expect(await poses_of_page(page)).toEqual([b, a, c, d]);
  await expect(page.getByTestId("task.reorder.2")).toBeFocused();
  await page.keyboard.press("Control+z");
  expect(await poses_of_page(page)).toEqual(before);

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

  await page.getByTestId("task.add").click();
  expect((await poses_of_page(page))[4]).toEqual({x: -220, y: 680, theta_deg: -112});
  await page.getByTestId("task.add").click();
  await expect(page.getByTestId("task.missing")).toContainText("6 positions");
  for (const row of [6, 5]) {
    await page.getByTestId(`task.menu.${row}`).click();
    await page.getByTestId("task.remove").click();
  }
  expect(await poses_of_page(page)).toEqual(before);

  await page.getByTestId("task.menu.3").click();
  await page.getByTestId("task.make_reference").click();
  const moved = await poses_of_page(page);
  expect(moved[2]).toEqual({x: 0, y: 0, theta_deg: 0});
  expect(Math.hypot(moved[3]!.x - moved[0]!.x, moved[3]!.y - moved[0]!.y)).toBeCloseTo(
    Math.hypot(d!.x - a!.x, d!.y - a!.y),
    9,
  );
  await until_settled(page);
  // The same linkage, seen from elsewhere.
  const {lengths} = await read_state(page, (workbench) => workbench.hand!);
  await read_state(page, (workbench) => workbench.undo());
  await until_settled(page);
  const original = await read_state(page, (workbench) => workbench.hand!.lengths!);
  // Found again by its place, from a map whose own linkage may just have been followed.
  for (const link of ["ground", "input", "coupler", "output"] as const)
    expect(lengths![link] / original[link]).toBeCloseTo(1, 6);
});

test("holds directions and curvatures of travel", async ({page}) => {
  await page.getByTestId("task.menu.2").click();
  await page.getByTestId("task.tangent").click();
  await expect(page.getByTestId("task.pattern")).toHaveText("P-PP-P-P");
  await type_into(page, "task.direction_deg.2", "120");
  const {x, y} = (await poses_of_page(page))[1]!.derivatives![0]!;
  expect(x).toBeCloseTo(Math.cos((120 * Math.PI) / 180), 12);
  expect(y).toBeCloseTo(Math.sin((120 * Math.PI) / 180), 12);
  await page.getByTestId("task.menu.2").click();
  await page.getByTestId("task.curvature").click();
  await expect(page.getByTestId("task.pattern")).toHaveText("P-PPP-P-P");
  await page.getByTestId("task.pattern").hover();
  await expect(page.getByRole("tooltip")).toBeVisible();
  await page.getByTestId("task.menu.2").click();
  await page.getByTestId("task.next_derivative").click();
  await type_into(page, "task.curvature.2.3", "0.002");
  await type_into(page, "task.direction_deg.2", "60"); // keeps what stands below it
  await expect(page.getByTestId("task.curvature.2.3")).toHaveValue("0.002");
  await expect(page.getByTestId("task.pattern")).toHaveText("P-PPPP-P-P");
  await page.getByTestId("task.remove_derivative.2.2").click();
  await expect(page.getByTestId("task.pattern")).toHaveText("P-PP-P-P");
  await page.getByTestId("task.remove_derivative.2.1").click();
  expect(await poses_of_page(page)).toEqual(example("tailgate").task.poses);
});
