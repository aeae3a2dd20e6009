// Three and five positions by hand: walk-through 20, and what is given beside three.
import type {Page} from "@playwright/test";
import type {Linkage, Point, TauPair} from "../src/contract/messages";
import {places_of} from "../src/engine/axis";
import type {Given, MotionTask} from "../src/tasks/motion/task";
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

test("three positions: lengths as rings, an angle as a wedge, the instant centre as a cross", async ({page}) => {
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

  // A sheet fills the map; the whole map comes back.
  await page.getByTestId("region.sheet.II").click();
  await page.waitForFunction(() => globalThis.__linkwright!.workbench.map!.window.output[0] > 0);
  const taus = await read_state(page, ({map}) =>
    [[...map!.input_tau], [...map!.output_tau]].map((list) => [
      Math.floor(Math.min(...list)),
      Math.floor(Math.max(...list)),
    ]),
  );
  expect(taus).toEqual([
    [0, 0],
    [1, 1],
  ]);
  await page.getByTestId("region.sheet.II").click();
  await until_settled(page);

  // One length: the engine chooses the other, says which, and it can be taken in hand.
  await page.getByTestId("given.side_length").click();
  await expect(page.getByTestId("task.warning")).toContainText(/length of the output link was left open/);
  await until_settled(page);
  const chosen = (await hand(page)).output.length!;
  await expect(page.getByTestId("given.length_output")).toHaveAttribute("placeholder", /\d/);
  await handle(page, "ring_output").focus();
  await page.keyboard.press("ArrowUp");
  await until_settled(page);
  const taken = ((await given(page)) as {side_lengths: [number, number]}).side_lengths[1];
  expect(taken).toBeGreaterThan(chosen);

  // The angle: stepped, and the grounded links of the linkage in hand stand at it.
  await page.getByTestId("req.reset").click(); // the boxes leave none at this angle
  await page.getByTestId("given.side_angle").click();
  await page.getByTestId("given.length_input").fill("18");
  await page.getByTestId("given.length_input").press("Enter");
  await page.waitForFunction(() => globalThis.__linkwright!.workbench.task!.axes.output.quantity === "side_length");
  await until_settled(page);
  const direction = ({center, circle}: {center: Point | null; circle: Point | null}) =>
    Math.atan2(circle![1] - center![1], circle![0] - center![0]);
  await handle(page, "side_angle").focus();
  await page.keyboard.press("ArrowUp");
  await until_settled(page);
  expect(((await given(page)) as {side_angle_deg: number}).side_angle_deg).toBe(61);
  await read_state(page, (workbench) => workbench.pick_best()); // the one that was in hand may be no more
  await until_settled(page);
  const {input, output} = await hand(page),
    turn = ((direction(output) - direction(input)) * 180) / Math.PI - 61;
  expect(Math.abs(turn - 360 * Math.round(turn / 360))).toBeLessThan(1e-6);

  // The instant centre: an ordinary map again, with its mirror.
  await page.getByTestId("given.instant_center").click();
  await page.waitForFunction(() => globalThis.__linkwright!.workbench.task!.symmetric);
  const cross = await middle_of(handle(page, "instant_center"));
  await drag(page, cross, {x: cross.x + 20, y: cross.y - 12});
  await until_settled(page);
  expect(await read_state(page, ({task}) => [task!.symmetric, task!.curves.kind !== "every_point"])).toEqual([
    true,
    true,
  ]);
  await expect(page.getByTestId("given.family")).toContainText("2");

  // A fourth position makes what is given needless, taking it out again asks anew.
  await page.getByTestId("task.add").click();
  await until_settled(page);
  expect(await given(page)).toBeUndefined();
  await expect(page.getByTestId("given.side_lengths")).toHaveCount(0);
  await page.getByTestId("task.menu.4").click();
  await page.getByTestId("task.remove").click();
  await expect(page.getByTestId("region.notice")).toContainText("choose an additional constraint");
  await page.getByTestId("region.notice").getByTestId("given.side_lengths").click();
  await until_settled(page);
  await expect(page.getByTestId("region.notice")).toBeHidden();
});

