// A newcomer's first hour: a task of his own, typed, begun anew as another kind, kept, shared.
import type {Locator, Page} from "@playwright/test";
import {
  expect,
  file_menu,
  keep_screenshot,
  move_a_pose,
  open_settled,
  open_workbench,
  poses_of_page,
  read_state,
  test,
  toasts,
  type_into,
  until_at_rest,
  until_mapped,
  until_settled,
} from "./support";
import type {MotionTask} from "../src/kinds/motion/task";

const hatch = "0\t0\t0\n60\t35\t22\n160\t120\t58\n190\t240\t95";
async function paste(page: Page, text: string): Promise<void> {
  await page.getByTestId("task.x.1").evaluate((field, pasted) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData("text/plain", pasted);
    field.dispatchEvent(new ClipboardEvent("paste", {clipboardData, bubbles: true, cancelable: true}));
  }, text);
}
async function begin(page: Page, id: string): Promise<void> {
  await page.getByTestId("bar.new").click();
  await page.getByTestId(`new.${id}`).check();
  await page.getByTestId("new.create").click();
}
async function is_within(inner: Locator, outer: Locator): Promise<boolean> {
  const a = (await inner.boundingBox())!,
    b = (await outer.boundingBox())!;
  return a.x >= b.x - 1 && a.y >= b.y - 1 && a.x + a.width <= b.x + b.width + 1 && a.y + a.height <= b.y + b.height + 1;
}

// ---- a new task -----------------------------------------------------------------------------------------------------

test("a new task begins at its first card, which is checked and in sight, wide and on a phone", async ({page}) => {
  await open_settled(page);
  for (const size of [
    {width: 1440, height: 900},
    {width: 390, height: 844},
  ]) {
    await page.setViewportSize(size);
    await page.getByTestId("bar.new").click();
    const dialog = page.getByTestId("dialog.new"),
      first = page.getByTestId("new.four_positions");
    await expect(first).toBeChecked();
    await expect(first).toBeFocused();
    expect(await dialog.locator(".inside").evaluate((inside) => inside.scrollTop)).toBe(0);
    for (const part of [first, page.getByTestId("new.create")]) expect(await is_within(part, dialog)).toBe(true);
    await keep_screenshot(page, `new-task-${size.width}`);
    await page.keyboard.press("Escape");
    await expect(dialog).toBeHidden();
  }
});

// ---- the table ------------------------------------------------------------------------------------------------------

// ---- nothing left ---------------------------------------------------------------------------------------------------

// ---- the linkage in hand --------------------------------------------------------------------------------------------

/** Joints that cannot be seen: outside of the drawing, or below what lies over it. */
function hidden_joints(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const frame = document.querySelector("svg.drawing")!.getBoundingClientRect(),
      inset = document.querySelector(".inset > *")?.getBoundingClientRect();
    const joints = [...document.querySelectorAll("[data-testid='drawing.linkage'] .joint")].map((joint) => {
      const {x, y, width, height} = joint.getBoundingClientRect();
      return {x: x + width / 2, y: y + height / 2};
    });
    const outside = joints.filter(
      ({x, y}) =>
        x < frame.left ||
        x > frame.right ||
        y < frame.top ||
        y > frame.bottom ||
        (inset && x > inset.left && x < inset.right && y > inset.top && y < inset.bottom),
    );
    return joints.length ? outside.map(({x, y}) => `${Math.round(x)}, ${Math.round(y)}`) : ["no joints"];
  });
}
test("is always in view, joined to the body: in every beginning, an example, and what undo brings back", async ({
  page,
}) => {
  test.setTimeout(180_000);
  await open_settled(page);
  await type_into(page, "task.x.4", "900");
  await until_settled(page);
  expect(((await read_state(page, ({problem}) => problem.task)) as MotionTask).poses[3]!.x).toBe(900);
  await expect.poll(() => hidden_joints(page)).toEqual([]);
  for (const id of ["four_positions", "three_positions", "five_positions", "six_bar", "straight_line_five"]) {
    await begin(page, id);
    await until_settled(page);
    await expect.poll(() => hidden_joints(page), id).toEqual([]);
    if (id !== "straight_line_five") await expect(page.getByTestId("drawing.body_web")).toHaveAttribute("d", /^M.*Z$/);
  }
  await file_menu(page, "file.examples");
  await page.getByTestId("example.hatchback_lid").click();
  await until_settled(page);
  await expect.poll(() => hidden_joints(page)).toEqual([]);
  for (let k = 0; k < 3; ++k) await page.getByTestId("drawing.zoom_in").click();
  await page.getByTestId("edit.undo").click();
  await until_settled(page);
  await expect.poll(() => hidden_joints(page)).toEqual([]);
});
// ---- the best -------------------------------------------------------------------------------------------------------

