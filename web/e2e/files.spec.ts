// Work that leaves the page and comes back: files, the browser's store, links, and files that are none. The numbers of the
// tests are the walk-throughs'.
import type {BrowserContext, Page} from "@playwright/test";
import {closeSync, openSync, readFileSync, writeSync} from "node:fs";
import {join} from "node:path";
import {
  bad_problems,
  example,
  examples,
  expect,
  file_menu,
  move_a_pose,
  open_files,
  open_workbench,
  read_state,
  run_program,
  shown,
  test,
  toasts,
  until_ready,
} from "./support";
import type {MotionTask} from "../src/tasks/motion/task";

// ---- 15 ---------------------------------------------------------------------------------------------------------

test("15 · saved, another task, opened again: all as it was, and the program reads it", async ({page}, info) => {
  await open_workbench(page);
  await page.getByTestId("view.language").click();
  await move_a_pose(page);
  await shown(page);
  await read_state(page, (workbench) => workbench.pin());
  const before = await shown(page);
  const [download] = await Promise.all([page.waitForEvent("download"), file_menu(page, "file.save")]);
  const path = info.outputPath(download.suggestedFilename());
  await download.saveAs(path);
  const text = readFileSync(path, "utf8");
  expect(JSON.parse(run_program("solve", text, "-o", "-")).status).toBe("solved");

  await file_menu(page, "file.new");
  await page.getByTestId("new.create").click();
  const other = await shown(page);
  expect(other.map).not.toBe(before.map);
  await open_files(page, path);
  await expect.poll(() => shown(page)).toEqual(before);
  expect(await read_state(page, (workbench) => workbench.file_name)).toBe(download.suggestedFilename());
  await expect(page.locator("html")).toHaveAttribute("lang", "zh-CN");

  await page.keyboard.press("Control+z");
  await expect.poll(() => shown(page)).toEqual(other);
  await page.keyboard.press("Control+y");
  await expect.poll(() => shown(page)).toEqual(before);
});

test("15 · work outlives a reload, and what an example replaced can be had back", async ({page}) => {
  await open_workbench(page);
  await move_a_pose(page);
  await shown(page);
  await read_state(page, (workbench) => workbench.pin());
  await read_state(page, (workbench) => workbench.change_pin("A", {name: "lid, 2nd…"}));
  const before = await shown(page);
  await page.evaluate(() =>
    localStorage.setItem("linkwright.preferences", '{"language": "fr", "toured": true, "colour_by": 7}'),
  ); // blanks nothing
  await page.reload();
  await until_ready(page);
  expect(await shown(page)).toEqual(before);
  expect(await read_state(page, (workbench) => workbench.pins[0]!.name)).toBe("lid, 2nd…");
  for (let i = 0; i < 3; ++i) await page.keyboard.press("Control+z"); // name, pin, pose
  expect(
    await read_state(page, ({can_undo, pins, problem}) => [
      can_undo,
      pins.length,
      (problem.task as MotionTask).poses[2]!.x,
    ]),
  ).toEqual([false, 0, -220]);
  for (let i = 0; i < 3; ++i) await page.keyboard.press("Control+y");
  await expect.poll(() => shown(page)).toEqual(before);

  await file_menu(page, "file.examples");
  await page.getByTestId("example.landing_gear").click();
  await expect(page.getByTestId("file.menu")).toContainText("Landing gear");
  const landing_gear = await shown(page);
  await page.reload();
  await until_ready(page);
  expect(await shown(page)).toEqual(landing_gear);
  await file_menu(page, "file.recover");
  await expect.poll(() => shown(page)).toEqual(before);
});

test("15 · work that an earlier version of the page kept is opened, and so is what was done just before the page went", async ({
  page,
}) => {
  const kept = {version: 1, at: 7, problem: {...example("hood_hinge"), title: "From before"}};
  await page.addInitScript((text) => {
    if (!sessionStorage.getItem("once")) localStorage.setItem("linkwright.work", text);
    sessionStorage.setItem("once", "yes");
  }, JSON.stringify(kept));
  await open_workbench(page);
  await expect(page).toHaveTitle(/From before/);
  expect(await page.evaluate(() => Object.keys(localStorage))).not.toContain("linkwright.work");
  await read_state(page, (workbench) => {
    workbench.edit((problem) => ({...problem, title: "At the last moment"}));
    location.reload();
  });
  await expect(page).toHaveTitle(/At the last moment/);
});

test("15 · two tabs keep their work apart", async ({page, context}) => {
  await open_workbench(page);
  await move_a_pose(page);
  await shown(page);
  const other = await context.newPage();
  await open_workbench(other);
  await read_state(other, (workbench) => workbench.edit((problem) => ({...problem, title: "The other tab"})));
  await expect(toasts(page)).toContainText("This work is also open in another tab.");
  await read_state(page, (workbench) => workbench.edit((problem) => ({...problem, title: "This tab"})));
  await page.reload();
  await expect(page).toHaveTitle(/This tab/);
  await other.reload();
  await expect(other).toHaveTitle(/The other tab/);
  await file_menu(other, "tasks.title");
  await other.getByTestId("tasks.tab.0").click();
  await expect(other).toHaveTitle(/This tab/);
});

