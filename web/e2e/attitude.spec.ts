// The attitude of a body: turned by hand, shown in every form, played turn by turn.
import type {Page} from "@playwright/test";
import {readFileSync} from "node:fs";
import {link_of} from "../src/shell/share";
import {
  attitude_report,
  drag,
  expect,
  expect_accessible,
  file_menu,
  middle_of,
  open_workbench,
  read_state,
  test,
  type_into,
} from "./support";

interface Turned {
  kind: string;
  orientation: Record<string, unknown>;
}
const task = (page: Page) => read_state(page, ({problem}) => problem.task as unknown as Turned);
const numbers = (text: string) => (text.replaceAll("−", "-").match(/-?\d+(\.\d+)?/g) ?? []).map(Number);

async function open_attitude(page: Page): Promise<void> {
  await open_workbench(page);
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

test("a ring is dragged: every form follows, in one step that is taken back", async ({page}) => {
  await open_attitude(page);
  const before = await quaternion(page);
  const knob = await middle_of(page.getByTestId("attitude.view.ring.x"));
  await drag(page, knob, await beside(page, "attitude.view.ring.x", 30, -60), 8);
  await expect.poll(() => quaternion(page)).not.toEqual(before);
  const after = await quaternion(page);
  expect(Math.hypot(...after)).toBeCloseTo(1, 5);
  const {orientation} = await task(page);
  expect(Object.keys(orientation).sort()).toEqual(["euler_deg", "sequence"]);
  const written = numbers(await page.getByTestId("attitude.angles").locator("tr", {hasText: "zxz"}).innerText());
  for (const [k, angle] of (orientation.euler_deg as number[]).entries()) expect(written[k]).toBeCloseTo(angle, 2);
  await page.keyboard.press("Control+z");
  await expect.poll(() => quaternion(page)).toEqual(before);
});

test("arrow keys turn a ring by a degree, Escape gives a drag up", async ({page}) => {
  await open_attitude(page);
  await type_into(page, "attitude.orientation.euler_deg.1", "0");
  await type_into(page, "attitude.orientation.euler_deg.2", "0");
  await page.getByTestId("attitude.view.ring.z").focus();
  await page.keyboard.press("ArrowRight");
  await expect
    .poll(async () => (await task(page)).orientation.euler_deg)
    .toEqual([expect.closeTo(41, 9), expect.closeTo(0, 9), expect.closeTo(0, 9)]);
  const before = await task(page);
  await drag(page, await middle_of(page.getByTestId("attitude.view.ring.y")), {x: 500, y: 300}, 5, async () => {
    await expect.poll(async () => JSON.stringify(await task(page))).not.toBe(JSON.stringify(before));
    await page.keyboard.press("Escape");
  });
  await expect.poll(() => task(page)).toEqual(before);
});

test("three turns are played one after the other, and the lock is announced", async ({page}) => {
  await open_attitude(page);
  await page.getByTestId("attitude.tab.turns").click();
  await page.getByTestId("attitude.stop.0").click();
  await expect(page.getByTestId("attitude.panel").locator("table.matrix").first()).toContainText("1.00000");
  await page.getByTestId("attitude.play").click();
  await expect(page.getByTestId("attitude.scrub")).toHaveValue("3");
  await expect(page.getByTestId("attitude.panel").locator("table.matrix").first()).toContainText("0.39052");
  await expect(page.getByTestId("orientation.locked")).toHaveCount(0);
  await type_into(page, "attitude.turn.1", "0");
  await expect(page.getByTestId("orientation.locked").first()).toContainText("t₁ + t₃ = 75.0000°");
  await expect(page.getByTestId("attitude.gauge")).toContainText("locked");
  await page.getByTestId("attitude.sequence").selectOption("xyz");
  await expect(page.getByTestId("attitude.gauge")).not.toContainText("locked");
  await page.getByTestId("attitude.extrinsic").click();
  await expect(page.getByTestId("attitude.extrinsic")).toHaveAttribute("aria-pressed", "true");
});

test("a cone, a screw and an angular velocity have their numbers", async ({page}) => {
  await open_attitude(page);
  await page.getByTestId("attitude.tab.rotation").click();
  await expect(page.getByTestId("attitude.one_turn")).toContainText("88.0524°");
  await expect(page.getByTestId("attitude.image")).toHaveText("(0.390519, 0.808972, 0.439385)");
  await page.getByTestId("attitude.tab.screw").click();
  await expect(page.getByTestId("attitude.screw")).toContainText("41.89322 mm");
  for (const k of [0, 1, 2]) await type_into(page, `attitude.second.${k}`, "0");
  await expect(page.getByTestId("attitude.screw")).toContainText("rotation about one axis");
  await page.getByTestId("attitude.make_first").click();
  await expect(page.getByTestId("attitude.screw")).toContainText("nothing moves");
  await page.getByTestId("attitude.tab.rates").click();
  await expect(page.getByTestId("attitude.omega")).toContainText("1.45125 rad/s");
  await expect_accessible(page);
});

test("what is no orientation is refused with a sentence, and the last one stays", async ({page}) => {
  await open_attitude(page);
  await page.getByTestId("attitude.orientation.form").selectOption("axis");
  await expect.poll(async () => Object.keys((await task(page)).orientation).sort()).toEqual(["angle_deg", "axis"]);
  await page.getByTestId("attitude.orientation.form").selectOption("matrix");
  await type_into(page, "attitude.orientation.matrix.0", "2");
  await expect(page.getByTestId("task.fault").first()).toContainText("rotation");
  await expect(page.getByTestId("attitude.matrix")).toContainText("0.390519");
  await page.getByTestId("attitude.tab.screw").click();
  await page.getByTestId("attitude.first").click();
  await page.getByTestId("attitude.from.form").selectOption("quaternion");
  await type_into(page, "attitude.from.quaternion.0", "0");
  await page.waitForTimeout(500); // the sentence stays
  await expect(page.getByTestId("task.fault").filter({hasText: "all four components are zero"})).toBeVisible();
});

test("it is taken away: reports as the program writes them, a picture, a representation", async ({page, context}) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await open_attitude(page);
  await page.getByTestId("export.title").click();
  const taken = async (format: string) => {
    const [download] = await Promise.all([
      page.waitForEvent("download"),
      page.getByTestId(`export.task.${format}`).click(),
    ]);
    return {name: download.suggestedFilename(), data: readFileSync(await download.path())};
  };
  const convert = await taken("convert"),
    report = JSON.parse(convert.data.toString());
  expect(convert.name).toBe("linkage-convert.json");
  const orientation = {euler_deg: [40, 50, 35], sequence: "zxz"},
    program = attitude_report("convert", {orientation, vectors: [[1, 0, 0]]});
  expect(Object.keys(report).sort()).toEqual(Object.keys(program).sort());
  for (const [k, component] of program.quaternion.entries()) expect(report.quaternion[k]).toBeCloseTo(component, 14);
  expect(JSON.parse((await taken("screw")).data.toString()).screw.slide).toBeCloseTo(41.89322, 4);
  expect(JSON.parse((await taken("rates")).data.toString()).fixed.velocity).toHaveLength(3);
  const picture = await taken("png");
  expect(picture.name).toBe("linkage.png");
  expect(picture.data.length).toBeGreaterThan(5000);
  await expect(page.getByTestId("export.csv")).toHaveCount(0);
  await page.keyboard.press("Escape");
  await page.getByRole("button", {name: "Copy: Quaternion"}).click();
  expect(JSON.parse(await page.evaluate(() => navigator.clipboard.readText()))).toEqual(report.quaternion);
});

