// The drawing by hand: walk-throughs 2, 3, 10, 11, 12 and the halo of 13, and what else can be taken hold of there.
import type {Locator, Page} from "@playwright/test";
import type {Point} from "../src/contract/messages";
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
  until_fine,
  until_mapped,
  until_settled,
  type Pixel,
} from "./support";
import type {MotionTask} from "../src/kinds/motion/task";

const handle = (page: Page, id: string): Locator => page.getByTestId(`drawing.${id}`);
const poses = (page: Page) =>
  read_state(page, (workbench) => (workbench.problem.task as MotionTask).poses.map((pose) => ({...pose})));
const picked = (page: Page) => read_state(page, (workbench) => workbench.picked!.tau);
async function canvas(page: Page): Promise<Pixel & {width: number; height: number}> {
  return (await page.getByTestId("drawing.canvas").boundingBox())!;
}
/** How far a dyad is from standing on circles in all positions: nothing that the page computes comes in. */
function off_circle(all: readonly {x: number; y: number; theta_deg: number}[], center: Point, circle: Point): number {
  const angle = (deg: number) => (deg * Math.PI) / 180;
  const [first] = all,
    dx = circle[0] - first!.x,
    dy = circle[1] - first!.y,
    back = angle(-first!.theta_deg);
  const body = [dx * Math.cos(back) - dy * Math.sin(back), dx * Math.sin(back) + dy * Math.cos(back)];
  const lengths = all.map(({x, y, theta_deg}) => {
    const c = Math.cos(angle(theta_deg)),
      s = Math.sin(angle(theta_deg));
    return Math.hypot(x + c * body[0]! - s * body[1]! - center[0], y + s * body[0]! + c * body[1]! - center[1]);
  });
  return Math.max(...lengths) - Math.min(...lengths);
}

/** Takes back what was done, so that all is as the page opens with it. */
async function begin_anew(page: Page): Promise<void> {
  await read_state(page, (workbench) => {
    while (workbench.can_undo) workbench.undo();
  });
  await until_fine(page);
}

test.beforeEach(async ({page}) => {
  await open_workbench(page);
  await read_state(page, (workbench) => {
    workbench.tour = null; // its hint lies over the drawing
  });
});

