// The solution region by hand: walk-throughs 4, 5, 6, 9, 12 and 13.
import type {Page} from "@playwright/test";
import type {Linkage, TauPair} from "../src/contract/messages";
import {planar_types} from "../src/tasks/planar";
import {place_of} from "../src/engine/axis";
import {
  example,
  expect,
  keep_screenshot,
  map_hash,
  map_pixel,
  open_workbench,
  read_state,
  solve,
  test,
  until_settled,
} from "./support";
import type {MotionTask} from "../src/tasks/motion/task";

async function places(page: Page, tau: TauPair): Promise<TauPair> {
  const axis = await read_state(page, (workbench) => workbench.task!.axes.input);
  return [place_of(axis, tau[0])!, place_of(axis, tau[1])!];
}
/** Moves the mouse to a pair of curve coordinates; waits until that linkage is in hand. */
async function hover(page: Page, tau: TauPair): Promise<void> {
  const {x, y} = await map_pixel(page, await places(page, tau));
  await page.mouse.move(x, y);
  await page.waitForFunction(([a, b]) => {
    const {hovered, hand} = (globalThis as any).__linkwright.workbench;
    const near = (pair: TauPair | null) => !!pair && Math.hypot(pair[0] - a, pair[1] - b) < 1e-3;
    return near(hovered) && near(hand?.tau);
  }, tau);
}
async function hand(page: Page): Promise<Linkage> {
  return read_state(page, (workbench) => workbench.hand!) as Promise<Linkage>;
}
async function pick(page: Page, tau: TauPair): Promise<void> {
  await read_state(page, (workbench, at) => workbench.pick(at), tau);
  await until_settled(page);
}

/** Lengths of a cell of the program's own curve samples. */
function program_lengths(result: any, tau: TauPair): Record<"ground" | "input" | "coupler" | "output", number> {
  const {coordinate, center_homogeneous, circle_homogeneous} = result.curve.samples;
  const dyad = (t: number) => {
    const i = coordinate.findIndex((c: number) => Math.abs(c - t) < 1e-12);
    const flat = ([w, x, y]: number[]) => [x! / w!, y! / w!];
    return {center: flat(center_homogeneous[i]), circle: flat(circle_homogeneous[i])};
  };
  const apart = (a: number[], b: number[]) => Math.hypot(a[0]! - b[0]!, a[1]! - b[1]!);
  const input = dyad(tau[0]),
    output = dyad(tau[1]);
  return {
    ground: apart(input.center, output.center),
    input: apart(input.center, input.circle),
    coupler: apart(input.circle, output.circle),
    output: apart(output.center, output.circle),
  };
}
function expect_lengths(linkage: Linkage, wanted: Record<string, number>, relative: number): void {
  for (const [name, length] of Object.entries(wanted)) {
    const got = linkage.lengths![name as "ground"];
    expect(Math.abs(got - length) / length, `${name}: ${got}, not ${length}`).toBeLessThan(relative);
  }
}

const cell: TauPair = [1.3125, 1.1125]; // the middle of a cell of 400 × 400

test("4 · hovering shows another linkage, as the program computes it", async ({page}) => {
  await open_workbench(page);
  await until_settled(page);
  const picked = await hand(page);
  await hover(page, cell);
  const card = page.getByTestId("region.card");
  await expect(card).toContainText("Triple rocker, output");
  await expect(card).toContainText("γ 73.5° · ratio 4.7 · 256 mm");
  expect_lengths(await hand(page), {ground: 65.03, input: 211.05, coupler: 53.92, output: 255.9}, 1e-4);
  await keep_screenshot(page, "hover");

  const wanted = program_lengths(solve(example("tailgate")), cell);
  await read_state(page, (workbench, tau) => workbench.hover(tau), cell);
  await page.waitForFunction((tau) => (globalThis as any).__linkwright.workbench.hand.tau.join() === tau.join(), cell);
  expect_lengths(await hand(page), wanted, 1e-12);

  await page.mouse.move(700, 20);
  await expect(card).toBeHidden();
  await expect.poll(async () => (await hand(page)).tau).toEqual(picked.tau);
  expect((await hand(page)).lengths).toEqual(picked.lengths);

  // The ten best beside the map, in the program's order: looked at, taken in hand, pinned.
  await page.getByTestId("best.tab").click();
  await expect(page.getByTestId("best.10")).toBeVisible();
  const listed = await read_state(page, ({best_list}) =>
    best_list.found!.linkages.map(({tau, min_transmission_angle_deg: angle}) => [...tau, angle]),
  );
  const printed = solve(example("tailgate")).linkages.map((linkage: any) => [
    linkage.input.coordinate,
    linkage.output.coordinate,
    linkage.min_transmission_angle_deg,
  ]);
  expect(listed).toHaveLength(printed.length);
  for (const [i, numbers] of listed.entries())
    numbers.forEach((value, k) => expect(value, `number ${i + 1}`).toBeCloseTo(printed[i][k], 4));
  await page.getByTestId("best.3").hover();
  await expect.poll(async () => (await hand(page)).tau).toEqual(listed[2]!.slice(0, 2));
  await keep_screenshot(page, "best");
  await page.getByTestId("best.pin.3").click();
  await page.getByTestId("best.2").click();
  await page.mouse.move(700, 20);
  await expect.poll(async () => (await hand(page)).tau).toEqual(listed[1]!.slice(0, 2));
  expect(await read_state(page, ({pins}) => pins.map(({tau}) => tau))).toEqual([listed[2]!.slice(0, 2)]);
  await page.getByTestId("num.tab").click();
  await page.getByTestId("num.best").click();
  await expect.poll(async () => (await hand(page)).tau).toEqual(listed[0]!.slice(0, 2));
});

