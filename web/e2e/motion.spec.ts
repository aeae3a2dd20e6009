// What is given beside three positions, by hand. On a phone: phone.spec.ts.
import type {Page} from "@playwright/test";
import type {Linkage, Point} from "../src/contract/messages";
import type {Given, MotionTask} from "../src/kinds/motion/task";
import {
  drag,
  example,
  expect,
  keep_screenshot,
  map_hash,
  middle_of,
  open_workbench,
  read_state,
  solve,
  test,
  until_settled,
} from "./support";

const handle = (page: Page, id: string) => page.getByTestId(`drawing.${id}`);
const given = (page: Page): Promise<Given | undefined> =>
  read_state(page, (workbench) => (workbench.problem.task as MotionTask).given);
const hand = (page: Page): Promise<Linkage> => read_state(page, (workbench) => workbench.hand!) as Promise<Linkage>;

async function open_example(page: Page, name: string): Promise<void> {
  await read_state(
    page,
    (workbench, problem) => {
      workbench.tour = null; // its hint lies over the drawing
      workbench.open(problem);
    },
    example(name),
  );
  await until_settled(page);
}
function expect_lengths(linkage: Linkage, wanted: Record<string, number>): void {
  for (const [name, length] of Object.entries(wanted)) {
    expect(Math.abs(linkage.lengths![name as "ground"] / length - 1), name).toBeLessThan(1e-6); // found from two maps
  }
}

test("three positions: a length is dragged as a ring, the instant centre as a cross, given pivots as what they are", async ({
  page,
}) => {
  await open_workbench(page);
  await open_example(page, "latch");
  const [best] = solve(example("latch")).linkages;
  expect_lengths(await hand(page), best.lengths);
  await expect(page.getByTestId("task.pattern")).toHaveText("P-P-P");
  await expect(page.getByTestId("region.mirror")).toBeHidden();
  await keep_screenshot(page, "three-positions");

  // A ring: what is dragged is the length, the field and the map follow; one undo.
  const hash = await map_hash(page),
    ring = await middle_of(handle(page, "ring_output"));
  const center = (await hand(page)).output.center!;
  const scale =
    (await page
      .getByTestId("given.ring_output")
      .locator("circle")
      .first()
      .evaluate((circle) => Number(circle.getAttribute("r")))) / 24;
  const hub = await page.getByTestId("given.ring_output").locator("circle").first().boundingBox();
  const middle = {x: hub!.x + hub!.width / 2, y: hub!.y + hub!.height / 2};
  const longer = 30 / 24;
  await drag(page, ring, {x: middle.x + (ring.x - middle.x) * longer, y: middle.y + (ring.y - middle.y) * longer});
  await until_settled(page);
  const [r1, r2] = ((await given(page)) as {side_lengths: [number, number]}).side_lengths;
  expect(r1).toBe(18);
  expect(Math.abs(r2 - 30)).toBeLessThan(3 / scale + (await read_state(page, (workbench) => workbench.grid_step)));
  await expect(page.getByTestId("given.length_output")).toHaveValue(String(r2));
  expect((await hand(page)).output.length).toBeCloseTo(r2, 9);
  expect(await map_hash(page)).not.toBe(hash);
  await page.keyboard.press("Control+z");
  await until_settled(page);
  expect((await given(page)) as object).toEqual({side_lengths: [18, 24]});
  expect((await hand(page)).output.center).toEqual(center);

  // The instant centre: an ordinary map again, with its mirror.
  await page.getByTestId("given.instant_center").click();
  await until_settled(page);
  expect(await read_state(page, ({task}) => task!.symmetric)).toBe(true);
  const cross = await middle_of(handle(page, "instant_center"));
  await drag(page, cross, {x: cross.x + 20, y: cross.y - 12});
  await until_settled(page);
  expect(await read_state(page, ({task}) => [task!.symmetric, task!.curves.kind !== "every_point"])).toEqual([
    true,
    true,
  ]);
  await expect(page.getByTestId("given.family")).toContainText("2");

  // Dragged, a pivot given is where the linkage has it.
  await open_example(page, "bracket_hatch");
  const [hatch] = solve(example("bracket_hatch")).linkages;
  expect_lengths(await hand(page), hatch.lengths);

  const pivot = await middle_of(handle(page, "pivot_input_center"));
  await drag(page, pivot, {x: pivot.x + 14, y: pivot.y + 6});
  await until_settled(page);
  const {ground_pivots} = (await given(page)) as {ground_pivots: Record<"input" | "output", Point>};
  expect(ground_pivots.input).not.toEqual([120, 340]);
  expect(ground_pivots.output).toEqual([200, 340]);
  const {input} = await hand(page);
  for (const k of [0, 1] as const) expect(Math.abs(input.center![k] - ground_pivots.input[k])).toBeLessThan(1e-6);
  await page.keyboard.press("Control+z");
  await until_settled(page);
  expect(await given(page)).toEqual({ground_pivots: {input: [120, 340], output: [200, 340]}});
});

test("eight poses drawn by hand: four exact with the others measured, then all near, within a tolerance, and back", async ({
  page,
}) => {
  await open_workbench(page);
  await open_example(page, "hatch_by_hand");
  const axes = () => read_state(page, ({task}) => task!.axes.input.quantity);
  const miss = async (): Promise<number> => (await hand(page)).near!.error.rms;
  expect(await axes()).toBe("curve_coordinate");
  expect(await page.getByTestId("near.misses").locator("li").count()).toBe(4);
  const measured = await miss();
  expect(measured).toBeGreaterThan(0);
  await keep_screenshot(page, "near_poses");

  for (const exact of [1, 3, 5, 8]) await page.getByTestId(`near.${exact}`).click();
  await until_settled(page);
  expect(await axes()).toBe("fitted_curve");
  expect(await page.getByTestId("near.misses").locator("li").count()).toBe(8);
  expect(await miss()).toBeLessThan(measured);
  await page.getByTestId("near.position").fill("100");
  await page.keyboard.press("Enter");
  await until_settled(page);
  await expect(page.getByTestId("near.miss.4")).not.toHaveClass(/warn/);
  await expect(page.getByTestId("num.dxf")).toBeEnabled();
  await keep_screenshot(page, "near_poses-all");
  for (let steps = 0; steps < 8 && (await axes()) !== "curve_coordinate"; ++steps) {
    await page.keyboard.press("Control+z");
    await until_settled(page);
  }
  expect(await miss()).toBeCloseTo(measured, 6);
});