test("a list that comes to lie under the pointer at rest shows none of its rows, and has room for long names and numbers", async ({
  page,
}) => {
  await open_settled(page);
  await page.getByTestId("best.tab").click();
  const box = (await page.getByTestId("best.3").boundingBox())!;
  await page.mouse.move(box.x + 8, box.y + 8);
  await expect.poll(() => read_state(page, ({hovered}) => hovered !== null)).toBe(true);
  await move_a_pose(page);
  await until_settled(page);
  await expect(page.getByTestId("best.title").locator("table.stale")).toHaveCount(0);
  await page.waitForTimeout(300);
  expect(await read_state(page, ({hovered}) => hovered)).toBeNull();
  await page.mouse.move(box.x + 12, box.y + 9);
  await expect.poll(() => read_state(page, ({hovered}) => hovered !== null)).toBe(true);
  await expect(page.getByTestId("best.1")).toBeVisible();
  await begin(page, "straight_line");
  await until_settled(page);
  await read_state(page, ({engine, best_list, picked_linkage}) => {
    // A search takes a minute: ten such linkages with long numbers stand for what it finds.
    const {tau, type, input, output} = picked_linkage!,
      numbers = Object.fromEntries(
        [
          "min_transmission_angle_deg",
          "link_ratio",
          "longest",
          "longest_link",
          "stroke_over_longest",
          "usable_stroke",
          "usable_strip",
          "deviation",
          "velocity_uniformity",
          "driver_sweep_deg",
        ].map((key) => [key, 1234.5678]),
      ),
      pivots = [input.center, input.circle, output.center, output.circle],
      linkages = Array.from({length: 10}, () => ({
        tau,
        type: type === "crank_rocker" ? type : "triple_rocker_coupler",
        pivots,
        ...numbers,
      }));
    engine!.run = (() => Promise.resolve({linkages, notices: []})) as unknown as NonNullable<typeof engine>["run"];
    best_list.question.drop();
    return best_list.fetch();
  });
  await expect(page.getByTestId("best.1")).toBeVisible();
  const widths = await page
    .locator("td.type")
    .evaluateAll((cells) => cells.map((cell) => cell.getBoundingClientRect().width));
  for (const width of widths) expect(width).toBeGreaterThan(80);
  const table = (await page.locator("section.best .scroll").boundingBox())!,
    card = (await page.getByTestId("best.title").boundingBox())!;
  expect(table.x + table.width).toBeLessThanOrEqual(card.x + card.width);
  await keep_screenshot(page, "best-of-a-straight-line");
});
// ---- drawing --------------------------------------------------------------------------------------------------------

// ---- kept and shared ------------------------------------------------------------------------------------------------

test("my tasks: each is kept with its picture, opened, renamed, deleted and had back", async ({page}) => {
  await open_settled(page);
  await file_menu(page, "tasks.title");
  await expect(page.getByTestId("tasks.none")).toBeVisible();
  await page.keyboard.press("Escape");
  await paste(page, hatch);
  await read_state(page, (workbench) => workbench.edit((problem) => ({...problem, title: "Hatch"})));
  await until_settled(page);
  const poses = await poses_of_page(page);
  await page.getByTestId("bar.new").click();
  await page.getByTestId("new.keep").uncheck();
  await page.getByTestId("new.create").click();
  await until_settled(page);
  await file_menu(page, "tasks.title");
  await expect(page.getByTestId("tasks.0")).toContainText("Hatch");
  const canvas = page.getByTestId("tasks.0").locator("canvas");
  expect(
    await canvas.evaluate((picture: HTMLCanvasElement) => {
      const {data} = picture.getContext("2d")!.getImageData(0, 0, picture.width, picture.height);
      return new Set(new Uint32Array(data.buffer)).size;
    }),
  ).toBeGreaterThan(2);
  await expect(page.getByTestId("tasks.0").locator("svg path.link")).toHaveCount(3);
  await keep_screenshot(page, "my-tasks");
  await page.getByTestId("tasks.rename.0").click();
  await page.getByTestId("tasks.name").fill("Rear hatch");
  await page.keyboard.press("Enter");
  await expect(page.getByTestId("tasks.0")).toContainText("Rear hatch");
  await page.getByTestId("tasks.delete.0").click();
  await expect(page.getByTestId("tasks.none")).toBeVisible();
  await page.getByTestId("tasks.undo").click();
  await expect(page.getByTestId("tasks.0")).toContainText("Rear hatch");
  await page.reload();
  await until_mapped(page);
  await file_menu(page, "tasks.title");
  await page.getByTestId("tasks.open.0").click();
  await expect(page).toHaveTitle(/Rear hatch/);
  expect(await poses_of_page(page)).toEqual(poses);
});
test("a link to this computer says so and offers the file; the print has none", async ({page, context}) => {
  await open_settled(page);
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.getByTestId("share.link").click();
  await expect(toasts(page)).toContainText("nobody else can reach 127.0.0.1");
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByTestId("toast.file.save").click()]);
  expect(download.suggestedFilename()).toMatch(/\.json$/);
  const sheet = page.getByTestId("export.sheet");
  await expect(sheet).toBeAttached(); // the page is at rest
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  await expect(sheet).toContainText("No link is printed");
  await expect(sheet.getByTestId("print.stand_in").locator("svg")).toHaveCount(1); // printed by the browser's own menu
  await page.evaluate(() => dispatchEvent(new Event("afterprint")));
  await expect(sheet.getByTestId("print.stand_in").locator("svg")).toHaveCount(0);
});
test("no drawing is made for the printer before anyone prints", async ({page}) => {
  await open_settled(page);
  await page.evaluate(() => (window.print = () => void (document.documentElement.dataset.printed = "yes")));
  const sheet = page.getByTestId("export.sheet").locator(".drawing img");
  await page.waitForTimeout(1200);
  await expect(sheet).toHaveCount(0);
  await page.keyboard.press("Control+p");
  await page.waitForFunction(() => document.documentElement.dataset.printed === "yes");
  await expect(sheet).toHaveCount(1);
});
// ---- without the server ---------------------------------------------------------------------------------------------

