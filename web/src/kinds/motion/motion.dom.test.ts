// Three and five positions: walk-through 20, and what is given beside three.
import {expect, test} from "vitest";
import {
  choose,
  click,
  field,
  focus,
  get,
  is_there,
  open_problem,
  open_settled,
  press,
  text,
  type_into,
  until,
  until_settled,
  until_there,
  value_of,
  workbench,
} from "../../../tests/page/support";
import {example, solve} from "../../../tests/program";
import type {Point, TauPair} from "../../contract/messages";
import type {Given, MotionTask} from "./task";

const given = <G extends Given>() => (workbench.problem.task as MotionTask).given as G | undefined;
const quantities = () => [workbench.task!.axes.input.quantity, workbench.task!.axes.output.quantity];
const notice = (name: string) => get("region.notice").querySelector(`[data-testid="${name}"]`)!;
const until_quantity = async (quantity: string) => {
  await until(() => workbench.task?.axes.output.quantity === quantity);
  await until_settled();
};
function expect_lengths(wanted: Record<string, number>): void {
  for (const [name, length] of Object.entries(wanted))
    expect(Math.abs(workbench.hand!.lengths![name as "ground"] / length - 1), name).toBeLessThan(1e-6); // found from two maps
}
async function open(name: string): Promise<void> {
  await open_settled();
  await open_problem(example(name));
}

test("three positions: two lengths are given, and the linkage is the program's", async () => {
  await open("latch");
  expect_lengths(solve(example("latch")).linkages[0].lengths);
  expect(text("task.pattern")).toBe("P-P-P");
  expect(get("region.mirror").classList).toContain("gone");

  // A sheet fills the map; the whole map comes back.
  await click("region.sheet.II");
  await until(() => workbench.map!.window.output[0] > 0);
  await until_settled();
  const ends = (list: Float64Array) => [Math.floor(Math.min(...list)), Math.floor(Math.max(...list))];
  expect([ends(workbench.map!.input_tau), ends(workbench.map!.output_tau)]).toEqual([
    [0, 0],
    [1, 1],
  ]);
  await click("region.sheet.II");
  await until_settled();
  expect(workbench.map!.window.output[0]).toBe(0);
});

test("three positions: one length is enough, the engine chooses the other and says which; keys take it in hand", async () => {
  await open("latch");
  await click("given.side_length");
  await until_settled();
  expect(text("task.warning")).toMatch(/length of the output link was left open/);
  const chosen = workbench.hand!.output.length!;
  expect(field("given.length_output").placeholder).toMatch(/\d/);
  await focus("drawing.ring_output");
  await press("ArrowUp");
  await until_settled();
  const [, taken] = given<{side_lengths: [number, number]} & Given>()!.side_lengths;
  expect(taken).toBeGreaterThan(chosen);
  expect(Number(value_of("given.length_output"))).toBeCloseTo(taken, 2);
  expect(workbench.hand!.output.length).toBeCloseTo(taken, 9);
});

test("three positions: the angle between the grounded links is stepped, and they stand at it", async () => {
  await open("latch");
  await click("req.reset"); // the boxes leave none at this angle
  await click("given.side_angle");
  await type_into("given.length_input", "18");
  await until_quantity("side_length");
  await focus("drawing.side_angle");
  await press("ArrowUp");
  await until_settled();
  expect(given<{side_angle_deg: number} & Given>()!.side_angle_deg).toBe(61);
  await workbench.pick_best(); // the one that was in hand may be no more
  await until_settled();
  const direction = ({center, circle}: {center: Point | null; circle: Point | null}) =>
    Math.atan2(circle![1] - center![1], circle![0] - center![0]);
  const {input, output} = workbench.hand!,
    turn = ((direction(output) - direction(input)) * 180) / Math.PI - 61;
  expect(Math.abs(turn - 360 * Math.round(turn / 360))).toBeLessThan(1e-6);
});

test("three positions: a given instant centre makes an ordinary map, and a fourth position makes it needless", async () => {
  await open("latch");
  await click("given.instant_center");
  await until(() => workbench.task?.symmetric);
  await until_settled();
  expect(workbench.task!.curves.kind).not.toBe("every_point");
  expect(text("given.family")).toContain("2");

  await click("task.add");
  await until_settled();
  expect(given()).toBeUndefined();
  expect(is_there("given.side_lengths")).toBe(false);
  await click("task.menu.4");
  await click("task.remove");
  await until_there("region.notice");
  expect(text("region.notice")).toContain("choose an additional constraint");
  await click(notice("given.side_lengths"));
  await until_settled();
  expect(is_there("region.notice")).toBe(false);
});