test("20 · five positions: a board of as many four-bars as the program finds, and one position freed", async ({
  page,
}) => {
  await open_workbench(page);
  await page.getByTestId("file.menu").click();
  await page.getByTestId("file.examples").click();
  await page.getByTestId("example.nose_gear").click();
  await until_settled(page);
  const result = solve(example("nose_gear")),
    count = result.dyads.length;
  expect(await read_state(page, ({map}) => [map!.rows, map!.columns])).toEqual([count, count]);
  await expect(page.locator("[data-testid^='curve.bead_center_']")).toHaveCount(count);
  await expect(page.locator("[data-testid^='region.board.']")).toHaveCount(count * (count - 1));
  expect_lengths(await hand(page), result.linkages[0].lengths);
  await keep_screenshot(page, "five-positions");

  const exact = await hand(page);

  // Every cell under the pointer is the linkage of its grounded links; arrow keys go from cell to cell.
  const axes = await read_state(page, ({task}) => task!.axes);
  const at = (row: number, column: number) => places_of(axes, [row + 0.5, column + 0.5] as TauPair)!;
  const {x, y} = await map_pixel(page, at(0, 2));
  await page.mouse.move(x + 20, y - 15);
  await page.waitForFunction(() => globalThis.__linkwright!.workbench.hand?.tau.join() === "0.5,2.5");
  await expect(page.getByTestId("region.card")).toBeVisible();
  const hovered = await hand(page),
    [px, py] = result.dyads[0].center_point,
    [qx, qy] = result.dyads[2].circle_point;
  expect(Math.hypot(hovered.input.center![0] - px, hovered.input.center![1] - py)).toBeLessThan(1e-6);
  expect(Math.hypot(hovered.output.circle![0] - qx, hovered.output.circle![1] - qy)).toBeLessThan(1e-6);
  await page.mouse.click(x, y);
  await page.mouse.move(5, 5);
  await page.getByTestId("region.map").focus();
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("Enter");
  await until_settled(page);
  expect(await read_state(page, (workbench) => workbench.picked!.tau.join())).toBe("0.5,1.5");
  await page.keyboard.press("x");
  await until_settled(page);
  expect(await read_state(page, (workbench) => workbench.picked!.tau.join())).toBe("1.5,0.5");

  // Free one: a map of four positions, coloured by the miss, which is nothing where all five are met.
  await page.getByTestId("freed.3").click();
  await page.waitForFunction(
    () =>
      globalThis.__linkwright!.workbench.map?.property === "pose_miss" &&
      globalThis.__linkwright!.workbench.map.rows > 100,
  );
  await until_settled(page);
  const miss = await page.evaluate(
    async ([input, output]) => {
      const {workbench} = globalThis.__linkwright!,
        {tau, center} = workbench.task!.curves;
      // The exact linkage on the curve of the other four: from the nearest of its corners the miss leads there.
      const nearest = ([px, py]: readonly number[]) => {
        const away = (i: number) =>
          Math.hypot(center[3 * i + 1]! / center[3 * i]! - px!, center[3 * i + 2]! / center[3 * i]! - py!);
        return [...tau.keys()].reduce((best, i) => (away(i) < away(best) ? i : best), 0);
      };
      const problem = JSON.stringify({...workbench.problem, view: undefined});
      const at = async (pair: number[]) =>
        (await workbench.driver_client!.run({kind: "linkage", problem, tau: pair as unknown as [number, number]}))
          .linkage.miss?.distance ?? Infinity;
      let place = [tau[nearest(input)]!, tau[nearest(output)]!],
        least = await at(place);
      for (let step = 0.004; step > 1e-8; step /= 2) {
        for (let better = true; better;) {
          better = false;
          for (const [di, dk] of [
            [step, 0],
            [-step, 0],
            [0, step],
            [0, -step],
          ]) {
            const there = [place[0]! + di!, place[1]! + dk!],
              value = await at(there);
            if (value < least) [place, least, better] = [there, value, true];
          }
        }
      }
      return least;
    },
    [exact.input.center!, exact.output.center!] as const,
  );
  expect(miss).toBeLessThan(1e-3);
  await expect(page.getByTestId("num.miss")).toContainText("mm");
  await keep_screenshot(page, "five-positions-one-freed");

  await page.getByTestId("freed.none").click();
  await until_settled(page);
  expect(await read_state(page, ({map}) => map!.rows)).toBe(count);
});