test("films that cannot be made say why, and a failure is no success", async ({page, complaints}) => {
  await open_settled(page);
  await until_at_rest(page);
  await page.route(/\.js$/, (route) => route.abort());
  await page.getByTestId("export.title").click();
  await expect(page.getByTestId("export.mp4")).toContainText("could not be loaded");
  await page.getByTestId("export.gif").click();
  const status = page.getByTestId("export.status");
  await expect(status).toContainText("could not be made");
  await expect(status).toHaveClass(/failed/);
  complaints.expect_and_forget(/\.js|ERR_FAILED/);
});
test("a dialog that cannot be loaded says so, and is there as soon as it can", async ({page, complaints}) => {
  const dialog = /\/ExportDialog-[^/]*\.js$/;
  await page.route(dialog, (route) => route.abort());
  await open_settled(page);
  await page.getByTestId("export.title").click();
  await expect(page.getByTestId("failed.dialog.title")).toBeVisible();
  await page.unroute(dialog);
  await page.getByTestId("failed.again").click();
  await expect(page.getByTestId("export.dxf")).toBeVisible();
  complaints.expect_and_forget(/ExportDialog|ERR_FAILED|Failed to fetch/);
});
test("a plot that cannot be loaded says so, and is there as soon as it can", async ({page, complaints}) => {
  const chart = /\/chart-[^/]*\.js$/;
  await page.route(chart, (route) => route.abort());
  await open_workbench(page);
  await until_settled(page);
  // Each map draws the part anew by itself: the last one, too.
  await page.waitForFunction(() => globalThis.__linkwright!.workbench.map!.samples === 1000);
  await expect(page.getByTestId("failed.drive.title")).toBeVisible();
  await page.unroute(chart);
  await page.getByTestId("failed.again").click();
  await expect(page.getByTestId("plot.title").locator("canvas")).toBeVisible();
  complaints.expect_and_forget(/chart-|ERR_FAILED|Failed to fetch/);
});
test("a sphere that cannot be loaded says so, and is there as soon as it can", async ({page, complaints}) => {
  await open_settled(page);
  await page.route(/SphereStage.*\.js$/, (route) => route.abort());
  await begin(page, "four_orientations");
  const notice = page.getByTestId("spherical.view.failed");
  await expect(notice).toContainText("could not be loaded");
  expect(await is_within(notice, page.getByTestId("spherical.stage"))).toBe(true);
  await expect(page.locator("[data-label]")).toHaveCount(0);
  await keep_screenshot(page, "sphere-not-loaded");
  complaints.expect_and_forget(/SphereStage|ERR_FAILED/);
});
// ---- numbers --------------------------------------------------------------------------------------------------------

test("pinned numbers stand apart, and coordinates are never cut", async ({page}) => {
  await open_settled(page);
  await read_state(page, (workbench) => {
    workbench.pin();
    workbench.change_pin("A", {link_ratio: 17.6, longest: 12027});
  });
  const cells = page.getByTestId("pin.row.A").locator("td"),
    texts = await cells.evaluateAll((all) =>
      all.slice(0, 3).map((cell) => {
        const range = document.createRange();
        range.selectNodeContents(cell);
        const {left, right} = range.getBoundingClientRect();
        return {left, right};
      }),
    );
  for (const k of [1, 2]) expect(texts[k]!.left - texts[k - 1]!.right).toBeGreaterThan(3);
  await page.getByTestId("view.language").click();
  const heads = await page
    .getByTestId("pin.title")
    .locator("thead th")
    .evaluateAll((all) =>
      all.slice(1, 4).map((cell) => {
        const range = document.createRange();
        range.selectNodeContents(cell);
        return [range.getBoundingClientRect().left, range.getBoundingClientRect().right];
      }),
    );
  for (const k of [1, 2]) expect(heads[k]![0]! - heads[k - 1]![1]!).toBeGreaterThan(2);
  await keep_screenshot(page, "pins");
  await page.getByTestId("view.language").click();
  await begin(page, "six_bar");
  await until_settled(page);
  const cut = await page
    .getByTestId("num.title")
    .locator("dd > span")
    .evaluateAll((all) =>
      all.filter((span) => span.scrollWidth > span.clientWidth + 1).map((span) => span.textContent),
    );
  expect(cut).toEqual([]);
  await keep_screenshot(page, "six-bar-numbers");
});
