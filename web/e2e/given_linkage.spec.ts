// A linkage that one has is opened, driven, changed and taken away; nothing is sought.
import type {Page} from "@playwright/test";
import {readFileSync} from "node:fs";
import {join} from "node:path";
import {
  examples,
  expect,
  file_menu,
  keep_screenshot,
  open_files,
  open_workbench,
  read_state,
  run_program,
  test,
  toasts,
} from "./support";

const crank_rocker = join(examples, "linkages/crank_rocker.json");

async function opened(page: Page, ...files: Parameters<typeof open_files>[1][]): Promise<void> {
  await open_workbench(page);
  for (const file of files) await open_files(page, file);
  await expect.poll(() => read_state(page, ({hand, is_current}) => is_current && hand?.drive !== null)).toBe(true);
}

test("a file with lengths is opened as a linkage, driven, and told with speeds", async ({page}) => {
  await opened(page, crank_rocker);
  await expect(toasts(page)).toContainText("“crank_rocker.json” opened.");
  await expect(page.getByTestId("task.kind")).toContainText("Linkage · four-bar");
  await expect(page.getByTestId("num.type")).toContainText("Crank-rocker");
  await expect(page.getByTestId("req.title")).toHaveCount(0);
  await expect(page.getByTestId("num.best")).toHaveCount(0);
  expect(await read_state(page, ({hand}) => hand!.drive!.full_turn)).toBe(true);

  await page.getByTestId("linkage.rpm").fill("120");
  await page.keyboard.press("Enter");
  const input = page.getByTestId("linkage.rate.input");
  await expect(input).toContainText("12.57 rad/s");
  await expect(input).toContainText("0 rad/s²");
  await expect(page.getByTestId("linkage.rate.point")).toContainText("/s²");
  // The output's is the velocity ratio of the drive's table times the input's.
  const expected = await read_state(page, ({hand, angle}) => {
    const {states, width} = hand!.drive!;
    for (let row = 0; row * width < states.length; ++row)
      if (Math.abs(states[row * width]! - angle) < 1e-9) return 4 * Math.PI * states[row * width + 11]!;
    return NaN;
  });
  const told = await page.getByTestId("linkage.rate.output").textContent();
  expect(Number(/(−?[\d.]+) rad\/s/.exec(told!)![1]!.replace("−", "-"))).toBeCloseTo(expected, 2);

  await page.getByTestId("drive.play").click();
  const before = await read_state(page, ({angle}) => angle);
  await expect.poll(() => read_state(page, ({angle}) => angle)).not.toBe(before);
  await page.getByTestId("drive.play").click();
  await keep_screenshot(page, "given-linkage");
});

test("its numbers are typed, what does not close is refused, and it is saved as the program reads it", async ({
  page,
}, info) => {
  await opened(page, crank_rocker);
  const coupler = page.getByTestId("linkage.lengths.coupler");
  await coupler.fill("3.2");
  await page.keyboard.press("Enter");
  await expect.poll(() => read_state(page, ({hand}) => hand!.lengths!.coupler)).toBeCloseTo(3.2, 9);
  await coupler.fill("30");
  await page.keyboard.press("Enter");
  await expect(page.getByTestId("task.fault").first()).toContainText("do not close");
  expect(await read_state(page, ({hand}) => hand!.lengths!.coupler)).toBeCloseTo(3.2, 9);
  await page.keyboard.press("Escape");
  const [download] = await Promise.all([page.waitForEvent("download"), file_menu(page, "file.save")]);
  const path = info.outputPath(download.suggestedFilename());
  await download.saveAs(path);
  expect(run_program("analyze", readFileSync(path, "utf8"))).toMatch(/crank-rocker/i);
  await page.keyboard.press("Control+z");
  await expect.poll(() => read_state(page, ({hand}) => hand!.lengths!.coupler)).toBeCloseTo(3, 9);
});

test("six-bars and spherical linkages are opened, too, and all are exported", async ({page}) => {
  const files = {
    "s.json": {mechanism: "spherical_four_bar", angles_deg: {ground: 80, input: 30, coupler: 70, output: 60}},
    "p.json": {
      length_unit: "mm",
      pivots: {
        input_fixed: [0, 0],
        input_moving: [-20, 35],
        output_moving: [60, 85],
        output_fixed: [100, 0],
        point: [25, 110],
      },
    },
  };
  for (const [name, file] of Object.entries(files)) {
    await opened(page, {name, mimeType: "application/json", buffer: Buffer.from(JSON.stringify(file))});
    await page.getByTestId("export.title").click();
    for (const format of ["urdf", "mjcf", "json", "svg"]) {
      const [download] = await Promise.all([
        page.waitForEvent("download"),
        page.getByTestId(`export.${format}`).click(),
      ]);
      expect(download.suggestedFilename()).toMatch(/\.(urdf|xml|json|svg)$/);
    }
    await expect(page.getByTestId("export.step")).toContainText("linkwright export");
    await page.keyboard.press("Escape");
    await keep_screenshot(page, `given-${name[0]}`);
  }
});

test("a new task can be a linkage, and a reload keeps it", async ({page}) => {
  await opened(page);
  await page.getByTestId("bar.new").click();
  await page.getByTestId("new.linkage").click();
  await page.getByTestId("new.create").click();
  await expect
    .poll(() => read_state(page, ({hand, problem}) => problem.task.kind === "linkage" && hand?.drive !== null))
    .toBe(true);
  await page.getByTestId("linkage.pivots.point.x").fill("40");
  await page.keyboard.press("Enter");
  await page.reload();
  await expect(page.getByTestId("linkage.pivots.point.x")).toHaveValue("40");
  await expect(page.getByTestId("linkage.rate.point")).toContainText("mm/s²");
});
