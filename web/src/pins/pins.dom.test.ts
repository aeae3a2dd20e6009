// Pins: kept, named, shown, compared.
import {beforeEach, expect, test} from "vitest";
import {
  click,
  download,
  fill,
  focused,
  get,
  is_there,
  open_settled,
  poses_of_page,
  press,
  text,
  texts,
  type_into,
  until,
  until_settled,
  workbench,
} from "../../tests/page/support";
import {example, solve} from "../../tests/program";
import type {TauPair} from "../contract/messages";

const slim: TauPair = [1.3125, 1.1125];
async function pick(tau: TauPair): Promise<void> {
  workbench.pick(tau);
  await until_settled();
}
async function pin_two(): Promise<ReturnType<typeof solve>> {
  const {linkages} = solve(example("tailgate"));
  await pick([linkages[0].input.coordinate, linkages[0].output.coordinate]);
  await click("pin.add");
  await pick(slim);
  await click("pin.add");
  return {linkages};
}

beforeEach(open_settled);

test("are kept, shown, named and noted, and none takes another's name", async () => {
  const {linkages} = await pin_two();
  expect(text("pin.row.A")).toContain("83.7°");
  expect(text("pin.row.B")).toContain("256");
  await click("pin.eye.A");
  expect(workbench.pins.map((pin) => !!pin.shown)).toEqual([true, false]);
  await click("pin.menu.B");
  await click("pin.rename");
  expect(focused()).toBe("pin.name");
  await type_into("pin.name", "A");
  expect(text("pin.title")).toContain("There is a pin A already.");
  await fill("pin.name", "Slim");
  await type_into("pin.note", "=clears the <b>cable</b>");
  expect(is_there("pin.row.Slim")).toBe(true);
  expect(text("pin.title")).toContain("=clears the <b>cable</b>");
  await click("pin.pick.A");
  expect(workbench.picked!.tau).toEqual([linkages[0].input.coordinate, linkages[0].output.coordinate]);

  await click("pin.menu.Slim");
  await click("pin.delete");
  expect(is_there("pin.row.Slim")).toBe(false);
  await press("Control+z");
  expect(is_there("pin.row.Slim")).toBe(true);
});

test("are compared, sorted by a number, driven by one scrub, and saved as a table", async () => {
  const {linkages} = await pin_two();
  workbench.change_pin("B", {name: "Slim", note: "=clears the <b>cable</b>"});
  await until_settled();
  await click("pin.compare");
  await until(() => document.querySelectorAll("dialog path.link.input").length === 2);
  const dialog = get("pin.compare_dialog");
  expect(dialog.querySelectorAll("[role=img]")).toHaveLength(2);
  expect(dialog.querySelector(".u-over")).not.toBeNull();
  expect(get("pin.value.min_transmission_angle_deg.A").classList).toContain("best");
  expect(text("pin.value.min_transmission_angle_deg.Slim")).toMatch(/73\.5°\s*−10\.1°/);
  const order = () => texts("[data-testid='pin.column'] .name");
  expect(order()).toEqual(["A", "Slim"]);
  await click("pin.sort.ground");
  expect(order()).toEqual(["Slim", "A"]); // 65 mm before 83 mm
  const links = () => [...dialog.querySelectorAll("path.link.input")].map((line) => line.getAttribute("d"));
  const closed = links();
  await fill("pin.scrub", "2.5");
  expect(links().every((line, i) => line !== closed[i])).toBe(true); // one scrub moves both
  const {bytes} = await download(() => click("pin.export_table"));
  const table = bytes
    .toString()
    .split("\r\n")
    .map((line) => line.replace("\ufeff", "").split(","));
  expect(table[0]).toEqual(["Name", "Slim", "A"]);
  const longest = table.find((row) => row[0]!.startsWith("Longest link"))!;
  expect(Number(longest[2]) / linkages[0].lengths.input).toBeCloseTo(1, 9);
  expect(table.at(-2)![1]).toBe("'=clears the <b>cable</b>");
  await press("Escape");
  expect(is_there("pin.compare_dialog")).toBe(false);
});

test("remember the task in which they were pinned", async () => {
  await pick(slim);
  await click("pin.add");
  await type_into("task.x.3", "-219.5");
  expect(text("pin.title")).toContain("From an earlier task");
  await click("pin.bring_back.A");
  await until_settled();
  expect(poses_of_page()).toEqual(example("tailgate").task.poses);
  expect(workbench.hand!.tau).toEqual(slim);
  expect(text("pin.title")).not.toContain("From an earlier task");
});
