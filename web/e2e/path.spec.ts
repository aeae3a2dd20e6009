// Paths on the page: a mixer's blade about its given pivot, a feeder's gripper through three poses and two points, a leg
// between both of its pivots, each from the dialog on; and a bean that is drawn. At given angles of the crank: src/kinds/path/path.dom.test.ts.
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
  type Pixel,
} from "./support";

const task_of = (page: Page) => read_state(page, ({problem}) => problem.task as PathTask);

async function begin(page: Page, id: string): Promise<void> {
  await open_settled(page);
  await page.getByTestId("bar.new").click();
  await page.getByTestId(`new.${id}`).click();
  await page.getByTestId("new.create").click();
  await until_settled(page);
}

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
  await begin(page, "path_pivot");
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

/** The ground pivot of the linkage in hand, on the drawing and in the task's frame. */
const center_of = (page: Page) => read_state(page, ({hand}) => hand!.input.center!);
const layer_of = async (page: Page) => {
  const said = (await page.getByTestId("path.layer").textContent())!,
    [, k, n] = /(\d+) of (\d+)/.exec(said)!;
  return {k: Number(k), n: Number(n)};
};

/** A place of the drawing, off all that can be taken hold of there, where a linkage that meets all requirements has its
 *  ground pivot. Points 1 and 3 tell where the drawing lies. */
async function pivot_that_meets(page: Page): Promise<{pixel: Pixel; center: readonly [number, number]}> {
  const pixels = await Promise.all([1, 3].map((n) => middle_of(page.getByTestId(`drawing.point_${n}`)))),
    taken = await page.locator("[data-testid^='drawing.'].handle").all();
  const handles = await Promise.all(taken.map(middle_of));
  const centers = await read_state(page, ({map, task}) => {
    const {rows, columns, fails, type, defects, input_tau, output_tau} = map as MapAnswer,
      {input, output} = task!.axes;
    const value = ({ticks}: typeof input, tau: number) => {
      const at = (share: number) => ticks!.find(([place]) => Math.abs(place - share) < 1e-9)![1];
      return at(0.5) + (at(0.75) - at(0.5)) * Math.tan(Math.PI * (tau - 0.5));
    };
    const meets = (row: number, column: number) => {
      const cell = row * columns + column;
      return fails[cell] === 0 && defects[cell] === 0 && type[cell]! < 9;
    };
    const found: [number, number][] = [];
    for (let row = 1; row < rows - 1; ++row)
      for (let column = 1; column < columns - 1; ++column)
        if ([-1, 0, 1].every((i) => [-1, 0, 1].every((k) => meets(row + i, column + k))))
          found.push([value(output, output_tau[column]!), value(input, input_tau[row]!)]);
    return found;
  });
  const {points} = await task_of(page),
    scale = (pixels[1]!.x - pixels[0]!.x) / (points[2]!.x - points[0]!.x);
  for (const center of centers) {
    const pixel = {
      x: pixels[0]!.x + scale * (center[0] - points[0]!.x),
      y: pixels[0]!.y - scale * (center[1] - points[0]!.y),
    };
    if (handles.every(({x, y}) => Math.hypot(x - pixel.x, y - pixel.y) > 30)) return {pixel, center};
  }
  throw new Error("no linkage that meets all has its pivot off the handles");
}

