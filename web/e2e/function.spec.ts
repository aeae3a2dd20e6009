// Function generation: the sine generator from the gallery, its ribbon, its error, its dials.
import type {FunctionTask} from "../src/kinds/function/task";
import {
  drag,
  example,
  expect,
  expect_accessible,
  keep_screenshot,
  map_hash,
  map_pixel,
  middle_of,
  open_workbench,
  read_state,
  solve,
  test,
  until_settled,
} from "./support";

test.beforeEach(async ({page}) => {
  await page.addInitScript(() =>
    localStorage.setItem("linkwright.preferences", JSON.stringify({language: "en", theme: "light", toured: true})),
  );
  await open_workbench(page);
});

test("the sine generator: its ribbon is pointed at, pivots and dials are dragged, and it fits a phone, in Chinese", async ({
  page,
}) => {
  await page.getByTestId("file.menu").click();
  await page.getByTestId("file.examples").click();
  await page.getByTestId("example.sine_generator").click();
  await until_settled(page);

  // The best is the program's, by the objective of the file.
  const best = solve(example("sine_generator")).linkages[0];
  const task = () => read_state(page, (workbench) => workbench.problem.task as FunctionTask);
  const error = () => read_state(page, (workbench) => workbench.hand!.function!.max_structural_error_deg!);
  expect(await error()).toBeCloseTo(best.max_structural_error_deg, 6);
  await expect(page.getByTestId("num.max_error")).toHaveText("0.056°");
  await expect(page.getByTestId("num.reach")).toHaveText("whole range");
  await expect(page.getByTestId("plot.error")).toHaveAttribute("aria-selected", "true");
  expect(
    await read_state(page, (workbench) => workbench.hand!.function!.pairs.every(([, , off]) => Math.abs(off!) < 1e-9)),
  ).toBe(true);

  // A ribbon: one column, along which pointing goes by one coordinate; a click keeps.
  expect(await read_state(page, (workbench) => [workbench.map!.columns, workbench.map!.property])).toEqual([
    1,
    "max_structural_error_deg",
  ]);
  await expect(page.getByTestId("region.ribbon_line").first()).toBeAttached();
  const there = await map_pixel(page, [0.8, 0.5]);
  await page.mouse.move(there.x, there.y + 90); // in the plot under it
  await expect(page.getByTestId("region.card")).toBeVisible();
  await page.mouse.click(there.x, there.y);
  await until_settled(page);
  expect(await read_state(page, (workbench) => workbench.picked!.place![0])).toBeCloseTo(0.8, 2);
  expect(await error()).toBeGreaterThan(best.max_structural_error_deg);
  await page.getByTestId("region.map").focus();
  await page.keyboard.press("b");
  await expect(page.getByTestId("num.max_error")).toHaveText("0.056°");

  // A moving pivot slides along its curve.
  const tau = await read_state(page, (workbench) => workbench.picked!.tau[0]);
  const pivot = await middle_of(page.getByTestId("drawing.pivot_output_circle"));
  await drag(page, pivot, {x: pivot.x + 12, y: pivot.y + 16});
  await until_settled(page);
  expect(await read_state(page, (workbench) => workbench.picked!.tau[0])).not.toBe(tau);
  await page.keyboard.press("Control+z");
  await until_settled(page);

  // A mark of a dial makes pairs of the function; the map follows; undo brings all back.
  const named = await task(),
    hash = await map_hash(page),
    mark = await middle_of(page.getByTestId("drawing.mark_output_2"));
  const seen = new Set<string>();
  await page.mouse.move(mark.x, mark.y);
  await page.mouse.down();
  for (let step = 1; step <= 4; ++step) {
    await page.mouse.move(mark.x + 2 * step, mark.y + 2.5 * step);
    await until_settled(page);
    seen.add(await map_hash(page));
  }
  await page.mouse.up();
  await until_settled(page);
  expect(seen.size).toBeGreaterThan(1);
  const moved = await task();
  expect(moved).not.toHaveProperty("function");
  expect(moved.pairs![1]!.output_deg).toBe(Math.round(moved.pairs![1]!.output_deg));
  expect(await map_hash(page)).not.toBe(hash);
  await expect(page.getByTestId("toast.title").filter({hasText: "independent pairs"})).toBeVisible();
  await expect(page.getByTestId("plot.error")).toHaveCount(0);
  await page.keyboard.press("Control+z");
  await until_settled(page);
  expect(await task()).toEqual(named);

  // A ground pivot by hand.
  const ground = await middle_of(page.getByTestId("drawing.pivot_output_center"));
  await drag(page, ground, {x: ground.x, y: ground.y - 40});
  expect((await task()).ground_pivots!.output[1]).toBeGreaterThan(5);
  await page.getByTestId("drawing.canvas").click({position: {x: 40, y: 300}});
  await page.keyboard.press("Control+z");
  await until_settled(page);
  expect(await task()).toEqual(named);

  await expect_accessible(page);
  await keep_screenshot(page, "function");

  // What is undone while it is dragged lets go of the pointer.
  const whole = () => read_state(page, ({problem, picked}) => JSON.stringify([problem, picked!.tau]));
  const undragged = await whole();
  await page.mouse.click(there.x, there.y); // a step to undo
  await until_settled(page);
  for (const handle of ["function.point.2", "region.input_axis"]) {
    const from = await middle_of(page.getByTestId(handle));
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(from.x + 6, from.y + 6, {steps: 3});
    expect(await read_state(page, (workbench) => workbench.gesture)).toBe(true);
    await page.keyboard.press("Control+z");
    await page.mouse.move(from.x + 12, from.y + 12, {steps: 3});
    await page.mouse.up();
    await until_settled(page);
    expect(await whole()).toBe(undragged);
    await page.keyboard.press("Control+y");
    await until_settled(page);
  }

  await page.getByTestId("view.language").click();
  await expect(page.getByTestId("function.by_name")).toHaveText("函数");
  await page.setViewportSize({width: 390, height: 844});
  await expect(page.getByTestId("region.ribbon")).toBeInViewport();
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
  await keep_screenshot(page, "function-phone");
});
