// The solution region by keys and by its legend: walk-throughs 4, 5, 6, 9 and 12.
import {tick} from "svelte";
import {beforeEach, expect, test} from "vitest";
import {
  all,
  begin,
  click,
  focus,
  get,
  is_there,
  open_settled,
  press,
  shown,
  text,
  until,
  until_settled,
  until_there,
  workbench,
} from "../../tests/page/support";
import {times_made} from "../../tests/page/times_made.svelte";
import {example, solve} from "../../tests/program";
import {place_of} from "../engine/axis";
import type {TauPair} from "../contract/messages";
import {planar_types} from "../kinds/planar";

const cell: TauPair = [1.3125, 1.1125]; // the middle of a cell of 400 × 400
const hand = () => workbench.hand!;
const part = 1 / 400;
const places = (tau: TauPair) => tau.map((one) => place_of(workbench.task!.axes.input, one)!);
async function pick(tau: TauPair): Promise<void> {
  workbench.pick(tau);
  await until_settled();
}
async function hover(tau: TauPair | null): Promise<void> {
  workbench.hover(tau);
  await until_settled();
}
function expect_lengths(wanted: Record<string, number>, relative: number): void {
  for (const [name, length] of Object.entries(wanted)) {
    const got = hand().lengths![name as "ground"];
    expect(Math.abs(got - length) / length, `${name}: ${got}, not ${length}`).toBeLessThan(relative);
  }
}
/** Lengths of a cell of the program's own curve samples. */
function program_lengths(result: ReturnType<typeof solve>, tau: TauPair): Record<string, number> {
  const {coordinate, center_homogeneous, circle_homogeneous} = result.curve.samples,
    flat = ([w, x, y]: number[]) => [x! / w!, y! / w!];
  const [input, output] = tau.map((t) => {
    const i = coordinate.findIndex((c: number) => Math.abs(c - t) < 1e-12);
    return {center: flat(center_homogeneous[i]), circle: flat(circle_homogeneous[i])};
  });
  const apart = (a: number[], b: number[]) => Math.hypot(a[0]! - b[0]!, a[1]! - b[1]!);
  return {
    ground: apart(input!.center, output!.center),
    input: apart(input!.center, input!.circle),
    coupler: apart(input!.circle, output!.circle),
    output: apart(output!.center, output!.circle),
  };
}

beforeEach(open_settled);

test("4 · what is pointed at is another linkage, as the program computes it", async () => {
  const picked = hand();
  await hover(cell);
  expect_lengths(program_lengths(solve(example("tailgate")), cell), 1e-12);
  await hover(null);
  expect(hand().tau).toEqual(picked.tau);
  expect(hand().lengths).toEqual(picked.lengths);
});

test("what is made of the linkage in hand is made once for each: not when another is asked for or required", async () => {
  const made = times_made(() => workbench.hand);
  await tick();
  workbench.hover(cell);
  await tick();
  expect(made.count).toBe(1);
  await until_settled();
  expect(made.count).toBe(2);
  workbench.begin_gesture();
  workbench.drag((problem) => ({
    ...problem,
    requirements: {...problem.requirements, min_transmission_angle_deg: 31},
  }));
  await tick();
  expect(made.count).toBe(2);
  workbench.cancel_gesture();
  made.stop();
});

test("4 · the ten best stand beside the map, in the program's order: looked at, taken in hand, pinned", async () => {
  await click("best.tab");
  await until_there("best.10");
  const listed = workbench.best_list.found!.linkages,
    printed = solve(example("tailgate")).linkages;
  expect(listed).toHaveLength(printed.length);
  for (const [i, {tau, min_transmission_angle_deg: angle}] of listed.entries()) {
    const {input, output, min_transmission_angle_deg} = printed[i];
    [input.coordinate, output.coordinate, min_transmission_angle_deg].forEach((value, k) =>
      expect([...tau, angle][k], `number ${i + 1}`).toBeCloseTo(value, 4),
    );
  }
  await click("best.pin.3");
  await click("best.2");
  await until_settled();
  expect(hand().tau).toEqual(listed[1]!.tau);
  expect(workbench.pins.map(({tau}) => tau)).toEqual([listed[2]!.tau]);
  await click("num.tab");
  await click("num.best");
  await until_settled();
  expect(hand().tau).toEqual(listed[0]!.tau);
});

test("a row of the best is taken wherever it is clicked, and no list of another task stays", async () => {
  await click("best.tab");
  await until_there("best.3");
  const row = get("best.3").closest("tr")!;
  await click(row.querySelectorAll("td")[3]!);
  expect(workbench.picked!.tau).toEqual(workbench.best_list.found!.linkages[2]!.tau);
  await begin("straight_search");
  await until(() => !is_there("best.1"));
});

