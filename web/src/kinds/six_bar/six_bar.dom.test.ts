// Six-bars: found on their map, driven, taken away, searched for.
import {beforeEach, expect, test} from "vitest";
import {
  click,
  download,
  get,
  is_there,
  open_example,
  played_poses,
  press,
  text,
  type_into,
  until,
  until_settled,
  until_there,
  workbench,
} from "../../../tests/page/support";
import {analyze} from "../../../tests/program";
import type {TauPair} from "../../contract/messages";
import type {SixBarTask} from "./task";

const pivot_b = () => (workbench.problem.task as SixBarTask).chain!.b;

beforeEach(() => open_example("wheel_loader"));

test("a six-bar is picked on its map, told by names, and driven through all positions in order", async () => {
  expect(text("chip.title")).toContain("six-bars");
  expect(workbench.census!.meeting).toBeGreaterThan(20);
  expect(workbench.task!.symmetric).toBe(false);
  const {map} = workbench,
    passing = [...map!.fails.keys()].filter((i) => map!.fails[i] === 0),
    cell = passing[Math.floor(passing.length / 2)]!;
  workbench.pick([map!.input_tau[Math.floor(cell / map!.columns)]!, map!.output_tau[cell % map!.columns]!] as TauPair);
  await until_settled();
  const {fails, six_bar} = workbench.hand!;
  expect([fails, six_bar!.topology, six_bar!.lengths.length]).toEqual([0, "watt_1", 10]);
  expect(text("num.type")).toBe("Watt I");
  expect(is_there("num.verified")).toBe(true);
  expect(get("drawing.linkage").dataset.fails).toBe("false");
  expect(text("num.title")).toMatch(/floating link b–d.*c₄ · \w/s);
  expect(text("drawing.joint_c4")).toContain("c₄");
  expect(text("drawing.linkage")).toContain("guided body");

  await click(document.querySelector("[data-speed='4']")!);
  await click("drive.repeat"); // over and over
  await click("drive.repeat"); // once
  workbench.stage = 0;
  expect(await played_poses()).toEqual([1, 2, 3]); // from the first on
});

test("it is taken away, as the program reads it", async () => {
  await click("export.title");
  const taken = async (format: string) => (await download(() => click(`export.${format}`))).bytes.toString();
  expect(await taken("dxf")).toContain("BODY_5");
  expect(analyze(JSON.parse(await taken("json"))).mechanism).toBe("six_bar");
  expect(JSON.parse(await taken("result")).linkages[0].verified_by_driving).toBe(true);
  for (const format of ["svg", "csv"]) expect((await taken(format)).length).toBeGreaterThan(500);
});

test("other bodies joined make another map", async () => {
  await click("six_bar.topology");
  expect(document.querySelectorAll("[data-testid^='six_bar.row.']")).toHaveLength(11);
  await click("six_bar.row.0-3_0-2");
  await until_settled();
  expect(text("six_bar.topology")).toContain("Stephenson III");
  await press("Control+z");
  await until_settled();
  expect(text("six_bar.topology")).toContain("Watt I");
});

test("a chain is searched for; stopped, what was found stays; choosing one is one step", async () => {
  const {box} = workbench.problem.options!,
    before = pivot_b();
  workbench.edit((problem) => ({...problem, options: {...problem.options, box: undefined}}));
  await until_settled();
  await click("six_bar.search_chain");
  await until_there("drawing.search_box");
  expect([workbench.is_current, workbench.problem.options?.box]).toEqual([true, undefined]); // the panel shows one of its own
  await press("Control+z");
  expect(workbench.search_box).toEqual(box);
  await type_into("six_bar.seed", "4");
  await type_into("six_bar.effort", "100000");
  await click("six_bar.start");
  await until_there("six_bar.found.1");
  await click("six_bar.stop");
  await until(() => text("six_bar.ended").includes("Stopped after"));
  await click("six_bar.found.1");
  await until_settled();
  expect(workbench.hand!.fails).toBe(0);
  expect(workbench.hand!.drive!.ticks.every((tick) => tick.reached)).toBe(true);
  await press("Control+z");
  await until_settled();
  expect(pivot_b()).toEqual(before);
});

test("a part of the map is looked at closely, and told by its tolerances", async () => {
  const span = () => workbench.map!.input_tau.at(-1)! - workbench.map!.input_tau[0]!,
    whole_span = span(),
    whole_samples = workbench.map!.samples;
  workbench.zoom({input: [0.25, 0.5], output: [0.5, 0.75]});
  await until(() => span() < whole_span / 3);
  await until_settled();
  expect(workbench.map!.samples / span()).toBeGreaterThan(whole_samples / whole_span);
  expect(text("region.zoomed")).toBe("×4");
  await click("region.zoomed");
  await until_settled();

  await click("tolerance.add");
  await click("region.menu");
  await click("region.color.tolerance_error");
  await until(() => workbench.map?.property === "tolerance_error");
  await until_settled();
  expect(workbench.hand!.tolerance!.error).toBeGreaterThan(0.1);
});
