// What the drawing has beside positions and pivots: outlines, traced points, pictures; and handles by keys.
import type {Locator, Page} from "@playwright/test";
import type {MotionTask} from "../src/kinds/motion/task";
import {drag, expect, expect_accessible, middle_of, open_workbench, read_state, test, type Pixel} from "./support";

const handle = (page: Page, id: string): Locator => page.getByTestId(`drawing.${id}`);
const poses = (page: Page) =>
  read_state(page, (workbench) => (workbench.problem.task as MotionTask).poses.map((pose) => ({...pose})));
async function canvas(page: Page): Promise<Pixel & {width: number; height: number}> {
  return (await page.getByTestId("drawing.canvas").boundingBox())!;
}

async function give_outline(page: Page, inside: string): Promise<void> {
  const [chooser] = await Promise.all([
    page.waitForEvent("filechooser"),
    page.getByTestId("drawing.outline_file").click(),
  ]);
  const drawing = `<svg xmlns="http://www.w3.org/2000/svg" width="210mm" height="297mm" viewBox="0 0 210 297">${inside}</svg>`;
  await chooser.setFiles({name: "part.svg", mimeType: "image/svg+xml", buffer: Buffer.from(drawing)});
}

test.beforeEach(async ({page}) => {
  await open_workbench(page);
  await read_state(page, (workbench) => {
    workbench.tour = null; // its hint lies over the drawing
  });
});

test("handles go by Tab and by keys, an outline is edited at its corners, traced points draw their curves, a task is clicked together", async ({
  page,
}) => {
  await handle(page, "disc_2").focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  const step = await read_state(page, (workbench) => workbench.grid_step);
  expect((await poses(page))[1]!.x).toBeCloseTo(-125 + 2 * step, 9);
  await page.keyboard.press("Shift+ArrowUp");
  expect((await poses(page))[1]!.y).toBeCloseTo(75 + 10 * step, 9);
  while (await read_state(page, (workbench) => workbench.can_undo)) await page.keyboard.press("Control+z");
  expect((await poses(page))[1]).toMatchObject({x: -125, y: 75});
  await page.keyboard.press("Tab");
  await expect(handle(page, "knob_2")).toBeFocused();
  await page.keyboard.press("Alt+ArrowLeft");
  expect((await poses(page))[1]!.theta_deg).toBeCloseTo(-24.9, 9);
  await page.keyboard.press("Shift+Tab");
  await expect(handle(page, "disc_2")).toBeFocused();
  expect(await read_state(page, (workbench) => workbench.selected_pose)).toBe(1);

  await page.getByTestId("drawing.tools").click();
  await page.getByTestId("task.outline").last().click();
  const outline = () => read_state(page, (workbench) => workbench.problem.view?.outline ?? []);
  await give_outline(page, `<path d="M0 0h80v50h-100z"/><circle cx="70" cy="40" r="8"/>`);
  await expect(page.getByTestId("outline.choice").getByRole("radio")).toHaveCount(2);
  await expect_accessible(page, "[data-testid='outline.choice']");
  await page.keyboard.press("Escape");
  await expect(page.getByTestId("outline.choice")).toBeHidden();
  const corners = (await outline()).length;
  await handle(page, "midpoint_1").focus();
  const middle = await middle_of(handle(page, "midpoint_1"));
  await page.mouse.click(middle.x, middle.y);
  expect(await outline()).toHaveLength(corners + 1);
  const second = await middle_of(handle(page, "corner_2"));
  await drag(page, second, {x: second.x + 10, y: second.y + 30});
  await handle(page, "corner_2").focus();
  await page.keyboard.press("Delete");
  expect(await outline()).toHaveLength(corners);
  await page.getByTestId("drawing.outline_redraw").click();
  const disc = await middle_of(handle(page, "disc_1"));
  for (const [dx, dy] of [
    [-40, 20],
    [60, 20],
    [60, -30],
  ])
    await page.mouse.click(disc.x + dx!, disc.y + dy!);
  await page.keyboard.press("Enter");
  expect(await outline()).toHaveLength(3);
  await page.keyboard.press("Escape");
  await page.keyboard.press("t");
  await page.mouse.click(disc.x + 30, disc.y + 5);
  await page.keyboard.press("Escape");
  await expect(page.getByTestId("drawing.traced_1")).toBeAttached();
  expect(await read_state(page, (workbench) => workbench.problem.view!.traced!.length)).toBe(1);

  await read_state(page, (workbench) =>
    workbench.open({linkwright: 1, length_unit: "mm", task: {kind: "motion", mechanism: "four_bar", poses: []}}),
  );
  await expect(page.getByTestId("task.missing")).toBeVisible();
  const empty = await canvas(page);
  for (const [x, y] of [
    [0.4, 0.8],
    [0.3, 0.6],
    [0.25, 0.45],
    [0.35, 0.25],
  ])
    await page.mouse.click(empty.x + x! * empty.width, empty.y + y! * empty.height);
  expect(await poses(page)).toHaveLength(4);
  for (let k = 2; k <= 4; ++k) {
    await handle(page, `knob_${k}`).focus();
    for (let i = 0; i < k; ++i) await page.keyboard.press("Shift+ArrowLeft");
  }
  await page.waitForFunction(() => (globalThis as any).__linkwright.workbench.task?.status === "solved");
  await expect(page.getByTestId("task.missing")).toBeHidden();
  await page.mouse.wheel(0, 0);
  await page.getByTestId("view.fit").click();
});

test("a picture dropped on the drawing lies behind it and is brought to scale", async ({page}) => {
  const area = await canvas(page);
  await page.evaluate(async () => {
    const canvas = document.createElement("canvas");
    canvas.width = 3000;
    canvas.height = 1500;
    canvas.getContext("2d")!.fillRect(100, 100, 2000, 900);
    const blob = await new Promise<Blob>((resolve) => canvas.toBlob((b) => resolve(b!), "image/png"));
    const transfer = new DataTransfer();
    transfer.items.add(new File([blob], "car.png", {type: "image/png"}));
    document
      .querySelector(".drawing_card")!
      .dispatchEvent(new DragEvent("drop", {dataTransfer: transfer, bubbles: true, cancelable: true}));
  });
  await page.waitForFunction(() => !!(globalThis as any).__linkwright.workbench.problem.view?.background);
  const background = () => read_state(page, (workbench) => workbench.problem.view!.background!);
  const before = await background();
  expect(before.image.startsWith("data:image/jpeg")).toBe(true);
  expect(before.image.length).toBeLessThanOrEqual(400_000);
  expect(before.aspect).toBeCloseTo(0.5, 9);
  await page.mouse.click(area.x + 100, area.y + area.height - 120);
  await page.mouse.click(area.x + 300, area.y + area.height - 120);
  const scale = await page.getByTestId("drawing.ground_box").evaluate((box) => Number(box.getAttribute("width")) / 360);
  await page.getByTestId("drawing.mark_length").fill("1000");
  await page.keyboard.press("Enter");
  expect((await background()).width / before.width).toBeCloseTo(1000 / (200 / scale), 2);
  await page.getByTestId("drawing.done").click();
  await page.keyboard.press("Control+z");
  expect((await background()).width).toBe(before.width);
});