test("a position is dragged, turned and held: map, table and linkage follow, undo and Esc put all back", async ({
  page,
}) => {
  await test.step("dragged", async () => {
    await begin_anew(page);
    const before = {poses: await poses(page), hash: await map_hash(page), picked: await picked(page)};
    const from = await middle_of(handle(page, "disc_3")),
      hashes = new Set<string>();
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.keyboard.down("Alt"); // every pixel counts
    for (let i = 1; i <= 10; ++i) {
      await page.mouse.move(from.x + 4 * i, from.y - 2 * i);
      await until_mapped(page);
      hashes.add(await map_hash(page));
    }
    await page.keyboard.up("Alt"); // and in the end the grid
    expect(hashes.size).toBeGreaterThanOrEqual(5);
    await page.mouse.up();
    const [, , third] = await poses(page),
      step = await read_state(page, (workbench) => workbench.grid_step);
    expect(third!.x).toBeGreaterThan(before.poses[2]!.x);
    expect(third!.y).toBeGreaterThan(before.poses[2]!.y);
    for (const value of [third!.x, third!.y])
      expect(Math.abs(value / step - Math.round(value / step))).toBeLessThan(1e-9);
    await expect(page.getByTestId("task.x.3")).toHaveValue(String(third!.x));
    await expect(page.getByTestId("task.y.3")).toHaveValue(String(third!.y));

    await page.keyboard.press("Control+z");
    expect(await poses(page)).toEqual(before.poses);
    await until_fine(page);
    expect(await map_hash(page)).toBe(before.hash);
    expect(await picked(page)).toEqual(before.picked);
    expect(await read_state(page, (workbench) => workbench.can_undo)).toBe(false);
  });
  await test.step("turned: Shift snaps, Alt does not at all", async () => {
    await begin_anew(page);
    const disc = await middle_of(handle(page, "disc_2"));
    const to = {x: disc.x + 131, y: disc.y - 57};
    const turned = async (key: "Shift" | "Alt" | null, end?: () => Promise<void>) => {
      const from = await middle_of(handle(page, "knob_2"));
      if (key) await page.keyboard.down(key);
      await drag(page, from, to, 6, end);
      if (key) await page.keyboard.up(key);
      return (await poses(page))[1]!.theta_deg;
    };
    const shifted = await turned("Shift");
    expect(shifted).not.toBe(-25);
    expect(shifted % 15 === 0).toBe(true);
    await page.keyboard.press("Control+z");
    const free = await turned("Alt");
    expect(free).not.toBe(Math.round(free));
    const exact = (Math.atan2(disc.y - to.y, to.x - disc.x) * 180) / Math.PI;
    expect(Math.abs(free - exact)).toBeLessThan(1);
    await page.keyboard.press("Control+z");
    expect(await turned(null)).toBe(Math.round(free));
    await page.keyboard.press("Control+z");
    const after_escape = await turned(null, async () => {
      expect((await poses(page))[1]!.theta_deg).not.toBe(-25);
      await page.keyboard.press("Escape");
      expect((await poses(page))[1]!.theta_deg).toBe(-25);
    });
    expect(after_escape).toBe(-25);
    expect(await read_state(page, (workbench) => workbench.can_undo)).toBe(false);
  });
  await test.step("held: where it may go, and nowhere else are linkages", async () => {
    await begin_anew(page);
    const from = await middle_of(handle(page, "disc_3"));
    const {scale} = await page
      .getByTestId("drawing.ground_box")
      .evaluate((box) => ({scale: Number(box.getAttribute("width")) / 360}));
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    const halo = page.getByTestId("drawing.halo");
    await expect(halo).toBeVisible();
    await page.waitForFunction(() => globalThis.__linkwright!.workbench.halo!.reach === 30); // it looks closer than at first
    const squares = await halo.locator("rect").evaluateAll((all) =>
      all.map((r) => ({
        offset: r.getAttribute("data-offset")!.split(",").map(Number),
        count: Number(r.getAttribute("data-count")),
      })),
    );
    expect(squares.length).toBeGreaterThan(20);
    expect(squares.every((s) => Math.hypot(...s.offset) < 40)).toBe(true);
    await keep_screenshot(page, "halo");
    const target = squares.filter((s) => s.offset[0] !== 0 || s.offset[1] !== 0).sort((a, b) => b.count - a.count)[0];
    await page.keyboard.down("Alt"); // no snapping: the grid is wider than the room there is
    await page.mouse.move(from.x + target!.offset[0]! * scale, from.y - target!.offset[1]! * scale, {steps: 4});
    const [, , third] = await poses(page);
    expect(Math.hypot(third!.x + 220 - target!.offset[0]!, third!.y - 220 - target!.offset[1]!)).toBeLessThan(
      1 / scale,
    );
    await page.mouse.up();
    await page.keyboard.up("Alt");
    await expect(halo).toBeHidden();
    await until_fine(page);
    expect(await read_state(page, (workbench) => workbench.census!.meeting)).toBeGreaterThan(0);
  });
});

