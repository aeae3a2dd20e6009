// The solution region by hand: walk-throughs 4, 5, 6, 9, 12 and 13.
import type {Page} from "@playwright/test";
import type {Linkage, TauPair} from "../src/contract/messages";
import {place_of} from "../src/engine/axis";
import {expect, keep_screenshot, map_pixel, open_workbench, read_state, test, until_settled} from "./support";
import type {MotionTask} from "../src/kinds/motion/task";

async function places(page: Page, tau: TauPair): Promise<TauPair> {
  const axis = await read_state(page, (workbench) => workbench.task!.axes.input);
  return [place_of(axis, tau[0])!, place_of(axis, tau[1])!];
}
/** Moves the mouse to a pair of curve coordinates; waits until that linkage is in hand. */
async function hover(page: Page, tau: TauPair): Promise<void> {
  const {x, y} = await map_pixel(page, await places(page, tau));
  await page.mouse.move(x, y);
  await until_settled(page);
  const pointed_at = await read_state(page, ({hovered, hand}) => [hovered, hand!.tau]);
  for (const pair of pointed_at) expect(Math.hypot(pair![0] - tau[0], pair![1] - tau[1])).toBeLessThan(1e-3);
}
async function hand(page: Page): Promise<Linkage> {
  return read_state(page, (workbench) => workbench.hand!) as Promise<Linkage>;
}
async function pick(page: Page, tau: TauPair): Promise<void> {
  await read_state(page, (workbench, at) => workbench.pick(at), tau);
  await until_settled(page);
}

function expect_lengths(linkage: Linkage, wanted: Record<string, number>, relative: number): void {
  for (const [name, length] of Object.entries(wanted)) {
    const got = linkage.lengths![name as "ground"];
    expect(Math.abs(got - length) / length, `${name}: ${got}, not ${length}`).toBeLessThan(relative);
  }
}

const cell: TauPair = [1.3125, 1.1125]; // the middle of a cell of 400 × 400

test("4 · hovering shows another linkage, on the map and in the list of the best", async ({page}) => {
  await open_workbench(page);
  await until_settled(page);
  const picked = await hand(page);
  await hover(page, cell);
  const card = page.getByTestId("region.card");
  await expect(card).toContainText("Triple rocker, output");
  await expect(card).toContainText("γ 73.5° · ratio 4.7 · 256 mm");
  expect_lengths(await hand(page), {ground: 65.03, input: 211.05, coupler: 53.92, output: 255.9}, 1e-4);
  await keep_screenshot(page, "hover");

  await page.mouse.move(700, 20);
  await expect(card).toBeHidden();
  await until_settled(page);
  expect((await hand(page)).tau).toEqual(picked.tau);
  expect((await hand(page)).lengths).toEqual(picked.lengths);

  await page.getByTestId("best.tab").click();
  const third = page.getByTestId("best.3");
  await third.hover();
  await until_settled(page);
  expect((await hand(page)).tau).toEqual(await read_state(page, ({best_list}) => best_list.found!.linkages[2]!.tau));
  await keep_screenshot(page, "best");
});

test("13 · when the curve splits, map and pins stay", async ({page}) => {
  test.slow();
  await open_workbench(page);
  await pick(page, cell);
  await read_state(page, (workbench) => workbench.pin());
  const pin = page.getByTestId("region.pin.A"),
    place_before = await pin.boundingBox();
  const branches = await read_state(page, (workbench) => workbench.task!.axes.input.branches.length);
  const said = page.getByTestId("status.branches"),
    said_before = (await said.textContent())!;

  /** Position 3 moved by so much (mm); the curve's κ, and the map as it is then. */
  const moved = (dx: number) =>
    page.evaluate(async (by) => {
      const hook = (globalThis as any).__linkwright,
        {workbench} = hook,
        start = -220;
      if (!workbench.gesture) workbench.begin_gesture();
      workbench.drag((problem: any) => ({
        ...problem,
        task: {
          ...problem.task,
          poses: (problem.task as MotionTask).poses.map((pose: any, i: number) =>
            i === 2 ? {...pose, x: start + by} : pose,
          ),
        },
      }));
      while (!workbench.is_current || workbench.map.samples !== 400) await new Promise((done) => setTimeout(done));
      hook.seen ??= new Map();
      hook.seen.set(by, {type: workbench.map.type.slice(), defects: workbench.map.defects.slice()});
      return workbench.task.curves.kappa as number;
    }, dx);
  const start = await moved(1e-9); // at rest the map is a finer one
  let same = 0,
    other = 0;
  for (let dx = 1; dx <= 40 && other === 0; ++dx) {
    for (const by of [dx, -dx]) {
      if (other === 0 && Math.sign(await moved(by)) !== Math.sign(start)) [same, other] = [by - Math.sign(by), by];
    }
  }
  expect(other, "κ changes its sign within 40 mm").not.toBe(0);
  await moved(same);
  while (Math.abs(other - same) > 0.04) {
    const middle = (same + other) / 2;
    if (Math.sign(await moved(middle)) === Math.sign(start)) same = middle;
    else other = middle;
    await moved(same);
  }
  await moved(other);
  await expect
    .poll(() => read_state(page, (workbench) => workbench.task!.axes.input.branches.length))
    .not.toBe(branches);
  await expect(said).not.toHaveText(said_before);
  const changed = await page.evaluate(
    ([a, b]) => {
      const {seen} = (globalThis as any).__linkwright,
        one = seen.get(a),
        two = seen.get(b);
      let count = 0;
      for (let i = 0; i < one.type.length; ++i)
        if (one.type[i] !== two.type[i] || one.defects[i] !== two.defects[i]) ++count;
      return count / one.type.length;
    },
    [same, other],
  );
  console.log(
    `κ changes its sign between ${same} and ${other} mm: ${(100 * changed).toFixed(1)} % of the cells change`,
  );
  expect(changed).toBeLessThan(0.1);
  const place_after = await pin.boundingBox();
  expect(Math.hypot(place_after!.x - place_before!.x, place_after!.y - place_before!.y)).toBeLessThan(0.01);
  await read_state(page, (workbench) => workbench.cancel_gesture());
});