test("three positions: an open pivot is the map, a line carries both", async () => {
  await open("bracket_hatch");
  expect_lengths(solve(example("bracket_hatch")).linkages[0].lengths);
  await choose("given.pivot_output", "");
  await until_settled();
  expect(given()).toEqual({input_ground_pivot: [120, 340]});
  expect(quantities()).toEqual(["center_y", "center_x"]);
  const {center} = workbench.hand!.input;
  expect(Math.hypot(center![0] - 120, center![1] - 340)).toBeLessThan(1e-6);

  await click("given.pivot_lines");
  await until_settled();
  expect(quantities()).toEqual(["center_on_line", "center_on_line"]);
  await focus("drawing.line_ground_direction");
  await press("ArrowUp");
  await until_settled();
  expect(given<{ground_pivot_on: {direction_deg: number}} & Given>()!.ground_pivot_on.direction_deg).toBe(1);
});

test("20 · five positions: a board of as many four-bars as the program finds, gone through by keys", async () => {
  await open("nose_gear");
  const result = solve(example("nose_gear")),
    count = result.dyads.length;
  expect([workbench.map!.rows, workbench.map!.columns]).toEqual([count, count]);
  expect(document.querySelectorAll("[data-testid^='curve.bead_center_']")).toHaveLength(count);
  expect(document.querySelectorAll("[data-testid^='region.board.']")).toHaveLength(count * (count - 1));
  expect_lengths(result.linkages[0].lengths);

  // Every cell is the linkage of its grounded links.
  workbench.hover([0.5, 2.5]);
  await until(() => workbench.hand?.tau.join() === "0.5,2.5");
  const {input, output} = workbench.hand!,
    [px, py] = result.dyads[0].center_point,
    [qx, qy] = result.dyads[2].circle_point;
  expect(Math.hypot(input.center![0] - px, input.center![1] - py)).toBeLessThan(1e-6);
  expect(Math.hypot(output.circle![0] - qx, output.circle![1] - qy)).toBeLessThan(1e-6);
  workbench.hover(null);
  workbench.pick([0.5, 2.5]);
  await until_settled();
  await focus("region.map");
  await press("ArrowLeft");
  await press("Enter");
  await until_settled();
  expect(workbench.picked!.tau.join()).toBe("0.5,1.5");
  await press("x");
  await until_settled();
  expect(workbench.picked!.tau.join()).toBe("1.5,0.5");
});

test("20 · five positions, one of them freed: the map is coloured by the miss, which is nothing where all are met", async () => {
  await open("nose_gear");
  const {input, output} = workbench.hand!,
    {rows} = workbench.map!;
  await click("freed.3");
  await until(() => workbench.map?.property === "pose_miss" && workbench.map.rows > 100);
  await until_settled();
  expect(await least_miss(input.center!, output.center!)).toBeLessThan(1e-3);
  expect(text("num.miss")).toContain("mm");
  await click("freed.none");
  await until_settled();
  expect(workbench.map!.rows).toBe(rows);
});
/** From the samples of the curve nearest to these ground pivots, downhill to where the miss is least. */
async function least_miss(...centers: [Point, Point]): Promise<number> {
  const {tau, center} = workbench.task!.curves,
    problem = JSON.stringify({...workbench.problem, view: undefined});
  const away = (i: number, [x, y]: Point) =>
    Math.hypot(center[3 * i + 1]! / center[3 * i]! - x, center[3 * i + 2]! / center[3 * i]! - y);
  const nearest = (to: Point) => [...tau.keys()].reduce((best, i) => (away(i, to) < away(best, to) ? i : best), 0);
  const miss_at = async (at: TauPair) =>
    (await workbench.driver_client!.run({kind: "linkage", problem, tau: at})).linkage.miss?.distance ?? Infinity;
  let [input, output] = centers.map((one) => tau[nearest(one)]!) as [number, number],
    least = await miss_at([input, output]);
  for (let step = 0.004; step > 1e-8; step /= 2)
    for (let better = true; better;) {
      better = false;
      for (const there of [
        [input + step, output],
        [input - step, output],
        [input, output + step],
        [input, output - step],
      ] as const) {
        const miss = await miss_at(there);
        if (miss < least) [[input, output], least, better] = [there, miss, true];
      }
    }
  return least;
}
