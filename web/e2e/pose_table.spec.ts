// The table of positions, by the mouse.
import {expect, open_settled, poses_of_page, read_state, test} from "./support";

test.beforeEach(({page}) => open_settled(page));

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
