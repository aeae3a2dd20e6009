// Points that run straight: examples, the cases and their fields, the search over all of them, links and files.
import {expect, test} from "vitest";
import {
  begin,
  choose,
  click,
  download,
  focus,
  get,
  go_to,
  is_there,
  open_example,
  open_problem,
  open_settled,
  press,
  text,
  type_into,
  until,
  until_mapped,
  until_settled,
  until_there,
  workbench,
} from "../../../tests/page/support";
import {example, solve} from "../../../tests/program";
import {link_of} from "../../shell/share";
import type {StraightLineTask} from "./task";

const task = () => workbench.problem.task as StraightLineTask;
const line = () => workbench.hand!.straight_line!;

test("an example shows its line, its path and numbers that the program has as well", async () => {
  await open_example("straight_watt_suspension");
  for (const name of ["straight.line", "straight.usable", "straight.magnifier"]) expect(is_there(name)).toBe(true);
  expect(text("straight.num.contact")).toBe("5");
  expect(get("plot.profile").getAttribute("aria-selected")).toBe("true");
  const problem = example("straight_watt_suspension"),
    there = solve({...problem, options: {...problem.options, region_samples: 16, at: line().place}}),
    [found] = there.linkages;
  expect(found.usable.length).toBeCloseTo(line().usable.length, 6);
  expect(found.contact_points).toBe(line().contact_points);
  expect(found.stroke.max_deviation).toBeCloseTo(line().stroke!.max_deviation, 9);
  expect(line().cognates[0]!.pivots.input_fixed).toEqual(found.cognates[0].pivots.input_fixed);
  expect(is_there("straight.shown_cognate")).toBe(false);
  await click("straight.cognate.0");
  await until_there("straight.shown_cognate");
  await click("straight.cognate.0");
  expect(is_there("straight.shown_cognate")).toBe(false);
});

test("the map is coloured by what straight lines are worth", async () => {
  await open_example("straight_indicator");
  await click("straight.stroke_over_longest");
  await until_mapped();
  expect(workbench.map!.property).toBe("stroke_over_longest");
  await focus("region.map");
  for (let times = 0; times < 3; ++times) await press("c");
  await until(() => workbench.map!.property === "deviation");
});

test("another case keeps the line and has its own fields, and its layers are shown one at a time", async () => {
  await open_example("straight_indicator");
  const {line: kept} = task();
  await choose("straight.case", "six_point");
  await until_settled();
  expect(task()).toEqual({
    kind: "straight_line",
    mechanism: "four_bar",
    case: "six_point",
    line: kept,
    pole_distance: expect.any(Number),
  });
  await type_into("straight.pole_distance", "80");
  expect(task().pole_distance).toBe(80);
  await until_settled();
  const {rows} = workbench.map!;
  await click("region.sheet.II");
  await until_settled();
  expect(workbench.map!.window.input[0]).toBeCloseTo(1 / 3, 9);
  expect(workbench.map!.rows).not.toBe(rows);
  await choose("straight.case", "pole_at_given_pivot");
  await until_mapped();
  await choose("straight.case", "mixed");
  await until_settled();
  await choose("straight.pattern", "PP-PP");
  expect(task().contacts!.map(({multiplicity}) => multiplicity)).toEqual([2, 2]);
  await until_settled();
  await click("straight.contact.2.side");
  expect(task().contacts![1]!.side).toBe(-1);
});

test("deviation and ranges are asked for, and a link brings them all back", async () => {
  await open_example("straight_watt_suspension");
  const before = line();
  await type_into("straight.deviation", "0.2");
  await until_settled();
  expect(line().deviation).toBe(0.2);
  expect(line().usable.length).toBeLessThan(before.usable.length);
  await type_into("straight.range.input.1", "300");
  await until_settled();
  const {task: typed, options} = workbench.problem;
  expect(options!.window).toEqual([
    [60, 300],
    [-400, -60],
  ]);
  const {hash} = new URL(link_of(workbench.whole_problem, location.href)!);
  await open_problem(example("tailgate"));
  await go_to(hash);
  await until(() => workbench.problem.task.kind === "straight_line");
  await until_settled();
  expect(workbench.problem).toMatchObject({task: typed, options});
});

test("a search over all cases lists linkages, and each opens the map of its case", async () => {
  await open_settled();
  await begin("straight_search");
  await click("straight.start");
  await until_there("straight.ended");
  expect(text("straight.ended")).toContain("found");
  await click(get("region.notice").querySelector("[data-testid='straight.found.2']")!);
  await until_settled();
  expect(line().usable_strip.length).toBeGreaterThan(99.9);
  expect(line().deviation).toBe(0.05);
  expect(task().case).not.toBe("search");
  expect(workbench.hand!.fails).toBe(0);
  await press("Control+z");
  expect(task().case).toBe("search");
  await click("straight.start");
  await click("straight.stop");
  await until_there("straight.start");
});

test("its linkages are taken away as files", async () => {
  await open_example("straight_stage");
  await click("export.title");
  for (const [format, mark] of [
    ["svg", "<svg"],
    ["dxf", "SECTION"],
    ["csv", ","],
    ["json", '"pivots"'],
  ] as const)
    expect((await download(() => click(`export.${format}`))).bytes.toString()).toContain(mark);
});

test("it speaks Chinese", async () => {
  await open_example("straight_walking_leg");
  await click("view.language");
  await until(() => /\p{Script=Han}/u.test(text("straight.about")));
  for (const part of ["straight.numbers", "straight.measuring"])
    expect(text(part).replace(/\b(mm|e)\b|[SδeE]/g, "")).not.toMatch(/[a-z]{3}/i);
});
