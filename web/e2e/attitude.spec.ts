// The attitude of a body: turned by hand, shown in every form, played turn by turn.
import type {Page} from "@playwright/test";
import {readFileSync} from "node:fs";
import {
  drag,
  expect,
  expect_accessible,
  middle_of,
  open_workbench,
  read_state,
  test,
  type_into,
  until_answered,
} from "./support";

interface Turned {
  kind: string;
  orientation: Record<string, unknown>;
}
const task = (page: Page) => read_state(page, ({problem}) => problem.task as unknown as Turned);
const numbers = (text: string) => (text.replaceAll("−", "-").match(/-?\d+(\.\d+)?/g) ?? []).map(Number);

async function begin_attitude(page: Page): Promise<void> {
  await page.getByTestId("bar.new").click();
  await page.getByTestId("new.attitude").click();
  await page.getByTestId("new.create").click();
  await expect(page.getByTestId("attitude.quaternion")).toContainText("0.719022");
  await expect(page.getByTestId("attitude.view")).not.toHaveAttribute("data-drawn", "0");
}
async function quaternion(page: Page): Promise<number[]> {
  return numbers(await page.getByTestId("attitude.quaternion").innerText());
}
/** From the middle of the view outwards by so many times. */
async function beside(page: Page, testid: string, dx: number, dy: number) {
  const {x, y} = await middle_of(page.getByTestId(testid));
  return {x: x + dx, y: y + dy};
}

test("a ring is dragged: every form follows, in one step that is taken back; a ring is turned by keys; a picture is taken; and on a phone", async ({
  page,
}) => {
  await open_workbench(page);
  await begin_attitude(page);
  const before = await quaternion(page);
  const knob = await middle_of(page.getByTestId("attitude.view.ring.x"));
  await drag(page, knob, await beside(page, "attitude.view.ring.x", 30, -60), 8);
  await expect.poll(() => quaternion(page)).not.toEqual(before);
  await until_answered(page);
  const after = await quaternion(page);
  expect(Math.hypot(...after)).toBeCloseTo(1, 5);
  const {orientation} = await task(page);
  expect(Object.keys(orientation).sort()).toEqual(["euler_deg", "sequence"]);
  const written = numbers(await page.getByTestId("attitude.angles").locator("tr", {hasText: "zxz"}).innerText());
  for (const [k, angle] of (orientation.euler_deg as number[]).entries()) expect(written[k]).toBeCloseTo(angle, 2);
  await page.keyboard.press("Control+z");
  await expect.poll(() => quaternion(page)).toEqual(before);

  // Arrow keys turn a ring by a degree, Escape gives a drag up.
  await type_into(page, "attitude.orientation.euler_deg.1", "0");
  await type_into(page, "attitude.orientation.euler_deg.2", "0");
  await page.getByTestId("attitude.view.ring.z").focus();
  await page.keyboard.press("ArrowRight");
  await expect
    .poll(async () => (await task(page)).orientation.euler_deg)
    .toEqual([expect.closeTo(41, 9), expect.closeTo(0, 9), expect.closeTo(0, 9)]);
  const typed = await task(page);
  await drag(page, await middle_of(page.getByTestId("attitude.view.ring.y")), {x: 500, y: 300}, 5, async () => {
    await expect.poll(async () => JSON.stringify(await task(page))).not.toBe(JSON.stringify(typed));
    await page.keyboard.press("Escape");
  });
  await expect.poll(() => task(page)).toEqual(typed);
  await expect_accessible(page);

  await page.getByTestId("export.title").click();
  const [picture] = await Promise.all([page.waitForEvent("download"), page.getByTestId("export.task.png").click()]);
  expect(picture.suggestedFilename()).toBe("linkage.png");
  expect(readFileSync(await picture.path()).length).toBeGreaterThan(5000);
  await page.keyboard.press("Escape");

  await test.step("on a phone view and numbers stand one above the other", async () => {
    await begin_attitude(page);
    await page.setViewportSize({width: 390, height: 844});
    const before = await quaternion(page);
    await drag(
      page,
      await middle_of(page.getByTestId("attitude.view.ring.z")),
      await beside(page, "attitude.view.ring.z", 40, 10),
    );
    await expect.poll(() => quaternion(page)).not.toEqual(before);
    const stage = (await page.getByTestId("attitude.stage").boundingBox())!,
      panel = (await page.getByTestId("attitude.panel").boundingBox())!;
    expect(stage.height).toBeGreaterThan(280);
    expect(panel.y).toBeGreaterThanOrEqual(stage.y + stage.height - 1);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
    await page.getByTestId("tab.task").click();
    await expect(page.getByTestId("attitude.orientation.form")).toBeVisible();
  });
});