test("a box is drawn where the ground pivots must lie, resized, and both agree with the program", async ({page}) => {
  const area = await canvas(page);
  await page.keyboard.press("r");
  await expect(page.getByTestId("drawing.mode")).toBeVisible();
  await drag(
    page,
    {x: area.x + 0.55 * area.width, y: area.y + 0.3 * area.height},
    {x: area.x + 0.9 * area.width, y: area.y + 0.6 * area.height},
  );
  await expect(page.getByTestId("drawing.mode")).toBeHidden();
  await expect(page.getByTestId("drawing.ground_box")).toBeVisible();
  const problem = () => read_state(page, (workbench) => JSON.parse(JSON.stringify(workbench.problem)));
  const drawn = (await problem()).requirements.ground_pivots_within;
  expect(drawn).not.toEqual(example("tailgate").requirements.ground_pivots_within);
  await until_fine(page);

  const outside = await read_state(
    page,
    async (workbench, box) => {
      const {map} = workbench,
        cells = [...map!.fails.keys()].filter((i) => map!.fails[i] === 0),
        n = map!.samples;
      const chosen = Array.from({length: 50}, (_, k) => cells[Math.floor(((k + 0.5) / 50) * cells.length)]),
        bad = [];
      for (const cell of chosen) {
        const tau: [number, number] = [map!.input_tau[Math.floor(cell! / n)]!, map!.output_tau[cell! % n]!];
        const {linkage} = await workbench.driver_client!.follow("linkage", {
          problem: JSON.stringify({...workbench.problem, view: undefined}),
          tau,
        });
        const within = (p: readonly [number, number] | null) =>
          p && p[0] >= box.x[0] && p[0] <= box.x[1] && p[1] >= box.y[0] && p[1] <= box.y[1];
        if (!within(linkage.input.center) || !within(linkage.output.center)) bad.push(tau);
      }
      return bad;
    },
    drawn,
  );
  expect(outside).toEqual([]);
  const census = await read_state(page, (workbench) => workbench.census!.meeting);
  expect(census).toBe(solve(await problem()).region.meeting_requirements);

  const corner = await middle_of(handle(page, "box_ground_1_1"));
  await drag(page, corner, {x: corner.x - 30, y: corner.y + 20});
  const smaller = (await problem()).requirements.ground_pivots_within;
  expect(smaller.x[1]).toBeLessThan(drawn.x[1]);
  expect(smaller.y[1]).toBeLessThan(drawn.y[1]);
  expect([smaller.x[0], smaller.y[0]]).toEqual([drawn.x[0], drawn.y[0]]);
  await page.keyboard.press("r");
  await page.keyboard.press("r");
  expect(await read_state(page, (workbench) => workbench.mode)).toBe("moving_box");
  await page.keyboard.press("Escape");
  expect(await read_state(page, (workbench) => workbench.mode)).toBe("point");

  // It may begin below the banner that asks for it.
  const before_banner = JSON.stringify(await problem());
  await page.keyboard.press("r");
  const banner = (await page.getByTestId("drawing.mode").locator("p").boundingBox())!;
  await drag(
    page,
    {x: banner.x + banner.width / 2, y: banner.y + banner.height / 2},
    {x: banner.x + banner.width / 2 + 200, y: banner.y + 250},
  );
  expect(JSON.stringify(await problem())).not.toBe(before_banner);
});