test("a feeder: begun, hovered on the drawing, taken there, flicked through and pinned", async ({page}) => {
  await begin(page, "path_poses");
  await expect(page.getByTestId("drawing.plane_map")).toBeVisible();
  await expect(page.getByTestId("path.turn_3")).toBeVisible();
  await expect_accessible(page);
  const best = await center_of(page),
    {pixel, center} = await pivot_that_meets(page);

  // The linkage follows the pointer, its ground pivot under it, and the picked one comes back.
  await page.mouse.move(pixel.x - 1, pixel.y);
  await page.mouse.move(pixel.x, pixel.y);
  await expect.poll(() => read_state(page, ({hovered}) => hovered !== null)).toBe(true);
  await until_settled(page);
  const followed = await center_of(page),
    step = await read_state(page, ({grid_step}) => grid_step);
  expect(Math.hypot(followed[0] - center[0], followed[1] - center[1])).toBeLessThan(step / 10);
  await page.mouse.move(5, 5);
  await expect.poll(() => center_of(page)).toEqual(best);

  // A click takes it.
  await page.mouse.click(pixel.x, pixel.y);
  await page.mouse.move(5, 5);
  await until_settled(page);
  const rounded = (at: readonly number[]) => at.map((value) => value.toFixed(3));
  expect(rounded(await center_of(page))).toEqual(rounded(followed));
  await expect(page.getByTestId("path.layer_meets")).toHaveText("meets all requirements");
  await keep_screenshot(page, "path_poses");

  // By the key to the next linkage with the same pivot, and back.
  const before = await layer_of(page);
  expect(before.n).toBeGreaterThan(1);
  await page.keyboard.press("l");
  await until_settled(page);
  expect(await layer_of(page)).toEqual({k: (before.k % before.n) + 1, n: before.n});
  expect(rounded(await center_of(page))).toEqual(rounded(followed));
  await page.keyboard.press("Shift+L");
  await until_settled(page);
  expect(await layer_of(page)).toEqual(before);
  await page.keyboard.press("p");
  await expect(page.getByTestId("pin.row.A")).toBeVisible();

  // A pose's angle by its handle, as poses have it.
  const knob = await middle_of(page.getByTestId("drawing.turn_2"));
  await drag(page, knob, {x: knob.x, y: knob.y + 14});
  await until_settled(page);
  const turned = (await task_of(page)).points[1]!.theta_deg!;
  expect(turned).toBeLessThan(-25);
  await expect(page.getByTestId("path.theta_deg.2")).toHaveValue(String(turned));

  // Without the map over the drawing nothing follows.
  await page.getByTestId("drawing.tools").click();
  await page.getByTestId("drawing.plane_map").last().click();
  await expect(page.locator("canvas[data-testid='drawing.plane_map']")).toHaveCount(0);
  await page.mouse.move(pixel.x, pixel.y);
  expect(await read_state(page, ({hovered}) => hovered)).toBeNull();
});

test("a walking leg: begun, all its linkages gone through, the crank-rocker taken away", async ({page}) => {
  await begin(page, "path_pivots");
  await expect(page.getByTestId("region.ribbon")).toBeVisible();
  const {columns, defects} = await read_state(page, ({map}) => {
    const {columns, defects} = map as MapAnswer;
    return {columns, defects: Array.from(defects)};
  });
  expect(columns).toBe(24);
  await expect(page.getByTestId("region.ribbon_bar")).toHaveCount(defects.filter((bits) => bits === 0).length);
  await expect(page.getByTestId("num.type")).toHaveText("Crank-rocker");
  await expect(page.getByTestId("path.full_turn")).toHaveText("yes");
  await expect_accessible(page);
  await keep_screenshot(page, "path_pivots");

  const first = await layer_of(page),
    seen = new Set<string>();
  expect(first.n).toBe(24);
  for (let steps = 0; steps < first.n; ++steps) {
    await page.keyboard.press("l");
    await until_settled(page);
    const {input, output} = await read_state(page, ({hand}) => hand!);
    expect([input.center, output.center].flat().map((value) => Math.round(value!))).toEqual([0, 0, 190, -66]);
    seen.add(input.circle!.map((value) => value.toFixed(3)).join());
  }
  expect(seen.size).toBe(first.n);
  expect(await layer_of(page)).toEqual(first);

  await page.keyboard.press("b");
  await until_settled(page);
  await expect(page.getByTestId("num.type")).toHaveText("Crank-rocker");
  await expect(page.getByTestId("num.dxf")).toBeEnabled();
  const [file] = await Promise.all([page.waitForEvent("download"), page.getByTestId("num.dxf").click()]);
  expect(file.suggestedFilename()).toMatch(/\.dxf$/);

  // A point more than five is said, and taken away again.
  await page.getByTestId("path.add").click();
  await expect(page.getByTestId("task.missing")).toContainText("1 too many");
  await page.getByTestId("path.remove.6").click();
  await page.getByTestId("path.remove.5").click();
  await expect(page.getByTestId("task.missing")).toContainText("three points or with five");
});