test("5 · X goes to the mirror cell: the same bars, driven from the other side", async () => {
  const mirrored: Record<string, string> = {
    crank_rocker: "rocker_crank",
    rocker_crank: "crank_rocker",
    triple_rocker_input: "triple_rocker_output",
    triple_rocker_output: "triple_rocker_input",
  };
  const {type, input_tau, output_tau, columns} = workbench.map!,
    crank = type.indexOf(0);
  for (const start of [cell, [input_tau[Math.floor(crank / columns)]!, output_tau[crank % columns]!] as const]) {
    await pick([...start]);
    const before = hand(),
      {ground, input, coupler, output} = before.lengths!;
    await focus("region.map");
    await press("x");
    await until_settled();
    expect(hand().tau).toEqual([before.tau[1], before.tau[0]]);
    expect(hand().type).toBe(mirrored[before.type] ?? before.type);
    expect(before.swapped!.type).toBe(hand().type);
    expect_lengths({ground, input: output, coupler, output: input}, 1e-12);
  }
});

test("6 · the map by keys alone", async () => {
  await pick(cell);
  await focus("region.map");
  const start = places(cell);
  const expect_at = (rows: number, columns: number) => {
    const [up, across] = places(workbench.tau_in_hand!);
    expect((up! - start[0]!) / part).toBeCloseTo(rows, 5);
    expect((across! - start[1]!) / part).toBeCloseTo(columns, 5);
  };
  await press("ArrowUp");
  expect_at(1, 0);
  await press("Shift+ArrowLeft");
  expect_at(1, -10);
  await press("Alt+ArrowRight");
  expect_at(1, -9.9);
  await until_settled();
  const {tau, min_transmission_angle_deg} = hand(),
    angle = min_transmission_angle_deg!.toFixed(1);
  await until(() =>
    text("region.spoken").includes(`Triple rocker, output longest, transmission angle ${angle} degrees, no defects`),
  );
  expect(text("region.card")).toContain(`γ ${angle}°`);

  await press("Enter");
  await until_settled();
  expect(workbench.picked!.tau).toEqual(tau);
  await press("p");
  expect(workbench.pins.map((pin) => pin.tau)).toEqual([tau]);
  expect(is_there("region.pin.A")).toBe(true);
  await press("ArrowUp");
  expect(workbench.hovered).not.toBeNull();
  await press("Escape");
  expect(workbench.hovered).toBeNull();
  await press("+");
  expect(text("region.zoomed")).toBe("×1.6");
  await press("0");
  expect(is_there("region.zoomed")).toBe(false);
});

test("9 · the legend filters by type", async () => {
  const legend = () => all("type.double_crank").at(-1)!,
    {meeting, meeting_types} = workbench.census!,
    cranks = meeting_types[2]!,
    before = shown();
  expect(cranks).toBeGreaterThan(0);
  await click(legend());
  await until_settled();
  expect(workbench.census!.meeting).toBe(meeting - cranks);
  expect(shown().map).not.toBe(before.map);
  const {type, fails} = workbench.map!;
  expect(type.every((one, i) => one !== 2 || fails[i] !== 0)).toBe(true);
  expect(workbench.problem.requirements!.types).toEqual(planar_types.filter((one) => one !== "double_crank"));

  await click(legend(), {altKey: true});
  await until_settled();
  expect(workbench.census!.meeting).toBe(cranks);
  expect(workbench.problem.requirements!.types).toEqual(["double_crank"]);
  const found = solve(workbench.whole_problem).linkages as {type: string}[];
  expect(new Set(found.map((linkage) => linkage.type))).toEqual(new Set(["double_crank"]));
  await press("Control+z");
  await press("Control+z");
  await until_settled();
  expect(workbench.census!.meeting).toBe(meeting);
});

test("12 · through infinity, by arrow keys", async () => {
  const {specials} = workbench.task!,
    mark = specials.find(({kind, tau}) => kind === "center_at_infinity" && tau.length > 0)!.tau[0]!,
    {output_tau} = workbench.map!,
    at = output_tau.findIndex((tau) => tau > mark);
  await pick([cell[0], output_tau[at - 3]!]);
  await focus("region.map");
  let sliders = 0;
  for (let i = 0; i < 6; ++i) {
    await press("ArrowRight");
    await until_settled();
    expect(is_there("region.card")).toBe(true);
    expect(document.body.textContent).not.toMatch(/NaN|undefined|null|Infinity/);
    if (hand().tau[1] !== mark) continue;
    ++sliders;
    expect(hand().output.center).toBeNull();
    expect(text("region.card")).toContain("Slider");
  }
  expect(sliders).toBe(1);
  expect(Math.hypot(...hand().output.center!)).toBeGreaterThan(1000);
});
