// The picture behind the drawing: dropped, pasted, placed by hand and by numbers, traced over.
import type {Page} from "@playwright/test";
import {drag, expect, keep_screenshot, middle_of, open_workbench, read_state, test} from "./support";

const background = (page: Page) => read_state(page, (workbench) => workbench.problem.view!.background!);

async function paste_picture(page: Page): Promise<void> {
  await page.evaluate(async () => {
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [600, 300];
    const pen = canvas.getContext("2d")!;
    pen.fillStyle = "#89a";
    pen.fillRect(0, 0, 600, 300);
    pen.fillStyle = "#345";
    pen.fillRect(60, 60, 300, 120);
    const blob = await new Promise<Blob>((resolve) => canvas.toBlob((b) => resolve(b!), "image/png"));
    const transfer = new DataTransfer();
    transfer.items.add(new File([blob], "part.png", {type: "image/png"}));
    document.body.dispatchEvent(
      new ClipboardEvent("paste", {clipboardData: transfer, bubbles: true, cancelable: true}),
    );
  });
  await expect(page.getByTestId("picture.width")).toBeVisible();
}

test.beforeEach(async ({page}) => {
  await open_workbench(page);
  await read_state(page, (workbench) => {
    workbench.tour = null; // its hint lies over the drawing
  });
});

test("a picture is dropped and brought to scale; pasted, it is placed by numbers, by its knob and by keys, locked, hidden, undone, and traced over", async ({
  page,
}) => {
  await test.step("dropped it lies behind the drawing and is brought to scale", async () => {
    const area = (await page.getByTestId("drawing.canvas").boundingBox())!;
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
    await expect(page.getByTestId("picture.width")).toBeVisible();
    const before = await background(page);
    expect(before.image.startsWith("data:image/jpeg")).toBe(true);
    expect(before.image.length).toBeLessThanOrEqual(400_000);
    expect(before.aspect).toBeCloseTo(0.5, 9);
    await page.mouse.click(area.x + 100, area.y + area.height - 120);
    await page.mouse.click(area.x + 300, area.y + area.height - 120);
    const scale = await page
      .getByTestId("drawing.ground_box")
      .evaluate((box) => Number(box.getAttribute("width")) / 360);
    await page.getByTestId("drawing.mark_length").fill("1000");
    await page.keyboard.press("Enter");
    expect((await background(page)).width / before.width).toBeCloseTo(1000 / (200 / scale), 2);
    await page.getByTestId("drawing.done").click();
    await page.keyboard.press("Control+z");
    expect((await background(page)).width).toBe(before.width);
  });
  await read_state(page, (workbench) => {
    while (workbench.can_undo) workbench.undo();
  });
  await expect(page.getByTestId("picture.width")).toHaveCount(0);
  await paste_picture(page);
  // Its tools fit on a phone.
  await page.setViewportSize({width: 390, height: 844});
  await keep_screenshot(page, "picture-phone");
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
  const box = (await page.getByTestId("picture.lock").boundingBox())!;
  expect(box.height).toBeGreaterThanOrEqual(44);
  await page.setViewportSize({width: 1440, height: 900});

  const before = await background(page);
  await page.getByTestId("picture.width").fill("300");
  await page.keyboard.press("Enter");
  expect((await background(page)).width).toBeCloseTo(300, 6);
  await page.getByTestId("picture.angle").fill("30");
  await page.keyboard.press("Enter");
  expect((await background(page)).angle_deg).toBe(30);
  const knob = page.getByTestId("drawing.picture_turn");
  await knob.focus();
  await page.keyboard.press("ArrowUp");
  expect((await background(page)).angle_deg).toBe(31);
  await page.getByTestId("picture.angle").fill("0");
  await page.keyboard.press("Enter");
  const from = await middle_of(knob);
  await drag(page, from, {x: from.x + 60, y: from.y + 20});
  expect((await background(page)).angle_deg).toBeLessThan(-5);
  await keep_screenshot(page, "picture");
  await page.getByTestId("picture.lock").click();
  await expect(knob).toHaveCount(0);
  await page.getByTestId("picture.hide").click();
  await expect(page.locator(".drawing image")).toHaveCount(0);
  while (
    await read_state(page, (workbench) => (workbench.problem.view?.background?.width ?? 0) !== 0 && workbench.can_undo)
  )
    await read_state(page, (workbench) => workbench.undo());
  await read_state(page, (workbench) => workbench.redo());
  expect((await background(page)).width).toBe(before.width);

  // An outline is traced over it by clicks, a double click closes it.
  await page.getByTestId("picture.trace").click();
  const area = (await page.getByTestId("drawing.canvas").boundingBox())!;
  const at = (x: number, y: number) => [area.x + area.width * x, area.y + area.height * y] as const;
  await page.mouse.click(...at(0.4, 0.6));
  await page.mouse.click(...at(0.6, 0.6));
  await page.mouse.click(...at(0.6, 0.75));
  await page.mouse.dblclick(...at(0.4, 0.75));
  expect(await read_state(page, (workbench) => workbench.problem.view!.outline!.length)).toBe(4);
});
