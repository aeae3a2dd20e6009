// Tolerances: the row that gives them, and what they open.
import {beforeEach, expect, test} from "vitest";
import {
  click,
  field,
  is_there,
  open_settled,
  press,
  reload,
  text,
  type_into,
  until,
  until_settled,
  until_there,
  workbench,
} from "../../tests/page/support";
import {example, solve} from "../../tests/program";
const given = () => workbench.problem.tolerances ?? null;
const until_sampled = () =>
  until(() => workbench.answers.yields && workbench.answers.yields.done === workbench.answers.yields.total);
async function colour_by(name: string): Promise<void> {
  await click("region.menu");
  await click(`region.color.${name}`);
}

beforeEach(open_settled);

test("are given in a row, colour the map, and stay", async () => {
  expect(is_there("req.row.max_tolerance_error")).toBe(false);
  await click("tolerance.add");
  expect(given()).toEqual({length: 0.5});
  await type_into("tolerance.all", "0.4");
  await click("tolerance.each");
  await type_into("tolerance.coupler", "0.1");
  expect(given()).toEqual({length: {input: 0.4, coupler: 0.1, output: 0.4, ground_pivots: 0.4, point: 0.4}});
  expect(field("tolerance.all").placeholder).toBe("differ");
  await press("Control+z");
  expect(given()).toEqual({length: 0.4});

  await click("region.menu");
  expect(is_there("region.color.yield")).toBe(false);
  await click("region.color.tolerance_error");
  await until(() => workbench.map?.property === "tolerance_error");
  await until_settled();
  const [first] = solve({...example("tailgate"), tolerances: {length: 0.4}}).linkages;
  expect(workbench.hand!.tolerance!.error).toBeCloseTo(first.tolerance.error, 6);

  await reload();
  expect(given()).toEqual({length: 0.4});
  await click("tolerance.remove");
  expect(given()).toBeNull();
  expect(workbench.coloring).toBe("type");
});

test("with a limit show yields, and a required yield leaves fewer and goes with the limit", async () => {
  await click("tolerance.add");
  await click("tolerance.set_limit");
  expect(given()).toEqual({length: 0.5, limit: {position: 2}});
  await colour_by("yield");
  await until_there("tolerance.sampling");
  expect(text("tolerance.sampling")).toContain("Sampling yields: ");
  await until_sampled();
  expect(is_there("tolerance.sampling")).toBe(false);
  const {map, census, answers} = workbench,
    known = [...map!.value].filter((_, cell) => map!.fails[cell] === 0),
    meeting = census!.meeting;
  expect(answers.yields!.total).toBe(meeting);
  expect(known.reduce((a, b) => Math.min(a, b))).toBeLessThan(0.5);
  expect(known.reduce((a, b) => Math.max(a, b))).toBeGreaterThan(0.99);

  await type_into("req.min_yield", "90");
  await until_settled();
  await until_sampled();
  expect(workbench.problem.requirements!.min_yield).toBe(0.9);
  expect(workbench.census!.meeting).toBeGreaterThan(0);
  expect(workbench.census!.meeting).toBeLessThan(meeting);
  await click("tolerance.each");
  await type_into("tolerance.limit", "");
  await until_settled();
  expect(workbench.problem.requirements).not.toHaveProperty("min_yield");
  expect(workbench.census!.meeting).toBe(meeting);
});