test("a pivot slides along its curve, is hatched off its thick part, is put where a curve is clicked, and goes through infinity", async ({
  page,
}) => {
  await test.step("its column of the map goes with it, the row stays", async () => {
    await begin_anew(page);
    const start = await read_state(page, (workbench) => ({
      tau: workbench.picked!.tau,
      place: workbench.picked!.place!,
    }));
    const home = handle(page, "pivot_output_circle_home"),
      from = await middle_of(home);
    // Sixty pixels along the live part, from where the pivot is.
    const way = await page.getByTestId("drawing.live_output_circle").evaluate((path, at) => {
      const {x, y} = (path as SVGPathElement).ownerSVGElement!.getBoundingClientRect(),
        curve = path as SVGPathElement,
        length = curve.getTotalLength();
      const point = (s: number) => ({x: curve.getPointAtLength(s).x + x, y: curve.getPointAtLength(s).y + y});
      const away = (s: number) => Math.hypot(point(s).x - at.x, point(s).y - at.y);
      let best = 0;
      for (let s = 0; s <= length; s += 0.5) if (away(s) < away(best)) best = s;
      for (const sign of [1, -1]) {
        const list = Array.from({length: 13}, (_, k) => point(best + sign * 5 * k));
        const connected = list.every(
          (p, k) => k === 0 || Math.abs(Math.hypot(p.x - list[k - 1]!.x, p.y - list[k - 1]!.y) - 5) < 1.5,
        );
        if (connected && best + sign * 60 >= 0 && best + sign * 60 <= length) return list;
      }
      return null;
    }, from);
    expect(way).not.toBeNull();
    const task_poses = await poses(page),
      columns = new Set<number>();
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    for (const at of way!.slice(1)) {
      await page.mouse.move(at.x, at.y);
      await until_settled(page);
      const now = await read_state(page, (workbench) => ({
        place: workbench.picked!.place!,
        output: workbench.hand!.output,
        fails: workbench.hand!.fails,
      }));
      expect(off_circle(task_poses, now.output.center!, now.output.circle!)).toBeLessThan(1e-6);
      expect(now.place[0]).toBe(start.place[0]);
      expect(now.fails).toBe(0);
      columns.add(now.place[1]);
      // The pivot is where the pointer is: the engine put it there.
      const seen = await middle_of(home);
      expect(Math.hypot(seen.x - at.x, seen.y - at.y)).toBeLessThan(3);
    }
    await page.mouse.up();
    expect(columns.size).toBeGreaterThanOrEqual(10);
    expect((await picked(page))[0]).toBe(start.tau[0]);
    await page.keyboard.press("Control+z");
    expect(await picked(page)).toEqual(start.tau);
  });
  await test.step("off the thick part the linkage is hatched and says why", async () => {
    await begin_anew(page);
    const from = await middle_of(handle(page, "pivot_output_circle_home")),
      area = await canvas(page);
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(area.x + 0.45 * area.width, area.y + area.height - 8, {steps: 12});
    await until_settled(page);
    await page.mouse.move(area.x + 0.45 * area.width, area.y + area.height - 6);
    expect(await read_state(page, (workbench) => workbench.hand!.fails)).not.toBe(0);
    await expect(handle(page, "linkage")).toHaveAttribute("data-fails", "true");
    await expect(page.getByTestId("drawing.note").locator("p")).not.toBeEmpty();
    await page.mouse.up();
    await expect(page.getByTestId("drawing.reason")).toBeVisible();
    await page.keyboard.press("Control+z");
    await expect(handle(page, "linkage")).toHaveAttribute("data-fails", "false");
  });
  await test.step("a place on a curve shows its grounded link; a click puts the nearer one there, Shift the other", async () => {
    await begin_anew(page);
    // A place of the circle-point curve that nothing else is near to.
    const spot = await page.getByTestId("curve.circle_path").evaluate((path) => {
      const curve = path as SVGPathElement,
        svg = curve.ownerSVGElement!,
        box = svg.getBoundingClientRect(),
        length = curve.getTotalLength();
      const handles = [...svg.querySelectorAll(".handle")].map((h) => [
        Number(h.getAttribute("cx")),
        Number(h.getAttribute("cy")),
      ]);
      const boxes = [...svg.querySelectorAll<SVGRectElement>("[data-testid$=_box]")].map((r) => r.getBBox());
      const center = svg.querySelector<SVGPathElement>('[data-testid="curve.center_path"]')!;
      const centers = Array.from({length: 400}, (_, k) => center.getPointAtLength((k / 400) * center.getTotalLength()));
      for (let s = 0; s < length; s += 2) {
        const p = curve.getPointAtLength(s),
          inside = p.x > 60 && p.y > 60 && p.x < box.width - 60 && p.y < box.height - 80;
        const free =
          handles.every(([x, y]) => Math.hypot(x! - p.x, y! - p.y) > 30) &&
          centers.every((c) => Math.hypot(c.x - p.x, c.y - p.y) > 25);
        const clear = boxes.every(
          (b) =>
            [b.x, b.x + b.width].every((x) => Math.abs(x - p.x) > 30) &&
            [b.y, b.y + b.height].every((y) => Math.abs(y - p.y) > 30),
        );
        if (inside && free && clear) return {x: p.x + box.x, y: p.y + box.y};
      }
      return null;
    });
    const before = await picked(page);
    await page.mouse.move(spot!.x, spot!.y);
    await expect(page.getByTestId("drawing.dyad")).toBeVisible();
    const tau = await read_state(page, (workbench) => workbench.curve_hover!.tau);
    await expect(page.getByTestId("drawing.note")).toContainText(tau.toFixed(4));
    await page.mouse.click(spot!.x, spot!.y);
    await until_settled(page);
    const nearer = await picked(page),
      side = nearer[0] === before[0] ? 1 : 0;
    expect(nearer[side]).toBeCloseTo(tau, 9);
    const reached = await read_state(page, (workbench, k) => workbench.hand![k ? "output" : "input"], side);
    expect(off_circle(await poses(page), reached.center!, reached.circle!)).toBeLessThan(1e-6);
    await page.keyboard.press("Control+z");
    await until_settled(page);
    await page.keyboard.down("Shift");
    await page.mouse.click(spot!.x, spot!.y);
    await page.keyboard.up("Shift");
    const farther = await picked(page);
    expect(farther[1 - side]).toBeCloseTo(tau, 9);
    expect(farther[side]).toBe(before[side]);
    await page.mouse.move(5, 5);
    expect(await read_state(page, (workbench) => workbench.curve_hover)).toBeNull();
  });
  await test.step("out of the window it goes through infinity and comes back from the other side", async () => {
    await begin_anew(page);
    const at_infinity = await read_state(
      page,
      (workbench) => workbench.task!.specials.find((s) => s.kind === "center_at_infinity")!.tau[0],
    );
    const other = (await picked(page))[1];
    await read_state(page, (workbench, tau) => workbench.pick(tau), [at_infinity!, other!] as const);
    await until_settled(page);
    expect(await read_state(page, (workbench) => workbench.hand!.type)).toBe("degenerate");
    const markup = () => page.getByTestId("drawing.canvas").evaluate((svg) => svg.outerHTML);
    expect(await markup()).toContain("∞");
    expect(await markup()).not.toMatch(/NaN|Infinity|undefined/);
    await expect(page.getByTestId("drawing.reason")).toBeVisible();

    // Back to a pivot in the window that is on the same branch: the sample nearest to where the curve leaves at the lower right.
    const edge = await page.getByTestId("curve.center_path").evaluate((path) => {
      const curve = path as SVGPathElement,
        svg = curve.ownerSVGElement!.getBoundingClientRect(),
        length = curve.getTotalLength();
      let best = {x: 0, y: 0};
      for (let s = 0; s < length; s += 1) {
        const p = curve.getPointAtLength(s);
        if (p.x < svg.width - 25 && p.y > 60 && p.y < svg.height - 25 && p.x + p.y > best.x + best.y) best = p;
      }
      return {x: best.x + svg.x, y: best.y + svg.y};
    });
    await page.mouse.click(edge.x, edge.y);
    await until_settled(page);
    const input_moved = (await picked(page))[0] !== at_infinity,
      side = input_moved ? "input" : "output";
    const pivot = handle(page, `pivot_${side}_center`),
      start = await middle_of(pivot),
      area = await canvas(page);
    expect(Math.hypot(start.x - edge.x, start.y - edge.y)).toBeLessThan(4);
    await page.mouse.move(start.x, start.y);
    await page.mouse.down();
    const out = area.x + area.width - start.x < area.y + area.height - start.y ? {x: 1, y: 0} : {x: 0, y: 1};
    const room = out.x ? area.x + area.width - start.x : area.y + area.height - start.y;
    for (let over = -room; over <= 170; over += 10) {
      await page.mouse.move(
        start.x + out.x * (room + over) + (1 - out.x) * (room + Math.min(over, 0)) * 0.8,
        start.y + out.y * (room + over) + (1 - out.y) * (room + Math.min(over, 0)) * 0.8,
      );
      await until_settled(page);
      expect(await markup()).not.toMatch(/NaN|Infinity|undefined/);
    }
    await page.mouse.up();
    const there = await middle_of(pivot);
    expect(
      Math.hypot(there.x - start.x, there.y - start.y),
      "back in the window at quite another place",
    ).toBeGreaterThan(150);
    const link = await read_state(page, (workbench, name) => workbench.hand![name as "input"], side);
    expect(off_circle(await poses(page), link.center!, link.circle!)).toBeLessThan(1e-6 * Math.max(1, link.length!));
  });
});
