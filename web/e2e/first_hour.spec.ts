// A newcomer's first hour: a task of his own, typed, begun anew as another kind, kept, shared.
import type {Locator, Page} from "@playwright/test";
import {
  drag,
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
import type {MotionTask} from "../src/tasks/motion/task";

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

for (const size of [
  {width: 1440, height: 900},
  {width: 390, height: 844},
])
  test(`a new task begins at its first card, which is checked and in sight, ${size.width} wide`, async ({page}) => {
    await page.setViewportSize(size);
    await open_settled(page);
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
  });

test("another kind keeps the positions, and a new task keeps the user's own where he wants it", async ({page}) => {
  await open_settled(page);
  await paste(page, hatch);
  await until_mapped(page);
  const poses = await poses_of_page(page);
  await page.getByTestId("task.kind").click();
  await expect(page.getByTestId("new.four_positions")).toBeChecked();
  await expect(page.getByTestId("new.keep")).toBeChecked();
  await page.getByTestId("new.six_bar").check();
  await page.getByTestId("new.create").click();
  expect(await read_state(page, ({problem}) => problem.task.mechanism)).toBe("six_bar");
  expect(await poses_of_page(page)).toEqual(poses);
  await expect(page.getByTestId("task.missing").or(page.getByTestId("region.notice")).first()).toBeVisible();

  await page.getByTestId("bar.new").click();
  await page.getByTestId("new.five_positions").check();
  await expect(page.getByTestId("new.keep")).toBeChecked(); // they are his own
  await expect(page.getByTestId("dialog.new")).toContainText("Keep the 4 positions of this task. 1 more is added.");
  await page.getByTestId("new.keep").uncheck();
  await page.getByTestId("new.create").click();
  expect((await poses_of_page(page))[1]).not.toEqual(poses[1]);
  await page.getByTestId("bar.new").click();
  await expect(page.getByTestId("new.keep")).not.toBeChecked(); // they are the beginning's
});

test("five positions begin with linkages that meet what is required", async ({page}) => {
  await open_settled(page);
  await begin(page, "five_positions");
  await until_settled(page);
  const census = await read_state(page, (workbench) => workbench.census!);
  expect(census.meeting).toBeGreaterThan(0);
  await expect(page.getByTestId("region.notice")).toHaveCount(0);
  expect(await page.getByText("Relax one position").count()).toBe(1);
  await keep_screenshot(page, "new-five-positions");
});

// ---- the table ------------------------------------------------------------------------------------------------------

test("Tab goes from number to number, row to row; the row's menu opens by a key and moves the row", async ({page}) => {
  await open_settled(page);
  await page.getByTestId("task.x.2").focus();
  const numbers = ["60", "35", "22", "160", "120", "58", "190", "240", "95"];
  for (const [i, number] of numbers.entries()) {
    await page.keyboard.type(number);
    await page.keyboard.press(i < numbers.length - 1 ? "Tab" : "Enter");
  }
  const typed = [
    {x: 0, y: 0, theta_deg: 0},
    {x: 60, y: 35, theta_deg: 22},
    {x: 160, y: 120, theta_deg: 58},
    {x: 190, y: 240, theta_deg: 95},
  ];
  expect(await poses_of_page(page)).toEqual(typed);
  await page.getByTestId("task.theta_deg.3").focus();
  await page.keyboard.press("Shift+Tab");
  await expect(page.getByTestId("task.y.3")).toBeFocused();

  await page.keyboard.press("Shift+F10");
  await expect(page.getByTestId("task.move_up")).toBeVisible();
  await page.getByTestId("task.move_up").press("Enter");
  expect(await poses_of_page(page)).toEqual([typed[0], typed[2], typed[1], typed[3]]);
  await expect(page.getByTestId("task.y.3")).toBeFocused();
});
test("Tab goes from number to number in the table of pairs", async ({page}) => {
  await open_settled(page);
  await begin(page, "function");
  await page.getByTestId("function.input_deg.1").focus();
  for (const next of ["output_deg.1", "input_deg.2", "output_deg.2"]) {
    await page.keyboard.press("Tab");
    await expect(page.getByTestId(`function.${next}`)).toBeFocused();
  }
  const pairs = () => read_state(page, ({problem}) => (problem.task as unknown as {pairs: object[]}).pairs.length),
    before = await pairs();
  await page.keyboard.press("Shift+F10");
  await page.getByTestId("function.menu.remove").press("Enter");
  expect(await pairs()).toBe(before - 1);
});
test("more rows than are taken are refused, and said", async ({page}) => {
  await open_settled(page);
  const before = await poses_of_page(page);
  await paste(page, Array.from({length: 5000}, (_, i) => `${i}\t${i}\t${i}`).join("\n"));
  await expect(page.getByTestId("task.fault")).toContainText("5\u202f000 rows are more than the 100 that are taken.");
  expect(await poses_of_page(page)).toEqual(before);
  await paste(page, Array.from({length: 90}, (_, i) => `${i}\t${i}\t${i}`).join("\n"));
  await expect(page.getByTestId("task.pattern")).toHaveText("P-P-…-P");
});

// ---- nothing left ---------------------------------------------------------------------------------------------------

test("where nothing is left, the page shows where the task could go, and goes there", async ({page}) => {
  await open_settled(page);
  await begin(page, "four_positions"); // no boxes for pivots
  await until_settled(page);
  await paste(page, hatch);
  await until_mapped(page);
  expect(await read_state(page, ({census}) => census!.meeting)).toBe(0);
  const way = page.getByTestId("region.way_out");
  await expect(way).toHaveText(/^Move position \d by [\d.]+ mm$/);
  await expect(page.getByTestId("drawing.halo")).toHaveAttribute("data-squares", /[1-9]/);
  await keep_screenshot(page, "nothing-left");
  const {pose, by, meeting} = await read_state(page, ({way_out}) => way_out.found!),
    before = (await poses_of_page(page))[pose]!;
  await way.click();
  await until_mapped(page);
  const after = (await poses_of_page(page))[pose]!;
  expect([after.x - before.x, after.y - before.y]).toEqual([expect.closeTo(by[0], 9), expect.closeTo(by[1], 9)]);
  expect(await read_state(page, ({census}) => census!.meeting)).toBe(meeting); // what was said
  await expect(page.getByTestId("region.notice")).toHaveCount(0);
  await expect(page.getByTestId("drawing.halo")).toHaveCount(0);
  await expect.poll(() => read_state(page, ({hand}) => hand?.fails)).toBe(0); // the best of what is left now
});

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
test("is never drawn as one of another kind", async ({page}) => {
  await open_settled(page); // its complaints are looked at in the end: a path with NaN is one
  for (const id of ["five_positions", "six_bar", "five_positions", "six_bar", "function"]) {
    await begin(page, id);
    await until_settled(page);
  }
});

// ---- the best -------------------------------------------------------------------------------------------------------

test("a row of the best is taken wherever it is clicked, and no list of another task stays", async ({page}) => {
  test.setTimeout(120_000);
  await open_settled(page);
  await page.getByTestId("best.tab").click();
  const row = page.locator("tr", {has: page.getByTestId("best.3")});
  await row.locator("td").nth(3).click();
  expect(
    await read_state(page, ({picked, best_list}) => picked!.tau.join() === best_list.found!.linkages[2]!.tau.join()),
  ).toBe(true);
  await begin(page, "straight_search");
  await expect(page.getByTestId("best.1")).toHaveCount(0);
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
test("a list that comes to lie under the pointer at rest shows none of its rows", async ({page}) => {
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
});

// ---- drawing --------------------------------------------------------------------------------------------------------

test("a box may begin below the banner that asks for it", async ({page}) => {
  await open_settled(page);
  await page.keyboard.press("r");
  const banner = (await page.getByTestId("drawing.mode").locator("p").boundingBox())!;
  await drag(
    page,
    {x: banner.x + banner.width / 2, y: banner.y + banner.height / 2},
    {x: banner.x + banner.width / 2 + 200, y: banner.y + 250},
  );
  expect(await read_state(page, ({problem}) => problem.requirements?.ground_pivots_within ?? null)).not.toBeNull();
});
test("what is said of the curve's branches stands in the status bar, not over the map", async ({page}) => {
  await open_settled(page);
  await expect(page.getByTestId("status.branches")).toHaveText(/^\d branch(es)?$/);
});

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
test("a dropped table of positions is taken; models and documents are told from tasks", async ({page}) => {
  await open_settled(page);
  const drop = (name: string, content: string) =>
    page.evaluate(
      ([file, text]) => {
        const data = new DataTransfer();
        data.items.add(new File([text!], file!));
        for (const type of ["dragover", "drop"])
          document
            .querySelector("aside")!
            .dispatchEvent(new DragEvent(type, {dataTransfer: data, bubbles: true, cancelable: true}));
      },
      [name, content],
    );
  await drop("poses.csv", "x;y;theta\n0;0;0\n60;35;22\n160;120;58\n190;240;95\n");
  await expect(toasts(page)).toContainText("4 positions of “poses.csv” are taken.");
  expect((await poses_of_page(page))[3]).toEqual({x: 190, y: 240, theta_deg: 95});
  await page.getByTestId("toast.edit.undo").click();
  expect((await poses_of_page(page))[3]!.x).not.toBe(190);
  await drop("hinge.step", "ISO-10303-21;\nHEADER;");
  await expect(toasts(page)).toContainText("“hinge.step” is a solid model");
  await drop("report.pdf", "%PDF-1.7 x");
  await expect(toasts(page)).toContainText("“report.pdf” is no problem file");
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
  await expect(page.getByTestId("spherical.view.failed")).toContainText("could not be loaded");
  await expect(page.locator("[data-label]")).toHaveCount(0);
  await keep_screenshot(page, "sphere-not-loaded");
  complaints.expect_and_forget(/SphereStage|ERR_FAILED/);
});
test("a browser without WebGL has no sphere, says so in full, and leaves no labels behind", async ({
  page,
  complaints,
}) => {
  await page.addInitScript(() => {
    const get_context = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, kind: string, ...rest: unknown[]) {
      return /webgl/.test(kind) ? null : (get_context as (...all: unknown[]) => unknown).call(this, kind, ...rest);
    } as typeof get_context;
  });
  await open_workbench(page);
  await begin(page, "four_orientations");
  const notice = page.getByTestId("spherical.view.no_webgl");
  await expect(notice).toContainText("WebGL is off");
  expect(await is_within(notice, page.getByTestId("spherical.stage"))).toBe(true);
  await expect(page.locator("[data-label]")).toHaveCount(0);
  complaints.expect_and_forget(/WebGL/);
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

test("typing a position out of the view brings the linkage back into it", async ({page}) => {
  await open_settled(page);
  await type_into(page, "task.x.4", "900");
  await until_settled(page);
  expect(((await read_state(page, ({problem}) => problem.task)) as MotionTask).poses[3]!.x).toBe(900);
  await expect.poll(() => hidden_joints(page)).toEqual([]);
});
