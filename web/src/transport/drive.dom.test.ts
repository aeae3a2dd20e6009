// Walk-through 14: the drive of the linkage in hand, and its plots.
import {beforeEach, expect, test, vi} from "vitest";
import {
  click,
  download,
  focus,
  get,
  open_settled,
  played_poses,
  poses_of_page,
  press,
  text,
  until,
  workbench,
} from "../../tests/page/support";
import {solve} from "../../tests/program";
/** Where the drive stands at a position (from 0). */
function angle_at(pose: number): number {
  const {states, ticks} = workbench.hand!.drive!;
  return states[13 * ticks[pose]!.state]! + 0;
}

beforeEach(open_settled);

test("keys move it by a degree or to the next position, and Step goes round; the body is exactly there", async () => {
  await focus("drive.angle");
  await press("Home");
  await press("Shift+ArrowRight");
  expect(workbench.angle).toBe(0);
  await press("ArrowRight");
  expect(workbench.angle).toBeCloseTo(1, 12);
  await press("Shift+ArrowRight");
  expect(workbench.angle).toBe(angle_at(1));
  for (const pose of [2, 3, 0]) {
    await click("drive.step");
    expect(workbench.angle).toBe(angle_at(pose));
    expect(get("drive.angle").getAttribute("aria-valuetext")).toMatch(new RegExp(`position ${pose + 1}$`));
  }
  const {states, ticks} = workbench.hand!.drive!;
  for (const [pose, {x, y, theta_deg}] of poses_of_page().entries()) {
    const at = 13 * ticks[pose]!.state,
      turn = ((states[at + 7]! - theta_deg) / 360) % 1;
    expect(Math.hypot(states[at + 5]! - x, states[at + 6]! - y)).toBeLessThan(1e-9);
    expect(Math.abs(turn - Math.round(turn)) * 360).toBeLessThan(1e-9);
  }
});

test("it is that of the program's best linkage", () => {
  const best = solve(workbench.whole_problem).linkages[0],
    {tau, driver_sweep_deg} = workbench.hand!;
  expect(tau[0]).toBeCloseTo(best.input.coordinate, 5); // along a ridge that is all but level
  expect(driver_sweep_deg).toBeCloseTo(best.driver_sweep_deg, 2);
  expect(angle_at(3) - angle_at(0)).toBeCloseTo(driver_sweep_deg!, 9);
});

test("playing passes the positions in order and a rocker stops at its limit", async () => {
  await click("drive.whole_travel");
  await click(document.querySelector("[data-speed='4']")!);
  await click("drive.repeat"); // over and over
  await click("drive.repeat"); // once
  await focus("drive.angle");
  await press("Home");
  expect(await played_poses()).toEqual([0, 1, 2, 3]);
  const {hand, angle, playing} = workbench,
    high = hand!.drive!.states.at(-13)!;
  expect(playing).toBe(false);
  expect(hand!.drive!.limits.high).toBe("dead_point");
  expect(angle).toBe(high);
  expect(Math.min(...hand!.dead_points_deg.map((dead) => Math.abs(dead - high)))).toBeLessThan(1e-6);
});

test("plots show the value at the cursor and are saved as CSV", async () => {
  await focus("drive.angle");
  await press("Home");
  await press("Shift+ArrowRight");
  const {states, ticks} = workbench.hand!.drive!,
    transmission = states[13 * ticks[0]!.state + 8]!;
  expect(text("plot.value")).toBe(`${transmission.toFixed(1)}°`);
  for (const kind of ["coupler", "velocity", "advantage", "path"]) {
    await click(`plot.${kind}`);
    expect(text("plot.value")).not.toMatch(/NaN|^$/);
  }
  const {name, bytes} = await download(() => click("plot.csv"));
  expect(name).toMatch(/^tailgate-hinge-.*-path\.csv$/);
  const lines = bytes.toString().trim().split("\n");
  expect(lines[0]).toBe("input_deg,x,y");
  expect(lines[1]!.split(",").map(Number)).toEqual([0, 0, 0]);
});

test("who wants stillness gets steps", async () => {
  vi.spyOn(globalThis, "matchMedia").mockImplementation(
    (query) => ({matches: /reduced-motion/.test(query), addEventListener: () => {}}) as unknown as MediaQueryList,
  );
  expect(workbench.playing).toBe(false);
  const {states, ticks} = workbench.hand!.drive!,
    stops = ticks.map((tick) => states[13 * tick.state]!),
    start = workbench.angle,
    seen = new Set<number>();
  await click(document.querySelector("[data-speed='4']")!);
  await click("drive.play");
  await until(() => seen.add(workbench.angle).size >= 3);
  expect([...seen].filter((angle) => angle !== start && !stops.includes(angle))).toEqual([]);
});