/** Pixels of a bean about a middle, as a hand goes round it and a little past its beginning. */
function bean_about({x, y}: Pixel, size: number): Pixel[] {
  return Array.from({length: 91}, (_, k) => {
    const angle = (2 * Math.PI * k) / 88,
      r = size * (1 - 0.3 * Math.exp(-((Math.sin((angle - Math.PI / 2) / 2) * 2) ** 2) / 0.5));
    return {x: x + 1.35 * r * Math.cos(angle), y: y + r * Math.sin(angle) - 0.1 * size};
  });
}
async function draw(page: Page, pixels: readonly Pixel[], before_release?: () => Promise<void>): Promise<void> {
  await page.getByTestId("path.draw").click();
  await page.mouse.move(pixels[0]!.x, pixels[0]!.y);
  await page.mouse.down();
  for (const {x, y} of pixels) await page.mouse.move(x, y);
  await before_release?.();
  await page.mouse.up();
}
const fit_of = (page: Page) => read_state(page, ({hand}) => hand!.path!.fit!);

test("a bean: drawn, followed before the mouse is let go, its four-bars flicked through, undone, on a phone", async ({
  page,
}) => {
  await begin(page, "path_near");
  await expect(page.getByTestId("path.rms_share")).toHaveText(/^0\.\d+ %$/);
  await expect_accessible(page);
  await keep_screenshot(page, "path_near");

  const canvas = (await page.getByTestId("drawing.canvas").boundingBox())!,
    middle = {x: canvas.x + 0.5 * canvas.width, y: canvas.y + 0.5 * canvas.height},
    before = await task_of(page);
  await draw(page, bean_about(middle, 0.2 * canvas.height), async () => {
    await expect(page.getByTestId("path.stroke")).toBeVisible();
    await expect.poll(() => read_state(page, ({is_current, hand}) => is_current && hand?.path?.fit != null)).toBe(true);
    expect((await fit_of(page)).error.rms_over_diagonal).toBeLessThan(0.005);
  });
  await until_settled(page);
  const drawn = await task_of(page);
  expect([drawn.closed, drawn.points.length]).toEqual([true, 24]);
  await expect(page.getByTestId("num.type")).toHaveText("Crank-rocker");
  await expect(page.getByTestId("path.full_turn")).toHaveText("yes");
  expect((await fit_of(page)).error.rms_over_diagonal).toBeLessThan(0.005);
  await expect(page.getByTestId("path.stroke")).toHaveCount(0);
  await keep_screenshot(page, "path_drawn");

  // The three four-bars that trace it.
  const {rms} = (await fit_of(page)).error,
    seen = new Set<string>();
  await expect(page.getByTestId("path.layer")).toContainText("of 3 that trace this path");
  for (let k = 0; k < 3; ++k) {
    const {input, output} = await read_state(page, ({hand}) => hand!);
    seen.add([...input.center!, ...output.center!].map((value) => value.toFixed(3)).join());
    expect((await fit_of(page)).error.rms).toBeCloseTo(rms, 6);
    await page.keyboard.press("l");
    await until_settled(page);
  }
  expect(seen.size).toBe(3);
  for (let k = 0; k < 4 && (await task_of(page)).points.length === 24; ++k) {
    await page.keyboard.press("Control+z"); // quick flicks are one step
    await until_settled(page);
  }
  expect(await task_of(page)).toEqual(before);
  await page.keyboard.press("Control+Shift+z");
  await until_settled(page);
  expect(await task_of(page)).toEqual(drawn);

  // A point is dragged, a tolerance given.
  const point = await middle_of(page.getByTestId("drawing.point_6"));
  await drag(page, point, {x: point.x + 14, y: point.y + 8});
  await until_settled(page);
  expect((await task_of(page)).points[5]).not.toEqual(drawn.points[5]);
  await page.getByTestId("path.tolerance").fill("5");
  await page.keyboard.press("Enter");
  await until_settled(page);
  await expect(page.getByTestId("path.tube")).toBeVisible();
  await page.mouse.move(5, 5);
  await page.setViewportSize({width: 1024, height: 768});
  await until_settled(page);
  await keep_screenshot(page, "path_near-1024");

  await page.setViewportSize({width: 390, height: 844});
  await until_settled(page);
  await keep_screenshot(page, "path_near-phone");
  await read_state(page, (workbench) => void (workbench.sheet = "task"));
  await page.getByTestId("path.draw").scrollIntoViewIfNeeded();
  await expect_accessible(page);
  await keep_screenshot(page, "path_near-phone_task");
  expect(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth)).toBe(true);
  await page.getByTestId("path.draw").click();
  await expect(page.getByTestId("drawing.mode")).toBeVisible();
  const small = (await page.getByTestId("drawing.canvas").boundingBox())!,
    here = {x: small.x + 0.45 * small.width, y: small.y + 0.4 * small.height},
    pixels = bean_about(here, 0.18 * small.height);
  await page.mouse.move(pixels[0]!.x, pixels[0]!.y);
  await page.mouse.down();
  for (const {x, y} of pixels) await page.mouse.move(x, y);
  await page.mouse.up();
  await page.mouse.move(5, 5);
  await until_settled(page);
  expect((await task_of(page)).points).toHaveLength(24);
  expect((await fit_of(page)).error.rms_over_diagonal).toBeLessThan(0.01);
  await keep_screenshot(page, "path_near-phone_drawn");
});

