// Paths on the page: a mixer's blade about its given pivot, from the dialog to the file. At given angles of the crank:
// src/kinds/path/path.dom.test.ts.
import type {Page} from "@playwright/test";
import type {MapAnswer} from "../src/contract/messages";
import type {PathTask} from "../src/kinds/path/task";
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
  until_settled,
} from "./support";

const task_of = (page: Page) => read_state(page, ({problem}) => problem.task as PathTask);

/** The middle of a cell that meets all requirements, among others that do. */
function place_that_meets(page: Page): Promise<readonly [number, number]> {
  return read_state(page, ({map}) => {
    const {rows, columns, type, defects, fails} = map as MapAnswer;
    const meets = (row: number, column: number) => {
      const cell = row * columns + column;
      return type[cell] === 0 && defects[cell] === 0 && fails[cell] === 0;
    };
    let best: readonly [number, number] = [0, 0],
      most = -1;
    for (let row = 2; row < rows - 2; ++row)
      for (let column = 2; column < columns - 2; ++column) {
        if (!meets(row, column)) continue;
        let around = 0;
        for (const i of [-2, -1, 0, 1, 2])
          for (const k of [-2, -1, 0, 1, 2]) around += Number(meets(row + i, column + k));
        if (around > most) [best, most] = [[(row + 0.5) / rows, (column + 0.5) / columns], around];
      }
    return best;
  });
}

test("a mixer's blade: begun, pointed at on the map, its pivot dragged, clicked anew, taken away", async ({page}) => {
  await open_settled(page);
  await page.getByTestId("bar.new").click();
  await page.getByTestId("new.path_pivot").click();
  await page.getByTestId("new.create").click();
  await until_settled(page);
  await expect(page.getByTestId("path.full_turn")).toHaveText("yes");
  await expect_accessible(page);

  const at = await map_pixel(page, await place_that_meets(page));
  await page.mouse.click(at.x, at.y);
  await page.mouse.move(5, 5);
  await until_settled(page);
  await expect(page.getByTestId("num.type")).toHaveText("Crank-rocker");
  await expect(page.getByTestId("path.full_turn")).toHaveText("yes");
  await expect(page.getByTestId("path.circuit_order")).toHaveText("in order");
  await expect(page.getByTestId("path.layer")).toContainText("Linkage 1 of ");
  await keep_screenshot(page, "path_pivot");

  const map = await map_hash(page),
    pivot = await middle_of(page.getByTestId("drawing.pivot_input_center"));
  await drag(page, pivot, {x: pivot.x + 24, y: pivot.y - 12});
  await until_settled(page);
  const {input} = (await task_of(page)).given!.ground_pivots;
  expect(input![0]).toBeGreaterThan(40);
  expect(await read_state(page, ({hand}) => hand!.input.center![0])).toBeCloseTo(input![0], 6);
  expect(await map_hash(page)).not.toBe(map);
  await expect(page.getByTestId("num.dxf")).toBeEnabled();
  const [file] = await Promise.all([page.waitForEvent("download"), page.getByTestId("num.dxf").click()]);
  expect(file.suggestedFilename()).toMatch(/\.dxf$/);

  // The same points by clicks on the drawing, in order.
  const {points} = await task_of(page),
    places = await Promise.all(points.map((_, i) => middle_of(page.getByTestId(`drawing.point_${i + 1}`))));
  await page.getByTestId("path.click").click();
  for (const [i, {x, y}] of places.entries()) {
    await page.mouse.click(x, y);
    await expect(page.getByTestId("path.remove." + (i + 1))).toBeVisible();
  }
  await until_settled(page);
  const clicked = (await task_of(page)).points,
    step = await read_state(page, ({grid_step}) => grid_step);
  for (const [i, {x, y}] of points.entries())
    expect(Math.hypot(clicked[i]!.x - x, clicked[i]!.y - y)).toBeLessThan(1.5 * step);
});
