// The numbers of the linkage in hand, pins, and all panels at the sides.
import {readFileSync} from "node:fs";
import type {Page} from "@playwright/test";
import type {TauPair} from "../src/contract/messages";
import {
  example,
  expect,
  expect_accessible,
  keep_screenshot,
  open_settled,
  poses_of_page,
  read_state,
  solve,
  test,
  type_into,
  until_settled,
} from "./support";

test.beforeEach(({page}) => open_settled(page));

type Hooked = {__linkwright: {workbench: any; preferences: any}};

async function pick(page: Page, tau: TauPair): Promise<void> {
  await read_state(page, (workbench, to) => workbench.pick(to), tau);
  await page.waitForFunction(
    (to) => (globalThis as unknown as Hooked).__linkwright.workbench.picked_linkage?.tau.join() === to,
    tau.join(),
  );
}

test.describe("numbers", () => {
  test("are those of the program", async ({page}) => {
    const {linkages} = solve(example("tailgate"));
    for (const found of linkages.slice(0, 4)) {
      const tau: TauPair = [found.input.coordinate, found.output.coordinate];
      await pick(page, tau);
      const hand = await read_state(page, (workbench) => workbench.hand!);
      for (const link of ["ground", "input", "coupler", "output"] as const) {
        expect(hand.lengths![link] / found.lengths[link]).toBeCloseTo(1, 11);
        await expect(page.getByTestId(`num.${link}`)).toHaveText(`${found.lengths[link].toFixed(2)} mm`);
      }
      const angle = (value: number) => `${value.toFixed(1)}°`;
      await expect(page.getByTestId("num.min_task")).toHaveText(angle(found.min_transmission_angle_deg));
      await expect(page.getByTestId("num.ratio")).toHaveText(found.link_ratio.toFixed(2));
      await expect(page.getByTestId("num.sweep")).toHaveText(
        `${angle(found.driver_sweep_deg)} ${found.drive === "cw" ? "↻" : "↺"}`,
      );
      await expect(page.getByTestId("num.input_center")).toHaveText(
        found.input.center_point.map((v: number) => v.toFixed(1).replace("-", "−")).join(", "),
      );
      await expect(page.getByTestId("num.output_circle")).toHaveText(
        found.output.circle_point.map((v: number) => v.toFixed(1).replace("-", "−")).join(", "),
      );
      await expect(page.getByTestId("num.verdict")).toHaveText("✓ No defects, verified by simulation");
      await expect(page.getByTestId("num.verified")).toBeVisible();
      if (found.min_transmission_angle_full_turn_deg !== null)
        await expect(page.getByTestId("num.min_turn")).toHaveText(angle(found.min_transmission_angle_full_turn_deg));
      if (found.swapped.min_transmission_angle_deg !== null)
        await expect(page.getByTestId("num.swapped")).toContainText(
          `γ ${angle(found.swapped.min_transmission_angle_deg)}`,
        );
    }
  });

  test("say what fails, copy as a row, and are saved as DXF", async ({page, context}) => {
    await context.grantPermissions(["clipboard-read", "clipboard-write"]);
    await pick(page, [1.3125, 1.1125]);
    await expect(page.getByTestId("num.type")).toHaveText("Triple rocker, output longest");
    await expect(page.getByTestId("num.min_task")).toHaveText("73.5°");
    await page.getByTestId("num.copy_lengths").click();
    const row = (await page.evaluate(() => navigator.clipboard.readText())).split("\t").map(Number);
    [65.03, 211.05, 53.92, 255.9].forEach((length, i) => expect(row[i]).toBeCloseTo(length, 2));
    await page.getByTestId("num.copy.input_center").click();
    expect(
      (await page.evaluate(() => navigator.clipboard.readText()))
        .split("\t")
        .map(Number)
        .map((v) => v.toFixed(1)),
    ).toEqual(["179.0", "348.5"]);

    const [download] = await Promise.all([page.waitForEvent("download"), page.getByTestId("num.dxf").click()]);
    expect(download.suggestedFilename()).toMatch(/^tailgate-hinge.*\.dxf$/);
    expect(readFileSync(await download.path(), "utf8")).toContain("EOF");

    await type_into(page, "req.max_length", "250");
    await expect(page.getByTestId("toast.title")).toContainText(
      "no longer met the requirements; this is the best that does",
    );
    await expect(page.getByTestId("num.missed")).toHaveCount(0);
    await page.getByTestId("toast.state.keep_old").click();
    await until_settled(page);
    await expect(page.getByTestId("num.missed")).toHaveText("Not met: longest link (250 mm at most)");

    const defective = await read_state(page, (workbench) => {
      const {defects, type, input_tau, output_tau, samples} = workbench.map!;
      const cell = defects.findIndex((bits, i) => bits === 1 && type[i]! < 8);
      return [input_tau[Math.floor(cell / samples)], output_tau[cell % samples]] as [number, number];
    });
    await pick(page, defective);
    await expect(page.getByTestId("num.verdict")).toHaveText("✕ Order defect");
    await expect(page.getByTestId("num.reason")).toContainText(
      /Order defect: this linkage reaches the positions as [1-4](-[1-4]){3}\./,
    );
    await expect(page.getByTestId("num.min_task")).toHaveText("–");
    await expect(page.getByTestId("num.verified")).toHaveCount(0);
    await page.getByTestId("export.title").click();
    await expect(page.getByTestId("export.mind")).toContainText(
      /^Before you build it: Order defect: this linkage reaches the positions as /,
    );
  });
});