test("half a turn has its Rodrigues vector at infinity; at the lock it is said", async ({page}) => {
  await open_attitude(page);
  await page.getByTestId("attitude.orientation.form").selectOption("axis");
  await type_into(page, "attitude.orientation.axis.3", "180");
  await expect(page.getByTestId("attitude.panel")).toContainText("infinity");
});

test("it is kept, and shared by a link", async ({page}) => {
  await open_attitude(page);
  await type_into(page, "attitude.orientation.euler_deg.0", "12.5");
  await page.reload();
  await expect(page.getByTestId("attitude.panel")).toBeVisible();
  await expect.poll(async () => (await task(page)).orientation.euler_deg).toEqual([12.5, 50, 35]);
  const link = link_of(await read_state(page, ({whole_problem}) => whole_problem), page.url())!;
  await file_menu(page, "file.examples");
  await page.getByTestId("example.tailgate").click();
  await expect.poll(async () => (await task(page)).kind).toBe("motion");
  await page.evaluate((hash) => (location.hash = hash), new URL(link).hash);
  await expect.poll(async () => (await task(page)).orientation?.euler_deg).toEqual([12.5, 50, 35]);
  await page.keyboard.press("Control+z");
  await expect.poll(async () => (await task(page)).kind).toBe("motion");
});

test("it speaks Chinese", async ({page}) => {
  await open_attitude(page);
  await page.getByTestId("view.language").click();
  await expect(page.getByTestId("attitude.tab.turns")).toHaveText("三次转动");
  await expect(page.getByTestId("attitude.panel")).toContainText("方向余弦矩阵");
});

test.describe("on a phone", () => {
  test.use({viewport: {width: 390, height: 844}});
  test("view and numbers stand one above the other", async ({page}) => {
    await open_attitude(page);
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