test("5 · X goes to the mirror cell: the same bars, driven from the other side", async ({page}) => {
  await open_workbench(page);
  const mirrored: Record<string, string> = {
    crank_rocker: "rocker_crank",
    rocker_crank: "crank_rocker",
    triple_rocker_input: "triple_rocker_output",
    triple_rocker_output: "triple_rocker_input",
  };
  for (const start of [cell, await rocker(page)]) {
    await pick(page, start);
    const before = await hand(page);
    await page.getByTestId("region.map").focus();
    await page.keyboard.press("x");
    await expect.poll(async () => (await hand(page)).tau).toEqual([before.tau[1], before.tau[0]]);
    const after = await hand(page);
    expect(after.type).toBe(mirrored[before.type] ?? before.type);
    expect(before.swapped!.type).toBe(after.type);
    expect_lengths(
      after,
      {
        ground: before.lengths!.ground,
        input: before.lengths!.output,
        coupler: before.lengths!.coupler,
        output: before.lengths!.input,
      },
      1e-12,
    );
  }
});
/** A cell of the map that is a crank-rocker. */
async function rocker(page: Page): Promise<TauPair> {
  await until_settled(page);
  return read_state(page, ({map}): TauPair => {
    const at = map!.type.indexOf(0);
    return [map!.input_tau[Math.floor(at / map!.samples)]!, map!.output_tau[at % map!.samples]!];
  });
}

test("6 · the map by keys alone", async ({page}) => {
  await open_workbench(page);
  await pick(page, cell);
  await tab_to(page, "region.map");
  const start = await places(page, cell),
    part = 1 / 400;
  const at = async () => places(page, await read_state(page, (workbench) => workbench.tau_in_hand!));
  const expect_at = (rows: number, columns: number) =>
    expect
      .poll(async () => {
        const [up, across] = await at();
        return [Math.round(((up - start[0]) / part) * 1e6) / 1e6, Math.round(((across - start[1]) / part) * 1e6) / 1e6];
      })
      .toEqual([rows, columns]);
  await page.keyboard.press("ArrowUp");
  await expect_at(1, 0);
  await page.keyboard.press("Shift+ArrowLeft");
  await expect_at(1, -10);
  await page.keyboard.press("Alt+ArrowRight");
  await expect_at(1, -9.9);

  const spoken = page.getByTestId("region.spoken");
  await expect
    .poll(
      async () =>
        (await hand(page)).tau.join() === (await read_state(page, (workbench) => workbench.tau_in_hand!)).join(),
    )
    .toBe(true);
  const linkage = await hand(page);
  const angle = linkage.min_transmission_angle_deg!.toFixed(1);
  await expect(spoken).toHaveText(`Triple rocker, output longest, transmission angle ${angle} degrees, no defects`);
  await expect(page.getByTestId("region.card")).toContainText(`γ ${angle}°`);

  await page.keyboard.press("Enter");
  await expect.poll(() => read_state(page, (workbench) => workbench.picked!.tau)).toEqual(linkage.tau);
  await page.keyboard.press("p");
  await expect.poll(() => read_state(page, (workbench) => workbench.pins.map((pin) => pin.tau))).toEqual([linkage.tau]);
  await expect(page.getByTestId("region.pin.A")).toBeVisible();
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("Escape");
  await expect.poll(() => read_state(page, (workbench) => workbench.hovered)).toBeNull();
  await page.keyboard.press("+");
  await expect(page.getByTestId("region.zoomed")).toHaveText("×1.6");
  await page.keyboard.press("0");
  await expect(page.getByTestId("region.zoomed")).toBeHidden();
});
/** Walks there by Tab; the focus is seen all the way. */
async function tab_to(page: Page, testid: string): Promise<void> {
  for (let i = 0; i < 150; ++i) {
    await page.keyboard.press("Tab");
    const on = await page.evaluate(() => {
      const element = document.activeElement as HTMLElement;
      const own = element?.closest("[aria-labelledby=region_title]");
      return {testid: element?.dataset?.testid ?? "", outline: own ? getComputedStyle(element).outlineStyle : "auto"};
    });
    expect(on.outline, `focus is seen on ${on.testid}`).not.toBe("none");
    if (on.testid === testid) return;
  }
  throw new Error(`Tab never comes to ${testid}`);
}

