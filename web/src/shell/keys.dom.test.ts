// Keys of the whole page, the status line, and parts that cannot be drawn.
import {beforeEach, expect, test} from "vitest";
import {
  choose_file,
  click,
  download,
  expect_and_forget,
  field,
  file_menu,
  focus,
  get,
  is_there,
  open_problem,
  open_settled,
  press,
  text,
  toasts,
  type_into,
  until,
  until_settled,
  until_there,
  value_of,
  workbench,
} from "../../tests/page/support";
import {example} from "../../tests/program";
import {preferences} from "../state/preferences.svelte";
import type {TextKey} from "../texts/texts.svelte";

const snaps = () => get("status.snap").getAttribute("aria-pressed");
const full = () => document.querySelector(".app")!.className.match(/full_\w+/)?.[0] ?? null;

beforeEach(open_settled);

test("keys reach the whole page, but never a text", async () => {
  await press("f");
  expect(full()).toBe("full_drawing");
  await press("Escape");
  expect(full()).toBeNull();
  await press("m");
  expect(full()).toBe("full_map");
  await click("view.leave_full");
  expect(full()).toBeNull();

  await file_menu("file.rename");
  for (const key of "M f p?") await press(key);
  await type_into("file.title", "M f p?");
  expect(text("file.menu")).toContain("M f p?");
  const {pins, dialog, problem} = workbench;
  expect([full(), pins.length, dialog, problem.title]).toEqual([null, 0, null, "M f p?"]);
  await press("Control+z");
  expect(text("file.menu")).toContain("Tailgate hinge");

  await focus("task.x.3");
  const number = value_of("task.x.3");
  await press("s"); // no number begins with it: the page has it, and nothing lands in the field
  expect([value_of("task.x.3"), snaps()]).toEqual([number, "false"]);
  const {name} = await download(() => press("Control+s"));
  expect(name).toBe("tailgate-hinge.json");
});

test("single keys can be kept to the drawing and the map", async () => {
  await press("?");
  await until_there("dialog.keys");
  expect(text("dialog.keys")).toContain("Play or pause");
  await click("keys.single");
  await press("Escape");
  expect(is_there("dialog.keys")).toBe(false);
  await focus("task.x.3");
  await press("s");
  expect(snaps()).toBe("true");
  await focus("region.map");
  await press("s");
  expect(snaps()).toBe("false");
});

test("a file is chosen by a key only after something was clicked", async () => {
  const activation = (isActive: boolean) =>
    Object.defineProperty(navigator, "userActivation", {configurable: true, value: {isActive}});
  activation(false); // nothing was clicked yet: the browser would not open its chooser
  await press("Control+o");
  expect(toasts()).toContain("A click is needed");
  activation(true);
  await choose_file("bucket.json", JSON.stringify(example("dump_bucket")), () =>
    click(document.querySelector("[data-testid='toast.file.open']")!),
  );
  await until(() => /Dump bucket/.test(document.title));
  Reflect.deleteProperty(navigator, "userActivation");
});

test("the status line tells the place on the map and the branches, and switches snapping", async () => {
  expect(text("status.tau")).toContain("τ₁");
  expect(text("status.branches")).toMatch(/^\d branch(es)?$/);
  await click("status.snap");
  expect(text("status.snap")).toBe("snap off");
  expect(preferences.snap).toBe(false);
});

test("a task without a linkage shows none: no numbers, no verdict, no counts of the one before", async () => {
  const expect_no_linkage = async () => {
    await until(() => workbench.is_current && workbench.task && workbench.task.status !== "solved");
    expect(text("num.none")).toBe("This task has no linkage; the solution region says why.");
    expect(is_there("region.notice")).toBe(true);
    for (const gone of ["num.verified", "num.verdict", "chip.title", "region.ring", "status.tau"])
      expect(is_there(gone), gone).toBe(false);
    expect(field("drive.play").disabled).toBe(true);
  };
  const five = [
    [0, 0, 0],
    [100, 0, 40],
    [20, 90, -30],
    [-140, 50, 100],
    [60, -130, 10],
  ].map(([x, y, theta_deg]) => ({x: x!, y: y!, theta_deg: theta_deg!}));
  expect(is_there("num.verified")).toBe(true);
  const {task} = workbench.problem;
  workbench.open({linkwright: 1, title: "Five", length_unit: "mm", task: {...task, poses: five} as typeof task});
  await expect_no_linkage();
  await click("edit.undo");
  await until_settled();
  expect(is_there("num.verified")).toBe(true);

  const three = example("footrest");
  await open_problem({...three, task: {...three.task, given: {side_length: 60}}});
  expect(is_there("num.verdict")).toBe(true);
  await type_into("given.length_input", "5");
  await expect_no_linkage();
  expect(text("region.notice")).toContain("No input link of length 5 satisfies the positions");
  await click("edit.undo");
  await until_settled();
  expect(is_there("num.verdict")).toBe(true);
});

test("a part that cannot be drawn says so, with ways on; the others go on", async () => {
  workbench.edit((problem) => ({...problem, title: "Before the mistake"}));
  await until_settled();
  const part: TextKey = "num.title",
    failed = `failed.${part}`,
    within = (name: string) => get(failed).querySelector(`[data-testid="${name}"]`)!;
  workbench.answers.take_hand(
    {...workbench.hand!, lengths: {} as never, dead_points_deg: null as never},
    workbench.problem,
  );
  await until_there(failed);
  expect(text(failed)).toContain("“Numbers” could not be drawn");
  expect(is_there("num.verdict")).toBe(false);
  expect(is_there("task.x.1")).toBe(true);
  await click(within("failed.again"));
  expect(is_there(failed)).toBe(true); // it is as it was
  await click(within("failed.undo"));
  await until_settled();
  expect(is_there("num.verified")).toBe(true);
  expect(is_there(failed)).toBe(false);
  expect_and_forget(/TypeError/);
});