test("a bean's pivots: its map over the drawing, a linkage picked there, its pivot bolted and dragged", async ({
  page,
}) => {
  await begin(page, "path_near");
  const best = (await fit_of(page)).error.rms;
  await page.getByTestId("path.map_pivots").click();
  await until_settled(page);
  await expect(page.getByTestId("drawing.plane_map")).toBeVisible();
  expect((await fit_of(page)).error.rms).toBeCloseTo(best, 6);
  await page.mouse.move(5, 5);
  await keep_screenshot(page, "path_pivots");

  // Under the pointer stands the input's pivot of the linkage that is shown.
  const canvas = (await page.getByTestId("drawing.canvas").boundingBox())!,
    at = {x: canvas.x + 0.3 * canvas.width, y: canvas.y + 0.72 * canvas.height};
  await page.mouse.move(at.x, at.y);
  await page.mouse.click(at.x, at.y);
  await page.mouse.move(5, 5);
  await until_settled(page);
  const pivot = await middle_of(page.getByTestId("drawing.pivot_input_center"));
  expect(Math.hypot(pivot.x - at.x, pivot.y - at.y)).toBeLessThan(4);
  expect((await fit_of(page)).error.rms).toBeGreaterThan(best);

  await page.getByTestId("path.bolted_input").click();
  await until_settled(page);
  const given = (await task_of(page)).given!.ground_pivots.input!;
  expect(await read_state(page, ({hand}) => hand!.input.center![0])).toBeCloseTo(given[0], 3);
  const stands = await middle_of(page.getByTestId("drawing.pivot_input_center"));
  await drag(page, stands, {x: stands.x + 20, y: stands.y - 10});
  await until_settled(page);
  const moved = (await task_of(page)).given!.ground_pivots.input!;
  expect(moved).not.toEqual(given);
  expect(await read_state(page, ({hand}) => hand!.input.center![0])).toBeCloseTo(moved[0], 3);
  await keep_screenshot(page, "path_bolted");
  await expect(page.getByTestId("num.dxf")).toBeEnabled();
});

test("a bean is searched deeper while its four-bars are looked at, and what is found joins them", async ({page}) => {
  await begin(page, "path_near");
  const {rms} = (await fit_of(page)).error,
    picked = await read_state(page, ({hand}) => hand!.tau);
  await page.getByTestId("fit.deep").click();
  await expect(page.getByTestId("fit.progress")).toHaveText(/[1-9]\d? %$/);
  const other = await map_pixel(page, [0.75, 0.5]);
  await page.mouse.move(other.x, other.y);
  await expect.poll(() => read_state(page, ({hand}) => hand!.tau)).not.toEqual(picked);
  await expect(page.getByTestId("fit.stop")).toBeVisible(); // nobody has waited for it
  await page.mouse.move(5, 5);
  await keep_screenshot(page, "path_deep");
  await expect(page.getByTestId("fit.verdict")).toHaveText(/starts led to [\d,]+ linkages/);
  await until_settled(page);
  expect((await fit_of(page)).error.rms).toBeLessThanOrEqual(rms * (1 + 1e-9));
  await expect(page.getByTestId("fit.starts")).toHaveText(/begins with \d+ more linkages/);
  await expect_accessible(page);
  await page.keyboard.press("Control+z");
  await until_settled(page);
  await expect(page.getByTestId("fit.starts")).toHaveCount(0);
});
