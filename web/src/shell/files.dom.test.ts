// Work that leaves the page and comes back: files, the browser's store, links, and files that are none. The numbers of the
// tests are the walk-throughs'.
import {expect, test} from "vitest";
import {
  begin,
  click,
  download,
  drop,
  file_menu,
  get,
  go_to,
  is_there,
  move_a_pose,
  open_files,
  open_settled,
  open_workbench,
  poses_of_page,
  press,
  reload,
  shown,
  text,
  toasts,
  type_into,
  until,
  until_settled,
  until_there,
  workbench,
} from "../../tests/page/support";
import {bad_problems, example, examples, run_program} from "../../tests/program";
import {readFileSync} from "node:fs";
import {join} from "node:path";
import {preferences} from "../state/preferences.svelte";
import {link_of} from "./share";

const bad = (name: string) => readFileSync(join(bad_problems, name));
const all_of_it = () => JSON.stringify(workbench.whole_problem);

test("15 · saved, another task, opened again: all as it was, and the program reads it", async () => {
  await open_settled();
  await click("view.language");
  await move_a_pose();
  await until_settled();
  await click("pin.add");
  const before = shown();
  const {name, bytes} = await download(() => file_menu("file.save"));
  expect(JSON.parse(run_program("solve", bytes.toString(), "-o", "-")).status).toBe("solved");

  await begin("four_positions");
  await until_settled();
  const other = shown();
  expect(other.map).not.toBe(before.map);
  await open_files(name, bytes);
  await until_settled();
  expect(shown()).toEqual(before);
  expect(workbench.file_name).toBe(name);
  expect(document.documentElement.lang).toBe("zh-CN");

  await press("Control+z");
  await until_settled();
  expect(shown()).toEqual(other);
  await press("Control+y");
  await until_settled();
  expect(shown()).toEqual(before);
});

test("15 · work outlives a reload with its steps, and what an example replaced can be had back", async () => {
  await open_settled();
  await move_a_pose();
  await until_settled();
  await click("pin.add");
  workbench.change_pin("A", {name: "lid, 2nd…"});
  const before = shown();
  await reload();
  await until_settled();
  expect(shown()).toEqual(before);
  expect(workbench.pins[0]!.name).toBe("lid, 2nd…");
  for (let i = 0; i < 3; ++i) await press("Control+z"); // name, pin, pose
  expect([workbench.can_undo, workbench.pins.length, poses_of_page()[2]!.x]).toEqual([false, 0, -220]);
  for (let i = 0; i < 3; ++i) await press("Control+y");
  await until_settled();
  expect(shown()).toEqual(before);

  await file_menu("file.examples");
  await click("example.landing_gear");
  expect(text("file.menu")).toContain("Landing gear");
  await until_settled();
  const landing_gear = shown();
  await reload();
  await until_settled();
  expect(shown()).toEqual(landing_gear);
  await file_menu("file.recover");
  await until_settled();
  expect(shown()).toEqual(before);
});

test("15 · work that an earlier version of the page kept is opened", async () => {
  const kept = {version: 1, at: 7, problem: {...example("hood_hinge"), title: "From before"}};
  localStorage.setItem("linkwright.work", JSON.stringify(kept));
  await open_workbench();
  expect(document.title).toMatch(/From before/);
  expect(Object.keys(localStorage)).not.toContain("linkwright.work");
});

test("15 · a file dropped on the page is opened, and a result with its linkages as pins", async () => {
  await open_settled();
  const dropped = readFileSync(join(examples, "dump_bucket.json"), "utf8"),
    result = run_program("solve", dropped, "-o", "-");
  await drop("dump_bucket.json", dropped);
  await until(() => /Dump bucket/.test(document.title));
  expect(toasts()).toContain("“dump_bucket.json” opened.");
  await open_files("result.json", result);
  await until_settled();
  expect(toasts()).toContain("“result.json” is a result");
  expect(document.title).toMatch(/Dump bucket/);
  const {linkages} = JSON.parse(result);
  await until(() => workbench.picked_linkage?.type === linkages[0].type);
  expect(workbench.pins).toHaveLength(linkages.length);
});

test("a dropped table of positions is taken; models and documents are told from tasks", async () => {
  await open_settled();
  await drop("poses.csv", "x;y;theta\n0;0;0\n60;35;22\n160;120;58\n190;240;95\n");
  await until(() => /4 positions of “poses.csv” are taken/.test(toasts()));
  expect(poses_of_page()[3]).toEqual({x: 190, y: 240, theta_deg: 95});
  await click("toast.edit.undo");
  expect(poses_of_page()[3]!.x).not.toBe(190);
  await drop("hinge.step", "ISO-10303-21;\nHEADER;");
  await until(() => /“hinge.step” is a solid model/.test(toasts()));
  await drop("report.pdf", "%PDF-1.7 x");
  await until(() => /“report.pdf” is no problem file/.test(toasts()));
});