test("three and five positions in Chinese, in the dark, on a phone", async ({page}) => {
  await page.setViewportSize({width: 390, height: 844});
  await open_workbench(page);
  await page.evaluate(() => {
    const {preferences} = globalThis.__linkwright as unknown as {preferences: {language: string; theme: string}};
    preferences.language = "zh";
    preferences.theme = "dark";
  });
  for (const name of ["latch", "nose_gear"]) {
    await open_example(page, name);
    await read_state(page, (workbench) => void (workbench.sheet = "task"));
    await expect(page.getByTestId("task.kind")).toHaveText(/四杆机构/);
    await expect_accessible(page);
    const small = await page
      .locator("button:visible")
      .evaluateAll((buttons) =>
        buttons
          .filter((b) => b.getBoundingClientRect().height < 43.5 && !b.closest("svg"))
          .map((b) => b.outerHTML.slice(0, 100)),
      );
    expect(small).toEqual([]);
    await keep_screenshot(page, `phone-${name}`);
    await read_state(page, (workbench) => void (workbench.sheet = null));
    expect(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth)).toBe(true);
  }
});

test("three positions: given pivots are dragged, an open one is the map, a line carries both", async ({page}) => {
  await open_workbench(page);
  await open_example(page, "bracket_hatch");
  const [best] = solve(example("bracket_hatch")).linkages;
  expect_lengths(await hand(page), best.lengths);

  // Dragged, the pivot given is where the linkage has it.
  const pivot = await middle_of(handle(page, "pivot_input_center"));
  await drag(page, pivot, {x: pivot.x + 14, y: pivot.y + 6});
  await until_settled(page);
  const {ground_pivots} = (await given(page)) as {ground_pivots: Record<"input" | "output", Point>};
  expect(ground_pivots.input).not.toEqual([120, 340]);
  expect(ground_pivots.output).toEqual([200, 340]);
  const {center} = (await hand(page)).input;
  for (const k of [0, 1] as const) expect(Math.abs(center![k] - ground_pivots.input[k])).toBeLessThan(1e-6);
  await page.keyboard.press("Control+z");
  await until_settled(page);
  expect(await given(page)).toEqual({ground_pivots: {input: [120, 340], output: [200, 340]}});

  // One pivot left open: the map is the plane in which it lies.
  await page.getByTestId("given.pivot_output").selectOption("");
  await until_settled(page);
  expect(await given(page)).toEqual({input_ground_pivot: [120, 340]});
  const quantities = () => read_state(page, ({task}) => [task!.axes.input.quantity, task!.axes.output.quantity]);
  expect(await quantities()).toEqual(["center_y", "center_x"]);
  const {input} = await hand(page);
  expect(Math.hypot(input.center![0] - 120, input.center![1] - 340)).toBeLessThan(1e-6);

  // A line for both ground pivots, turned by its knob.
  await page.getByTestId("given.pivot_lines").click();
  await until_settled(page);
  expect(await quantities()).toEqual(["center_on_line", "center_on_line"]);
  await handle(page, "line_ground_direction").focus();
  await page.keyboard.press("ArrowUp");
  await until_settled(page);
  expect(((await given(page)) as {ground_pivot_on: {direction_deg: number}}).ground_pivot_on.direction_deg).toBe(1);
});
