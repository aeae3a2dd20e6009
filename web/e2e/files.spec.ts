// Work that leaves the page and comes back: files, the browser's store, links, and files that are none. The numbers of the
// tests are the walk-throughs'.
import type {BrowserContext, Page} from "@playwright/test";
import {
  example,
  expect,
  file_menu,
  move_a_pose,
  open_workbench,
  read_state,
  shown,
  test,
  toasts,
  until_ready,
} from "./support";
import type {MotionTask} from "../src/kinds/motion/task";

// ---- 15 ---------------------------------------------------------------------------------------------------------

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