test("17 · files that are no problems get their sentences, and nothing changes", async () => {
  await open_settled();
  await move_a_pose();
  await until_settled();
  const before = all_of_it();
  const {files} = JSON.parse(bad("expected.json").toString()) as {
    files: Record<string, [place: string, message: string][]>;
  };
  const names = [
    "cut_short.json",
    "not_a_number.json",
    "three_poses.json",
    "unknown_key.json",
    "empty.json",
    "duplicate_key.json",
    "nested_too_deep.json",
    "missing_angle.json",
    "overflow.json",
    "trailing_comma.json",
  ];
  const said_of = async (name: string, content: string | Buffer) => {
    workbench.toasts = [];
    await open_files(name, content);
    return toasts();
  };
  for (const name of names) {
    const [place, message] = files[name]![0]!,
      said = await said_of(name, bad(name));
    expect(said).toContain(`“${name}” is not a Linkwright problem: ${place}`);
    expect(said).toContain(message);
    expect(said).toContain("Your work is unchanged.");
  }
  expect(await said_of("newer_version.json", bad("newer_version.json"))).toContain(
    "This file was written by a newer Linkwright (version 2; this is 1). Reload the page to get the newest.",
  );
  expect(await said_of("invalid_utf8.json", bad("invalid_utf8.json"))).toContain(
    "“invalid_utf8.json” is not a Linkwright problem: this is not UTF-8 text",
  );
  expect(await said_of("brackets.json", "[".repeat(17 << 20))).toContain(
    "“brackets.json” is larger than 16 MB and was not opened.",
  );
  expect(all_of_it()).toBe(before);
  preferences.language = "zh";
  await until(() => document.documentElement.lang === "zh-CN");
  expect(await said_of("missing_angle.json", bad("missing_angle.json"))).toContain(
    "“missing_angle.json” 不是有效的问题文件：task.poses[2].theta_deg：缺少此项，请补充：数值。当前工作未改变。",
  );
});

test("16 · a broken link opens nothing, and a good one is the task", async () => {
  await open_settled();
  await move_a_pose();
  await until_settled();
  await click("pin.add");
  const before = shown(),
    {hash} = new URL(link_of(workbench.whole_problem, location.href)!);
  workbench.open(example("tailgate"));
  await until_settled();
  const at = hash.length - 40,
    broken = hash.slice(0, at) + (hash[at] === "A" ? "B" : "A") + hash.slice(at + 1);
  const other = shown();
  await go_to(broken);
  await until(() =>
    toasts().includes(
      "This link is damaged and was not opened: some of its characters were lost or changed on the way. Your work is unchanged.",
    ),
  );
  expect(shown()).toEqual(other);
  await go_to(hash);
  await until(() => workbench.pins.length === 1);
  await until_settled();
  expect(shown()).toEqual(before);
  await go_to(`#1.${"A".repeat(70_000)}`);
  await until(() => toasts().includes("This link is longer than 64 kB and was not opened."));
  expect(shown()).toEqual(before);

  // The page may begin with one, too.
  location.hash = broken;
  await reload();
  await until(() => toasts().includes("This link is damaged"));
  await until_settled();
  expect(shown()).toEqual(before);
  workbench.open(example("tailgate"));
  await until_settled();
  location.hash = hash;
  await reload();
  await until(() => workbench.pins.length === 1);
  await until_settled();
  expect(shown()).toEqual(before);
  expect(location.hash).toBe("");
});

test("my tasks: each is kept, opened, renamed, deleted and had back", async () => {
  await open_settled();
  await file_menu("tasks.title");
  await until_there("tasks.none");
  await press("Escape");
  await move_a_pose();
  workbench.edit((problem) => ({...problem, title: "Hatch"}));
  await until_settled();
  const poses = poses_of_page();
  await click("bar.new");
  await click("new.keep");
  await click("new.create");
  await until_settled();
  await file_menu("tasks.title");
  await until_there("tasks.0");
  expect(text("tasks.0")).toContain("Hatch");
  expect(get("tasks.0").querySelectorAll("svg path.link")).toHaveLength(3);
  await click("tasks.rename.0");
  await type_into("tasks.name", "Rear hatch");
  await until(() => text("tasks.0").includes("Rear hatch"));
  await click("tasks.delete.0");
  expect(is_there("tasks.none")).toBe(true);
  await click("tasks.undo");
  await until(() => is_there("tasks.0") && text("tasks.0").includes("Rear hatch"));
  await reload();
  await until_settled();
  await file_menu("tasks.title");
  await click("tasks.open.0");
  expect(document.title).toMatch(/Rear hatch/);
  expect(poses_of_page()).toEqual(poses);
});