test.describe("pins", () => {
  test("are kept, named, shown, compared and taken away", async ({page}) => {
    const {linkages} = solve(example("tailgate"));
    const first: TauPair = [linkages[0].input.coordinate, linkages[0].output.coordinate];
    await pick(page, first);
    await page.getByTestId("pin.add").click();
    await pick(page, [1.3125, 1.1125]);
    await page.getByTestId("pin.add").click();
    await expect(page.getByTestId("pin.row.A")).toContainText("83.7°");
    await expect(page.getByTestId("pin.row.B")).toContainText("256");
    await page.getByTestId("pin.eye.A").click();
    expect(await read_state(page, (workbench) => workbench.pins.map((pin) => !!pin.shown))).toEqual([true, false]);
    await page.getByTestId("pin.menu.B").click();
    await page.getByTestId("pin.rename").click();
    await page.keyboard.type("A");
    await page.keyboard.press("Enter");
    await expect(page.getByText("There is a pin A already.")).toBeVisible();
    await page.getByTestId("pin.name").fill("Slim");
    await page.getByTestId("pin.note").fill("=clears the <b>cable</b>");
    await page.keyboard.press("Enter");
    await expect(page.getByTestId("pin.row.Slim")).toBeVisible();
    await expect(page.getByText("=clears the <b>cable</b>")).toBeVisible();
    await page.getByTestId("pin.pick.A").click();
    expect(await read_state(page, (workbench) => workbench.picked!.tau)).toEqual(first);

    await page.getByTestId("pin.compare").click();
    const dialog = page.getByTestId("pin.compare_dialog");
    await expect(dialog.getByRole("img")).toHaveCount(2);
    await expect(dialog.locator(".u-over")).toBeVisible();
    await expect(page.getByTestId("pin.value.min_transmission_angle_deg.A")).toHaveClass(/best/);
    await expect(page.getByTestId("pin.value.min_transmission_angle_deg.Slim")).toHaveText(/73\.5°\s*−10\.1°/);
    const order = () => dialog.getByTestId("pin.column").locator(".name").allInnerTexts();
    expect(await order()).toEqual(["A", "Slim"]);
    await page.getByTestId("pin.sort.ground").click();
    expect(await order()).toEqual(["Slim", "A"]); // 65 mm before 83 mm
    const links = () =>
      dialog.locator("path.link.input").evaluateAll((lines) => lines.map((line) => line.getAttribute("d")));
    const closed = await links();
    await page.getByTestId("pin.scrub").fill("2.5");
    expect((await links()).every((line, i) => line !== closed[i])).toBe(true); // one scrub moves both
    await expect_accessible(page, "[data-testid='pin.compare_dialog']");
    await keep_screenshot(page, "compare");
    const [download] = await Promise.all([page.waitForEvent("download"), page.getByTestId("pin.export_table").click()]);
    const table = readFileSync(await download.path(), "utf8")
      .split("\r\n")
      .map((line) => line.replace("\ufeff", "").split(","));
    expect(table[0]).toEqual(["Name", "Slim", "A"]);
    const longest = table.find((row) => row[0]!.startsWith("Longest link"))!;
    expect(Number(longest[2]) / linkages[0].lengths.input).toBeCloseTo(1, 9);
    expect(table.at(-2)![1]).toBe("'=clears the <b>cable</b>");
    await page.keyboard.press("Escape");
    await expect(dialog).toHaveCount(0);

    await page.getByTestId("pin.menu.Slim").click();
    await page.getByTestId("pin.delete").click();
    await expect(page.getByTestId("pin.row.Slim")).toHaveCount(0);
    await read_state(page, (workbench) => workbench.undo());
    await expect(page.getByTestId("pin.row.Slim")).toBeVisible();
  });

  test("remember the task in which they were pinned", async ({page}) => {
    await pick(page, [1.3125, 1.1125]);
    await page.getByTestId("pin.add").click();
    await type_into(page, "task.x.3", "-219.5");
    await expect(page.getByText("From an earlier task")).toBeVisible();
    await page.getByTestId("pin.bring_back.A").click();
    await until_settled(page);
    expect(await poses_of_page(page)).toEqual(example("tailgate").task.poses);
    expect(await read_state(page, (workbench) => workbench.hand!.tau)).toEqual([1.3125, 1.1125]);
    await expect(page.getByText("From an earlier task")).toHaveCount(0);
  });
});

test("the panels are accessible, light and dark; the status line switches snapping", async ({page}) => {
  await page.getByTestId("pin.add").click();
  for (const theme of ["light", "dark"]) {
    await page.evaluate((name) => ((globalThis as unknown as Hooked).__linkwright.preferences.theme = name), theme);
    await page.waitForFunction((name) => document.documentElement.dataset.theme === name, theme);
    for (const part of ["task.title", "req.title", "pin.title", "num.title"])
      await expect_accessible(page, `[data-testid='${part}']`);
    await expect_accessible(page, "footer");
  }
  await expect(page.getByTestId("status.tau")).toContainText("τ₁");
  await page.getByTestId("status.snap").click();
  await expect(page.getByTestId("status.snap")).toHaveText("snap off");
  expect(await page.evaluate(() => (globalThis as unknown as Hooked).__linkwright.preferences.snap)).toBe(false);
});
