// Loads: the row that gives them, their card, and what can be taken hold of on the drawing.
import {beforeEach, expect, test} from "vitest";
import {
  all,
  choose,
  click,
  field,
  fill,
  get,
  is_there,
  open_files,
  open_settled,
  press,
  reload,
  text,
  type_into,
  until,
  until_settled,
  until_there,
  value_of,
  workbench,
} from "../../../tests/page/support";
import {example} from "../../../tests/program";
import {preferences} from "../../state/preferences.svelte";
import type {Problem} from "../../state/problem";
import {poses_of, type Task} from "../../state/task";
import type {LinearSpring} from "./block";
import {struts} from "./example";
import {load_study_of} from "./study.svelte";

const given = () => workbench.problem.loads ?? null;
/** Nothing is asked of the loads: to find the best by them takes the engine long. */
const with_struts = (): Problem => ({...example("tailgate"), loads: struts});
async function open_struts(): Promise<void> {
  await open_files("struts.json", JSON.stringify(with_struts()));
  await until(() => given()?.springs);
  await until_settled();
}
/** The fields of the loads with which a task begins; with two positions no linkage is looked for. */
async function open_fields(): Promise<void> {
  const {task} = workbench.problem,
    few = {...task, poses: poses_of(task).slice(0, 2)} as Task;
  workbench.edit((problem) => ({...problem, task: few}));
  await click("loads.add");
  await click("loads.each");
}
async function open_card(): Promise<void> {
  await click("loads.tab");
  await until_there("loads.read_outs");
}
const studied = () => load_study_of(workbench);

beforeEach(open_settled);

test("are given in a row, colour the map, and stay", async () => {
  expect(is_there("req.row.max_open_force")).toBe(false);
  await click("loads.add");
  expect(given()).toMatchObject({body: {mass: 20}, cases: [{name: "room"}]});
  await until_there("req.row.max_pin_force");
  await click("loads.each");
  await type_into("loads.mass", "30");
  await type_into("loads.center_x", "12");
  await type_into("loads.links", "1.5");
  expect(given()).toMatchObject({body: {mass: 30, center: [12, 135]}, links: {coupler: {kg_per_m: 1.5}}});
  await press("Control+z");
  expect(given()).not.toHaveProperty("links");

  await click("region.menu");
  await click("region.color.hand_force");
  await until(() => workbench.map?.property === "hand_force");
  await until_settled();
  await type_into("req.max_open_force", "200");
  expect(workbench.problem.requirements).toMatchObject({max_open_force: 200});
  await until(() => is_there("req.left.max_open_force") || is_there("req.relax.max_open_force"));

  const {loads} = workbench.problem;
  await reload();
  expect(given()).toEqual(loads);
  await click("loads.remove");
  expect(given()).toBeNull();
  expect(workbench.problem.requirements).not.toHaveProperty("max_open_force");
  expect(workbench.coloring).toBe("type");
});

test("springs and cases are added, typed and taken away", async () => {
  await open_fields();
  await click("loads.add_gas_spring");
  await type_into("loads.spring_1_F1", "220");
  await type_into("loads.spring_1_count", "2");
  expect(given()!.springs![0]).toMatchObject({kind: "gas", F1: 220, count: 2});
  const from = () => (given()!.springs![0] as LinearSpring).from,
    [x, y] = from().at;
  await type_into("loads.spring_1_from_x", String(x + 1));
  expect(from()).toEqual({on: "ground", at: [x + 1, y]});
  await click("loads.add_case");
  expect(given()!.cases!.at(-1)).toEqual({name: "cold", temperature_C: -30});
  await type_into("loads.temperature", "-20");
  await type_into("loads.slope", "5");
  await type_into("loads.percent", "90");
  await type_into("loads.case_name", "winter");
  expect(given()!.cases!.at(-1)).toEqual({name: "winter", temperature_C: -20, slope_deg: 5, spring_percent: 90});
  await click("loads.remove_case");
  await click("loads.spring_1_remove");
  expect(given()).not.toHaveProperty("springs");
  expect(given()!.cases).toEqual([{name: "room"}]);
  await choose("loads.direction", "fixed");
  await type_into("loads.fixed_deg", "80");
  expect(given()!.handle!.direction).toEqual({fixed_deg: 80});
});

