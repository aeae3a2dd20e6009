// What tolerances do: the card of the linkage in hand, its bars, samples on the drawing, the front of two objectives.
import {front_study_of} from "./front.svelte";
import {tolerance_study_of} from "./study.svelte";
import {beforeEach, expect, test} from "vitest";
import {
  all,
  click,
  focus,
  focused,
  get,
  is_there,
  open_files,
  open_settled,
  press,
  text,
  type_into,
  until,
  until_settled,
  until_there,
  workbench,
} from "../../../tests/page/support";
import {example} from "../../../tests/program";
import type {Problem} from "../../state/problem";

const tolerances = {length: 0.5, limit: {position: 2}, cost: {exponent: 1}} as const;
/** Of all samples, of the linkage in hand. */
const figures = () => tolerance_study_of(workbench).figures!;
const until_sampled = () => until(() => tolerance_study_of(workbench).figures?.samples === 100_000);
async function open_card(): Promise<void> {
  await click("tolerances.tab");
  await until_there("study.card");
  await until_sampled();
}
const length_of = () => workbench.problem.tolerances?.length as Record<string, number>;

beforeEach(async () => {
  await open_settled();
  await open_files("tailgate.json", JSON.stringify({...example("tailgate"), tolerances} satisfies Problem));
  await until(() => workbench.problem.tolerances?.limit);
  await until_settled();
});

test("the card tells what tolerances do, and nothing of it without them", async () => {
  await open_card();
  expect(text("study.error")).toContain("2.02 mm RMS");
  expect(text("study.yield")).toContain("83 %");
  expect(text("study.sentence")).toMatch(/of 100.000 linkages made keep within 2 mm/);
  expect(get("study.histograms").querySelectorAll("[role=img]")).toHaveLength(4);
  expect(all("study.limit")).toHaveLength(4);
  const inside = (share: string, name: string) => get(share).querySelector(`[data-testid="${name}"]`);
  expect(inside("study.share_output", "study.tighten")).not.toBeNull();
  expect(inside("study.share_coupler", "study.loosen")).not.toBeNull();
  await click("edit.undo");
  expect(is_there("tolerances.tab")).toBe(false);
  expect(is_there("num.title")).toBe(true);
});

test("a bar is moved by keys and keeps the focus, a tolerance is typed, and what is proposed is taken over", async () => {
  await open_card();
  await focus("study.bar_output");
  await press("ArrowLeft");
  expect(length_of().output).toBe(0.455);
  await until_sampled(); // what comes now, in another order, leaves the focus where it is
  expect(focused()).toBe("study.bar_output");
  await type_into("study.tolerance_input", "0.2");
  expect(length_of().input).toBe(0.2);
  await until_sampled();
  await click("study.take_over");
  expect(length_of().coupler).toBeGreaterThan(0.6);
});

test("samples are drawn in each position, enlarged only where it is said", async () => {
  const paths = () => [...get("drawing.samples").querySelectorAll("path")].map((path) => path.getAttribute("d"));
  await until_there("drawing.samples");
  await until(() => paths().length === 128); // of three links and the origin, in four positions, by 25
  expect(get("drawing.samples").querySelector("text")).toBeNull();
  const [true_size] = paths();
  await click("samples.times_100");
  expect(text("drawing.samples")).toContain("Deviations × 100, not true size");
  expect(paths()[0]).not.toBe(true_size);
  await click("samples.show");
  expect(is_there("drawing.samples")).toBe(false);
});

test("the front's sentence leads to a linkage with less error", async () => {
  await click("front.tab");
  await until_there("front.sentence");
  await until(() => /Nothing on the map has less error/.test(text("front.sentence")));
  await until_sampled();
  const before = figures().error;
  await click("front.half_show");
  await until(() => figures()?.error < 0.5 * before + 0.01);

  // From somewhere off the front there is a better one at the same angle.
  const {map} = workbench,
    {value, fails, columns, input_tau, output_tau} = map!,
    least = front_study_of(workbench).found!.points.at(-1)!.angle_deg - 5,
    cell = fails.findIndex((bits, i) => bits === 0 && Math.abs(value[i]! - least) < 0.5);
  expect(cell).toBeGreaterThanOrEqual(0);
  workbench.pick([input_tau[Math.floor(cell / columns)]!, output_tau[cell % columns]!]);
  await until_settled();
  expect(text("front.sentence")).toMatch(/the least error is [\d.]+ mm, now [\d.]+ mm/);
  const {min_transmission_angle_deg: angle, tolerance} = workbench.picked_linkage!;
  await click("front.least_show");
  await until_settled();
  expect(workbench.picked_linkage!.tolerance!.error).toBeLessThan(0.995 * tolerance!.error);
  expect(workbench.picked_linkage!.min_transmission_angle_deg).toBeGreaterThan(angle! - 0.05);
});

test("the plot of the front points at the map by keys, and picks there", async () => {
  await click("front.tab");
  await until(() => front_study_of(workbench).found);
  await focus("front.plot");
  await press("ArrowRight");
  const {tau} = front_study_of(workbench).found!.points.at(-1)!;
  expect(workbench.hovered).toEqual(tau);
  expect(is_there("region.picked_ring")).toBe(true); // beside the crosshair on the other
  await press("Enter");
  await until_settled();
  expect([workbench.picked!.tau, front_study_of(workbench).found!.points.at(-1)!.tau]).toEqual([tau, tau]);
});
