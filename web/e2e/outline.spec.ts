// The body's outline out of a drawing of another program.
import {expect, expect_accessible, keep_screenshot, open_workbench, read_state, test, toasts} from "./support";
import type {Page} from "@playwright/test";

const plate = '<g transform="translate(40 20)"><path id="plate" d="M0 0h80a20 20 0 0 1 20 20v30h-100z"/></g>';
const page_of = (inside: string) =>
  `<svg xmlns="http://www.w3.org/2000/svg" width="210mm" height="297mm" viewBox="0 0 210 297">${inside}</svg>`;

async function give(page: Page, name: string, text: string): Promise<void> {
  const [chooser] = await Promise.all([
    page.waitForEvent("filechooser"),
    page.getByTestId("drawing.outline_file").click(),
  ]);
  await chooser.setFiles({name, mimeType: "image/svg+xml", buffer: Buffer.from(text)});
}
const outline = (page: Page) => read_state(page, (workbench) => workbench.problem.view?.outline ?? []);

test.beforeEach(async ({page}) => {
  await open_workbench(page);
  await page.getByTestId("drawing.tools").click();
  await page.getByTestId("task.outline").last().click();
});

test("is asked for where the drawing has several shapes, and is not the sheet's frame", async ({page}) => {
  const before = await outline(page);
  const several = page_of(
    `<rect x="5" y="5" width="200" height="287"/>${plate}<circle cx="70" cy="40" r="8"/><circle cx="100" cy="200" r="30"/>`,
  );
  await give(page, "part.svg", several);
  const dialog = page.getByTestId("outline.choice");
  await expect(dialog.getByRole("radio")).toHaveCount(4);
  await expect(dialog.getByRole("radio").first()).toBeChecked();
  await expect(dialog.getByRole("radio").first()).toBeFocused();
  await expect(dialog.locator("label").last()).toContainText("frame of the sheet");
  await expect_accessible(page, "[data-testid='outline.choice']");
  await keep_screenshot(page, "outline-choice");
  await page.keyboard.press("Escape");
  await expect(dialog).toBeHidden();
  expect(await outline(page)).toEqual(before);

  await give(page, "part.svg", several);
  await page.getByTestId("outline.use").click();
  await expect(dialog).toBeHidden();
  const extents = (await outline(page)).map(([x]) => x);
  expect(Math.max(...extents) - Math.min(...extents)).toBeCloseTo(100, 6);
  await page.keyboard.press("Control+z");
  expect(await outline(page)).toEqual(before);
});

test("is taken without a question where there is one, and refused with a reason", async ({page}) => {
  await give(page, "plate.svg", page_of(plate));
  await expect.poll(async () => (await outline(page)).length).toBeGreaterThan(6);
  await give(page, "words.svg", page_of("<text>words</text>"));
  await expect(toasts(page).last()).toContainText("no shape with three or more corners");
  await give(page, "broken.svg", "<svg");
  await expect(toasts(page).last()).toContainText("cannot be read");
  await give(page, "part.dxf", "AutoCAD Binary DXF\r\n\x1a\0");
  await expect(toasts(page).last()).toContainText("ASCII DXF");
  await give(page, "part.svg", page_of('<g id="a"><use href="#a"/><use href="#a"/></g>'));
  await expect(toasts(page).last()).toContainText("too large");
});
