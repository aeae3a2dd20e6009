// A newcomer's first hour: a task of his own, typed, begun anew as another kind, kept, shared.
import type {Locator, Page} from "@playwright/test";
import {
  expect,
  file_menu,
  keep_screenshot,
  move_a_pose,
  open_settled,
  read_state,
  test,
  type_into,
  until_at_rest,
  until_fine,
  until_settled,
} from "./support";
import type {MotionTask} from "../src/kinds/motion/task";

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
test("a new task begins at its first card, in sight; its linkage is always in view, joined to the body, as an example's and what undo brings back", async ({
  page,
}) => {
  await open_settled(page);
  await test.step("the dialog begins at its first card, which is checked and in sight, on a phone and wide", async () => {
    for (const size of [
      {width: 390, height: 844},
      {width: 1440, height: 900},
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
  expect(await read_state(page, ({hovered}) => hovered)).not.toBeNull();
  await move_a_pose(page);
  await until_settled(page);
  await expect(page.getByTestId("best.title").locator("table.stale")).toHaveCount(0);
  await expect(page.locator("section.best tr:hover")).toHaveCount(1); // the browser has noticed
  expect(await read_state(page, ({hovered}) => hovered)).toBeNull();
  await page.mouse.move(box.x + 12, box.y + 9);
  expect(await read_state(page, ({hovered}) => hovered)).not.toBeNull();
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
// ---- without the server ---------------------------------------------------------------------------------------------

test("plot, dialog, sphere and films that cannot be loaded say so, and are there as soon as they can", async ({
  page,
  complaints,
}) => {
  const chart = /\/chart-[^/]*\.js$/,
    dialog = /\/Examples-[^/]*\.js$/,
    sphere = /\/SphereStage[^/]*\.js$/,
    again = page.getByTestId("failed.again");
  for (const part of [chart, dialog, sphere]) await page.route(part, (route) => route.abort());
  await open_settled(page);
  await test.step("a plot", async () => {
    await until_fine(page); // each map draws the part anew by itself: the last one, too
    await expect(page.getByTestId("failed.drive.title")).toBeVisible();
    await page.unroute(chart);
    await again.click();
    await expect(page.getByTestId("plot.title").locator("canvas")).toBeVisible();
  });
  await test.step("a dialog", async () => {
    await file_menu(page, "file.examples");
    await expect(page.getByTestId("failed.dialog.title")).toBeVisible();
    await page.unroute(dialog);
    await again.click();
    await expect(page.getByTestId("example.tailgate")).toBeVisible();
    await page.keyboard.press("Escape");
  });
  await test.step("a sphere", async () => {
    await begin(page, "four_orientations");
    const notice = page.getByTestId("spherical.view.failed");
    await expect(notice).toContainText("could not be loaded");
    expect(await is_within(notice, page.getByTestId("spherical.stage"))).toBe(true);
    await expect(page.locator("[data-label]")).toHaveCount(0);
    await keep_screenshot(page, "sphere-not-loaded");
    await page.unroute(sphere);
  });
  await test.step("films: the reason stands where they are made, and a failure is no success", async () => {
    await begin(page, "four_positions");
    await until_settled(page);
    await until_at_rest(page);
    await page.route(/\.js$/, (route) => route.abort());
    await page.getByTestId("export.title").click();
    await expect(page.getByTestId("export.mp4")).toContainText("could not be loaded");
    await page.getByTestId("export.gif").click();
    const status = page.getByTestId("export.status");
    await expect(status).toContainText("could not be made");
    await expect(status).toHaveClass(/failed/);
  });
  complaints.expect_and_forget(/\.js|ERR_FAILED|Failed to fetch/);
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
