// Points that run straight, on the page: examples, the line, the cases, layers, colours, links, phone.
import type {Page} from "@playwright/test";
import type {StraightLineTask} from "../src/kinds/straight_line/task";
import {
  drag,
  expect,
  expect_accessible,
  keep_screenshot,
  map_hash,
  map_pixel,
  middle_of,
  open_settled,
  read_state,
  test,
  until_mapped,
  until_settled,
} from "./support";

async function open_example(page: Page, name: string): Promise<void> {
  await open_settled(page);
  await page.getByTestId("file.menu").click();
  await page.getByTestId("file.examples").click();
  await page.getByTestId(`example.${name}`).click();
  await until_settled(page);
}
const task_of = (page: Page) => read_state(page, ({problem}) => problem.task as StraightLineTask);

test("the line is dragged and turned on the drawing, and linkages are pointed at on the map", async ({page}) => {
  await open_example(page, "straight_luffing_crane");
  const before = await task_of(page),
    map = await map_hash(page);
  const point = await middle_of(page.getByTestId("drawing.line_point"));
  await drag(page, point, {x: point.x - 20, y: point.y + 30});
  const moved = await task_of(page);
  expect(moved.line.point[1]).toBeLessThan(before.line.point[1]);
  expect(moved.line.direction_deg).toBe(before.line.direction_deg);
  const knob = await middle_of(page.getByTestId("drawing.line_direction"));
  await drag(page, knob, {x: knob.x, y: knob.y - 40});
  expect((await task_of(page)).line.direction_deg).toBeGreaterThan(5);
  await until_mapped(page);
  expect(await map_hash(page)).not.toBe(map);
  await page.keyboard.press("Control+z");
  expect(await task_of(page)).toEqual(moved);
  await page.keyboard.press("Control+z");
  expect(await task_of(page)).toEqual(before);

  // Each linkage under the pointer is shown with its numbers; colours are the map's.
  await open_example(page, "straight_indicator");
  const place = await read_state(page, ({picked}) => picked!.place!),
    picked = await page.getByTestId("straight.num.usable").textContent();
  const over = await map_pixel(page, place);
  await page.mouse.move(over.x + 60, over.y - 40);
  await page.mouse.move(over.x + 40, over.y - 20);
  await expect
    .poll(() =>
      page
        .getByTestId("straight.num.usable")
        .textContent()
        .catch(() => null),
    )
    .not.toBe(picked);
  await page.mouse.move(5, 5);
  await expect(page.getByTestId("straight.num.usable")).toHaveText(picked!);
  const types = await map_hash(page);
  await page.getByTestId("straight.stroke_over_longest").click();
  await until_mapped(page);
  await expect.poll(() => map_hash(page)).not.toBe(types);
  await expect_accessible(page);
  await keep_screenshot(page, "straight_line");
  await page.getByTestId("bar.new").click();
  await page.getByTestId("new.straight_search").click();
  await page.getByTestId("new.create").click();
  await expect(page.getByTestId("straight.start")).toBeVisible();
  await expect_accessible(page);
});
