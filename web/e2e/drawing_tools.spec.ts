// What the drawing has beside positions and pivots: outlines and traced points, and a task begun there.
import type {Locator, Page} from "@playwright/test";
import type {MotionTask} from "../src/kinds/motion/task";
import {
  drag,
  expect,
  expect_accessible,
  middle_of,
  open_workbench,
  read_state,
  test,
  until_settled,
  type Pixel,
} from "./support";

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

test("an outline is edited at its corners, traced points draw their curves, a task is clicked together", async ({
  page,
}) => {
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
  await until_settled(page);
  expect(await read_state(page, ({task}) => task!.status)).toBe("solved");
  await expect(page.getByTestId("task.missing")).toBeHidden();
  await page.mouse.wheel(0, 0);
  await page.getByTestId("view.fit").click();
});
