// A task of one's own: begun, begun anew as another kind, and what it then has.
import {beforeEach, expect, test} from "vitest";
import {
  begin,
  click,
  field,
  focus,
  focused,
  get,
  is_there,
  open_settled,
  paste_into,
  poses_of_page,
  press,
  text,
  until,
  until_mapped,
  until_settled,
  until_there,
  workbench,
} from "../../tests/page/support";
import type {MotionTask} from "../kinds/motion/task";

const hatch = "0\t0\t0\n60\t35\t22\n160\t120\t58\n190\t240\t95";
async function new_dialog(opener: string): Promise<void> {
  await click(opener);
  await until_there("dialog.new");
}

beforeEach(open_settled);

test("another kind keeps the positions, and a new task keeps the user's own where he wants it", async () => {
  await paste_into("task.x.1", hatch);
  await until_mapped();
  const poses = poses_of_page();
  await new_dialog("task.kind");
  expect(field("new.four_positions").checked).toBe(true);
  expect(field("new.keep").checked).toBe(true);
  await click("new.six_bar");
  await click("new.create");
  expect((workbench.problem.task as MotionTask).mechanism).toBe("six_bar");
  expect(poses_of_page()).toEqual(poses);
  await until(() => is_there("task.missing") || is_there("region.notice"));

  await new_dialog("bar.new");
  await click("new.five_positions");
  expect(field("new.keep").checked).toBe(true); // they are his own
  expect(text("dialog.new")).toContain("Keep the 4 positions of this task. 1 more is added.");
  await click("new.keep");
  await click("new.create");
  expect(poses_of_page()[1]).not.toEqual(poses[1]);
  await new_dialog("bar.new");
  expect(field("new.keep").checked).toBe(false); // they are the beginning's
});

test("the dialog begins at its first card, which is checked", async () => {
  await new_dialog("bar.new");
  expect(field("new.four_positions").checked).toBe(true);
  expect(focused()).toBe("new.four_positions");
  await press("Escape");
  expect(is_there("dialog.new")).toBe(false);
});

test("five positions begin with linkages that meet what is required", async () => {
  await begin("five_positions");
  await until_settled();
  expect(workbench.census!.meeting).toBeGreaterThan(0);
  expect(is_there("region.notice")).toBe(false);
  expect(document.body.textContent!.match(/Relax one position/g)).toHaveLength(1);
});

test("Tab goes from number to number in the table of pairs, whose rows have their menu by a key", async () => {
  await begin("function");
  await until_there("function.input_deg.1");
  await focus("function.input_deg.1");
  for (const next of ["output_deg.1", "input_deg.2", "output_deg.2"]) {
    await press("Tab");
    expect(focused()).toBe(`function.${next}`);
  }
  const pairs = () => (workbench.problem.task as unknown as {pairs: object[]}).pairs.length,
    before = pairs();
  await press("Shift+F10");
  await click("function.menu.remove");
  expect(pairs()).toBe(before - 1);
});

test("where nothing is left, the page shows where the task could go, and goes there", async () => {
  await begin("four_positions"); // no boxes for pivots
  await until_settled();
  await paste_into("task.x.1", hatch);
  await until_mapped();
  expect(workbench.census!.meeting).toBe(0);
  await until_there("region.way_out");
  expect(text("region.way_out")).toMatch(/^Move position \d by [\d.]+ mm$/);
  await until_there("drawing.halo");
  expect(get("drawing.halo").dataset.squares).toMatch(/[1-9]/);
  const {pose, by, meeting} = workbench.way_out.found!,
    before = poses_of_page()[pose]!;
  await click("region.way_out");
  await until_mapped();
  const after = poses_of_page()[pose]!;
  expect([after.x - before.x, after.y - before.y]).toEqual([expect.closeTo(by[0], 9), expect.closeTo(by[1], 9)]);
  expect(workbench.census!.meeting).toBe(meeting); // what was said
  expect(is_there("region.notice")).toBe(false);
  expect(is_there("drawing.halo")).toBe(false);
  await until(() => workbench.hand?.fails === 0); // the best of what is left now
});

test("no linkage is ever drawn as one of another kind", async () => {
  for (const id of ["five_positions", "six_bar", "five_positions", "six_bar", "function"]) {
    await begin(id);
    await until_settled();
    expect(get("drawing.canvas").outerHTML).not.toMatch(/NaN|Infinity|undefined/);
  }
});

test("a sphere without WebGL says so in full, and leaves no labels behind", async () => {
  await begin("four_orientations");
  await until_there("spherical.view.no_webgl");
  expect(text("spherical.view.no_webgl")).toContain("WebGL is off");
  expect(document.querySelector("[data-label]")).toBeNull();
});