test("coils, torsion springs, a cylinder and what is rarely given are typed", async () => {
  await open_fields();
  await click("loads.add_coil_spring");
  await choose("loads.spring_1_acts", "tension");
  const [x, y] = (given()!.springs![0] as LinearSpring).from.at;
  await choose("loads.spring_1_from_on", "body");
  await choose("loads.spring_1_from_on", "ground"); // where it was
  expect(given()!.springs![0]).toMatchObject({kind: "coil", acts: "tension", from: {on: "ground", at: [x, y]}});
  await click("loads.add_torsion_spring");
  await choose("loads.spring_2_joint", "output_ground");
  await type_into("loads.spring_2_rate_per_deg", "0.2");
  await type_into("loads.spring_2_torque_at_position_1", "-3");
  expect(given()!.springs![1]).toMatchObject({
    kind: "torsion",
    joint: "output_ground",
    rate_per_deg: 0.2,
    torque_at_position_1: -3,
  });

  await click("loads.rare_fold");
  await type_into("loads.gravity_direction", "-80");
  await type_into("loads.pin_radius", "6");
  await type_into("loads.pin_friction", "0.15");
  await type_into("loads.body_inertia", "1.5");
  await type_into("loads.rpm", "30");
  expect(given()).toMatchObject({
    gravity: {direction_deg: -80},
    pins: {radius: 6, friction: 0.15},
    body: {inertia: 1.5},
    rpm: 30,
  });
  await choose("loads.law", "trapezoid");
  await type_into("loads.law_duration", "2.5");
  await type_into("loads.law_ramp", "0.2");
  expect(given()!.motion).toEqual({law: "trapezoid", duration_s: 2.5, ramp: 0.2});
  expect(given()).not.toHaveProperty("rpm");
  await choose("loads.law", "cycloid");
  expect(given()!.motion).toEqual({law: "cycloid", duration_s: 2.5});
  await choose("loads.law", "none");
  expect(given()).not.toHaveProperty("motion");
  await type_into("loads.pin_friction", "5");
  expect(text("loads.row")).toContain("between 0 and 2");
  await press("Escape");
  await choose("loads.gravity", "no_gravity");
  expect(given()!.gravity).toBeNull();

  await click("loads.links_fold");
  await choose("loads.link_output", "mass");
  await type_into("loads.link_output_mass", "0.5");
  await type_into("loads.link_output_center_x", "60");
  await type_into("loads.link_output_inertia", "0.01");
  await choose("loads.link_input", "kg_per_m");
  expect(given()!.links).toEqual({output: {mass: 0.5, center: [60, 0], inertia: 0.01}, input: {kg_per_m: 1}});
  await choose("loads.link_input", "nothing");
  await choose("loads.drive", "cylinder");
  await type_into("loads.cylinder_to_x", "11");
  expect(given()!.drive).toMatchObject({cylinder: {from: {on: "ground"}, to: {on: "body", at: [11, 135]}}});
});

test("further loads act in the cases that name them, and cases count for what they are told", async () => {
  await open_fields();
  await click("loads.extra_fold");
  await click("loads.add_mass");
  await type_into("loads.extra_1_mass", "3");
  await type_into("loads.extra_1_y", "200");
  await fill("loads.extra_1_name", "snow");
  await click("loads.add_force");
  await type_into("loads.extra_2_force_x", "5");
  await choose("loads.extra_2_frame", "body");
  await choose("loads.extra_2_on", "input");
  await choose("loads.extra_1_when", "in_cases");
  await click("loads.acts_1");
  await click("loads.more_of_case");
  await type_into("loads.exponent", "1.2");
  await click("loads.counts_hump");
  expect(given()!.extra).toEqual([
    {name: "snow", on: "body", at: [50, 200], mass: 3},
    {name: "Force", on: "input", at: [50, 135], force: [5, -10], frame: "body", always: true},
  ]);
  expect(given()!.cases).toMatchObject([{name: "room", extra: ["snow"], gas_exponent: 1.2}]);
  expect(given()!.cases![0]!.for).toHaveLength(11);
  await click("loads.counts_hump");
  expect(given()!.cases![0]).not.toHaveProperty("for");
  await click("loads.extra_1_remove");
  expect(given()!.cases).toEqual([{name: "room", gas_exponent: 1.2}]);
});