test("15 · a file dropped on the page is opened", async ({page}) => {
  await open_workbench(page);
  const text = readFileSync(join(examples, "dump_bucket.json"), "utf8");
  const result = run_program("solve", text, "-o", "-");
  await page.evaluate((content) => {
    const data = new DataTransfer();
    data.items.add(new File([content], "dump_bucket.json", {type: "application/json"}));
    for (const type of ["dragover", "drop"])
      document
        .querySelector("aside")!
        .dispatchEvent(new DragEvent(type, {dataTransfer: data, bubbles: true, cancelable: true}));
  }, text);
  await expect(page).toHaveTitle(/Dump bucket/);
  await expect(toasts(page)).toContainText("“dump_bucket.json” opened.");
  const [chooser] = await Promise.all([page.waitForEvent("filechooser"), file_menu(page, "file.open")]);
  await chooser.setFiles({name: "result.json", mimeType: "application/json", buffer: Buffer.from(result)});
  await expect(toasts(page)).toContainText("“result.json” is a result");
  await expect(page).toHaveTitle(/Dump bucket/);
  const best = JSON.parse(result).linkages[0];
  await expect
    .poll(() => read_state(page, ({picked_linkage, pins}) => [picked_linkage?.type, pins.length]))
    .toEqual([best.type, JSON.parse(result).linkages.length]);
});

// ---- 16 ---------------------------------------------------------------------------------------------------------

async function copied_link(page: Page, context: BrowserContext): Promise<string> {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.getByTestId("share.link").click();
  await expect(toasts(page)).toContainText(/Link copied \(\d.*characters\)/);
  return page.evaluate(() => navigator.clipboard.readText());
}

test("16 · a link is the task, and a broken one opens nothing", async ({page, context, browser}) => {
  await open_workbench(page);
  await move_a_pose(page);
  await shown(page);
  await read_state(page, (workbench) => workbench.pin());
  const before = await shown(page);
  const link = await copied_link(page, context);
  expect(link.length).toBeLessThan(4000);

  const elsewhere = await browser.newContext({locale: "en-GB"});
  const other = await elsewhere.newPage();
  await open_workbench(other, link);
  await expect.poll(() => shown(other)).toEqual(before);
  expect(new URL(other.url()).hash).toBe(""); // from now on it is work like any other
  await other.reload();
  await until_ready(other);
  expect(await shown(other)).toEqual(before);
  await elsewhere.close();

  const at = link.length - 40,
    broken = link.slice(0, at) + (link[at] === "A" ? "B" : "A") + link.slice(at + 1);
  const again = await browser.newContext({locale: "en-GB"});
  const third = await again.newPage();
  await open_workbench(third, broken);
  await expect(toasts(third)).toContainText(
    "This link is damaged and was not opened: some of its characters were lost or changed on the way. Your work is unchanged.",
  );
  await expect(third).toHaveTitle(/Tailgate hinge/);
  expect((await shown(third)).poses).toBe("[[0,0,0],[-125,75,-25],[-220,220,-52],[-220,450,-82]]");

  await third.evaluate((hash) => void (location.hash = hash), new URL(link).hash); // pasted into the address
  await expect.poll(() => shown(third)).toEqual(before);
  await third.evaluate(() => void (location.hash = `#1.${"A".repeat(70_000)}`));
  await expect(toasts(third)).toContainText("This link is longer than 64 kB and was not opened.");
  expect(await shown(third)).toEqual(before);
  await again.close();
});

// ---- 17 ---------------------------------------------------------------------------------------------------------

test("17 · files that are no problems get their sentences, and nothing changes", async ({page}, info) => {
  await open_workbench(page);
  await move_a_pose(page);
  await shown(page);
  const before = await read_state(page, (workbench) => JSON.stringify(workbench.whole_problem));
  const {files} = JSON.parse(readFileSync(join(bad_problems, "expected.json"), "utf8")) as {
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
  for (const name of names) {
    await open_files(page, join(bad_problems, name));
    const [place, message] = files[name]![0]!;
    await expect(toasts(page)).toContainText(`“${name}” is not a Linkwright problem: ${place}`);
    await expect(toasts(page)).toContainText(message);
    await expect(toasts(page)).toContainText("Your work is unchanged.");
  }
  await open_files(page, join(bad_problems, "newer_version.json"));
  await expect(toasts(page)).toContainText(
    "This file was written by a newer Linkwright (version 2; this is 1). Reload the page to get the newest.",
  );
  await open_files(page, join(bad_problems, "invalid_utf8.json"));
  await expect(toasts(page)).toContainText("“invalid_utf8.json” is not a Linkwright problem: this is not UTF-8 text");

  const brackets = info.outputPath("brackets.json"),
    file = openSync(brackets, "w"),
    million = Buffer.alloc(1 << 20, "[");
  for (let i = 0; i < 200; ++i) writeSync(file, million);
  closeSync(file);
  await open_files(page, brackets);
  await expect(toasts(page)).toContainText("“brackets.json” is larger than 16 MB and was not opened.");
  expect(await read_state(page, (workbench) => JSON.stringify(workbench.whole_problem))).toBe(before);
});
