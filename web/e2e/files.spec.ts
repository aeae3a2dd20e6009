// Work that leaves the page and comes back by what only a browser has: its stores, its tabs, its clipboard, its address.
// What else there is of files: src/shell/files.dom.test.ts. The numbers of the tests are the walk-throughs'.
import {
  expect,
  file_menu,
  keep_screenshot,
  move_a_pose,
  open_workbench,
  page_in,
  read_state,
  shown,
  test,
  toasts,
  until_ready,
  until_settled,
} from "./support";
import type {MotionTask} from "../src/kinds/motion/task";

test("15 · work outlives a reload, also what was done just before it; my tasks have pictures; two tabs keep their work apart", async ({
  page,
  context,
}) => {
  await open_workbench(page);
  await move_a_pose(page);
  await read_state(page, (workbench) => workbench.pin());
  await read_state(page, (workbench) => workbench.change_pin("A", {name: "lid, 2nd…"}));
  const before = await shown(page);
  await read_state(page, (workbench) => {
    workbench.edit((problem) => ({...problem, title: "At the last moment"}));
    location.reload();
  });
  await expect(page).toHaveTitle(/At the last moment/);
  await until_ready(page);
  expect(await shown(page)).toEqual(before);
  for (let i = 0; i < 4; ++i) await page.keyboard.press("Control+z"); // title, name, pin, pose
  expect(
    await read_state(page, ({can_undo, pins, problem}) => [
      can_undo,
      pins.length,
      (problem.task as MotionTask).poses[2]!.x,
    ]),
  ).toEqual([false, 0, -220]);
  for (let i = 0; i < 4; ++i) await page.keyboard.press("Control+y");
  expect(await shown(page)).toEqual(before);

  await test.step("a task that another takes the place of is kept with its picture, and opened again", async () => {
    await page.getByTestId("bar.new").click();
    await page.getByTestId("new.keep").uncheck();
    await page.getByTestId("new.create").click();
    await until_settled(page);
    await file_menu(page, "tasks.title");
    const kept = page.getByTestId("tasks.0");
    await expect(kept).toContainText("At the last moment");
    expect(
      await kept.locator("canvas").evaluate((picture: HTMLCanvasElement) => {
        const {data} = picture.getContext("2d")!.getImageData(0, 0, picture.width, picture.height);
        return new Set(new Uint32Array(data.buffer)).size;
      }),
    ).toBeGreaterThan(2);
    await keep_screenshot(page, "my-tasks");
    await page.getByTestId("tasks.open.0").click();
    await expect(page).toHaveTitle(/At the last moment/);
    expect(await shown(page)).toEqual(before);
  });

  await test.step("two tabs keep their work apart", async () => {
    const other = await page_in(context);
    await open_workbench(other);
    await read_state(other, (workbench) => workbench.edit((problem) => ({...problem, title: "The other tab"})));
    await expect(toasts(page)).toContainText(["This work is also open in another tab."]);
    await read_state(page, (workbench) => workbench.edit((problem) => ({...problem, title: "This tab"})));
    await page.reload();
    await expect(page).toHaveTitle(/This tab/);
    await other.reload();
    await expect(other).toHaveTitle(/The other tab/);
    await file_menu(other, "tasks.title");
    await other.getByTestId("tasks.tab.0").click();
    await expect(other).toHaveTitle(/This tab/);
  });
});

test("16 · a link is the task elsewhere, and one to this computer says so and offers the file", async ({
  page,
  context,
  browser,
}) => {
  await open_workbench(page);
  await move_a_pose(page);
  await read_state(page, (workbench) => workbench.pin());
  const before = await shown(page);
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.getByTestId("share.link").click();
  await expect(toasts(page)).toContainText(/Link copied \(\d.*characters\)/);
  await expect(toasts(page)).toContainText("nobody else can reach 127.0.0.1");
  const link = await page.evaluate(() => navigator.clipboard.readText());
  expect(link.length).toBeLessThan(4000);
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByTestId("toast.file.save").click()]);
  expect(download.suggestedFilename()).toMatch(/\.json$/);

  const elsewhere = await browser.newContext({locale: "en-GB"});
  const other = await page_in(elsewhere);
  await open_workbench(other, link);
  await expect.poll(() => new URL(other.url()).hash).toBe(""); // from now on it is work like any other
  expect(await shown(other)).toEqual(before);
  await other.reload();
  await until_ready(other);
  expect(await shown(other)).toEqual(before);
  await elsewhere.close();
});