test("what the engine does not take is said in the row", async () => {
  await click("loads.add");
  await click("loads.each");
  await choose("loads.drive", "cylinder");
  await choose("loads.cylinder_to_on", "ground");
  await until(() => text("loads.row").includes("both ends are on one body"));
});

test("of a file are kept as they are", async () => {
  await open_struts();
  expect(given()).toMatchObject(struts);
  const {loads} = workbench.problem;
  await reload();
  expect(given()).toEqual(loads);
  await click("loads.each");
  expect(value_of("loads.spring_1_F3")).toBe("425");
  expect(field("loads.links").placeholder).toBe("differ");
});

test("the card tells what the hand feels, case by case, and where a requirement is missed", async () => {
  await open_struts();
  await open_card();
  await until(() => studied().is_of_hand);
  const [room, cold] = studied().found!.loads.cases;
  expect(text("loads.max_open_force_1")).toContain("N");
  expect(room!.max_open_force!).toBeLessThan(cold!.max_open_force!);
  expect(get("loads.plot").getAttribute("aria-label")).toContain("room");
  await click("loads.choose_2");
  expect(get("loads.plot").getAttribute("aria-label")).toContain("cold");
  expect(all("loads.stroke_left_1_1")).toHaveLength(1);
  expect(text("loads.max_pin_force_1")).toMatch(/N, (input|output), (fixed|moving)/);

  workbench.edit((problem) => ({...problem, requirements: {...problem.requirements, min_hold_open: 500}}));
  await until(() => /needs ≥ 500 N: \d+ N short/.test(text("loads.hold_open_2")));
  expect(get("loads.hold_open_2").className).toContain("missed");
});

test("the plot shows the hand or the pins over what is chosen, with springs below; the drawing and the printed sheet have them too", async () => {
  await open_struts();
  await open_card();
  await until(() => studied().is_of_hand);
  expect(text("loads.worst_hold_open")).toBe("worst: cold");
  expect(text("loads.now")).toMatch(/^At .*° ?: opens with −?[\d.]+ N, closes with −?[\d.]+ N$/);
  expect(get("loads.strip_1").getAttribute("aria-label")).toMatch(/^strut: .* its stroke allows 197 to 325 mm$/);
  await choose("loads.over", "path");
  await choose("loads.shown", "pin");
  expect(text("loads.now")).toMatch(/^At [\d.]+ %: [\d.]+ N$/);
  expect(get("loads.plot").getAttribute("aria-label")).toBe("Pin force over the travel");
  expect(all("drawing.force_weight")).toHaveLength(1);
  expect(all("drawing.force_hand")).toHaveLength(1);
  preferences.forces = false;
  await until(() => !is_there("drawing.force_hand"));
  expect(all("print.loads")).toHaveLength(1);
  expect(text("print.loads")).toContain("Holds open");
  expect(is_there("print.effort")).toBe(true);
});

test("the card says where there is nothing to tell", async () => {
  await open_struts();
  await open_card();
  const {map} = workbench,
    cell = map!.defects.findIndex((bits, i) => bits !== 0 && map!.type[i]! < 9);
  workbench.hover([map!.input_tau[Math.floor(cell / map!.columns)]!, map!.output_tau[cell % map!.columns]!]);
  await until_there("loads.none");
  workbench.hover(null);
  await until_there("loads.read_outs");
});

test("studs, centre and handle are taken hold of on the drawing", async () => {
  await open_struts();
  await until_there("drawing.load_spring_1_from");
  expect(is_there("drawing.spring_1")).toBe(true);
  const opened = given(),
    line = () => get("drawing.spring_1").getAttribute("d");
  const before = line();
  get("drawing.load_spring_1_from").focus();
  await press("ArrowRight");
  expect(given()!.springs![0]).not.toEqual(struts.springs![0]);
  expect(line()).not.toBe(before);
  await click("edit.undo");
  expect(given()).toEqual(opened);
  get("drawing.load_center").focus();
  await press("ArrowUp");
  expect(given()!.body!.center![1]).toBeGreaterThan(120);
  const [x0] = [get("drawing.load_handle").getAttribute("cx")];
  workbench.set_angle(20);
  await until(() => get("drawing.load_handle").getAttribute("cx") !== x0);
});