test("9 · the legend filters by type", async ({page}) => {
  await open_workbench(page);
  await until_settled(page);
  const button = page.getByTestId("region.map").page().locator("section").getByTestId("type.double_crank").last();
  const before = await read_state(page, ({census}) => ({meeting: census!.meeting, cranks: census!.meeting_types[2]})),
    hash = await map_hash(page);
  expect(before.cranks).toBeGreaterThan(0);
  await button.click();
  await expect
    .poll(() => read_state(page, (workbench) => workbench.census!.meeting))
    .toBe(before.meeting - before.cranks!);
  await expect.poll(() => map_hash(page)).not.toBe(hash);
  const washed = await read_state(page, ({map}) => map!.type.every((type, i) => type !== 2 || map!.fails[i] !== 0));
  expect(washed).toBe(true);
  expect(await read_state(page, (workbench) => workbench.whole_problem.requirements!.types)).toEqual(
    planar_types.filter((type) => type !== "double_crank"),
  );

  await button.click({modifiers: ["Alt"]});
  await expect.poll(() => read_state(page, (workbench) => workbench.census!.meeting)).toBe(before.cranks);
  const problem = await read_state(page, (workbench) => workbench.whole_problem);
  expect(problem.requirements!.types).toEqual(["double_crank"]);
  expect(new Set(solve(problem).linkages.map((linkage: Linkage) => linkage.type))).toEqual(new Set(["double_crank"]));
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+z");
  await expect.poll(() => read_state(page, (workbench) => workbench.census?.meeting)).toBe(before.meeting);
});

test("12 · through infinity", async ({page}) => {
  await open_workbench(page);
  await until_settled(page);
  const {axis, mark} = await read_state(page, ({task}) => ({
    axis: task!.axes.input,
    mark: task!.specials.find((special) => special.kind === "center_at_infinity" && special.tau.length)!.tau[0],
  }));
  const beyond = place_of(axis, mark!)!;
  await read_state(page, (workbench, tau) => workbench.pick(tau), [
    cell[0],
    await tau_at_place(page, beyond - 2.5 / 400),
  ] as const);
  await until_settled(page);
  await page.getByTestId("region.map").focus();
  let sliders = 0;
  for (let i = 0; i < 6; ++i) {
    await page.keyboard.press("ArrowRight");
    await page.waitForFunction(() => {
      const {workbench} = (globalThis as any).__linkwright;
      return workbench.hovered && workbench.hand?.tau.join() === workbench.hovered.join();
    });
    const card = page.getByTestId("region.card");
    await expect(card).toBeVisible();
    expect(await page.locator("body").innerText()).not.toMatch(/NaN|undefined|null|Infinity/);
    const linkage = await hand(page);
    if (linkage.tau[1] !== mark) continue;
    ++sliders;
    expect(linkage.output.center).toBeNull();
    await expect(card).toContainText("Slider");
  }
  expect(sliders).toBe(1);
  const far = await hand(page);
  expect(far.output.center).not.toBeNull();
  expect(Math.hypot(...far.output.center!)).toBeGreaterThan(1000);
});
async function tau_at_place(page: Page, place: number): Promise<number> {
  const {x, y} = await map_pixel(page, [0.5, place]);
  await page.mouse.move(x, y);
  await page.waitForFunction(() => (globalThis as any).__linkwright.workbench.hovered !== null);
  const tau = await read_state(page, (workbench) => workbench.hovered![1]);
  await page.mouse.move(700, 20);
  return tau;
}

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
