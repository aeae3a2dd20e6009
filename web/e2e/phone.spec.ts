// The page on a phone (walk-through 22).
import type {Page} from "@playwright/test";
import {tau_at} from "../src/engine/axis";
import {
  example,
  expect,
  expect_accessible,
  keep_screenshot,
  map_pixel,
  open_workbench,
  read_state,
  shown,
  test,
  until_settled,
} from "./support";

test.use({viewport: {width: 390, height: 844}, hasTouch: true, isMobile: true});

/** Controls with less than 44 px in one direction, the drawing's handles apart (they have a reach of their own). */
function small_controls(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const all = [
      ...document.querySelectorAll<HTMLElement>(
        "button, a[href], input, select, summary, [role=tab], [role=slider], [role=menuitem]",
      ),
    ];
    const shown = all.filter(
      (element) =>
        element.checkVisibility({visibilityProperty: true, opacityProperty: true}) && !element.closest("svg, .unseen"),
    );
    const reach = (element: HTMLElement) => (element.closest("label") ?? element).getBoundingClientRect();
    return shown
      .filter((element) => {
        const box = reach(element),
          own = element.getBoundingClientRect();
        return own.width > 0 && (Math.max(box.width, own.width) < 43.5 || Math.max(box.height, own.height) < 43.5);
      })
      .map(
        (element) =>
          `${element.tagName} ${element.dataset.testid ?? element.ariaLabel ?? element.textContent} ${JSON.stringify(reach(element))}`,
      );
  });
}
const sideways = (page: Page) => page.evaluate(() => document.documentElement.scrollWidth - innerWidth);

test("drawing and map are in sight together, every control has room for a finger, which picks above itself", async ({
  page,
}) => {
  await open_workbench(page);
  await shown(page);
  for (const place of ["drawing.canvas", "region.map", "drive.title"]) {
    const box = (await page.getByTestId(place).boundingBox())!;
    expect(box.x, place).toBeGreaterThanOrEqual(-1);
    expect(box.x + box.width, place).toBeLessThanOrEqual(391);
    expect(box.y + box.height, place).toBeLessThanOrEqual(844);
    expect(Math.min(box.width, box.height), place).toBeGreaterThan(40);
  }
  expect(await sideways(page)).toBe(0);
  expect(await small_controls(page)).toEqual([]);
  await expect_accessible(page);
  await keep_screenshot(page, "phone");

  // What the colours mean, and how many there are.
  await expect(page.getByTestId("chip.title")).toHaveText("25\u202f608 left");
  await expect(page.getByTestId("type.double_crank")).toBeInViewport();

  const play = (await page.getByTestId("drive.title").boundingBox())!;
  for (const tab of ["tab.task", "tab.limits", "tab.numbers", "tab.pins"]) {
    await page.getByTestId(tab).tap();
    const sheet = (await page.locator("aside.sheet").boundingBox())!;
    expect(sheet.y, tab).toBeGreaterThanOrEqual(play.y + play.height - 1); // it covers the map, not the drawing and not Play
    expect(await sideways(page), tab).toBe(0);
    expect(await small_controls(page), tab).toEqual([]);
  }
  await page.getByTestId("tab.map").tap();
  await expect(page.locator("aside.sheet")).toHaveCount(0);
  await page.getByTestId("file.menu").tap();
  expect(await small_controls(page)).toEqual([]);
  await page.keyboard.press("Escape");

  // A finger on the map looks 56 px above itself, and picks there.
  const aim = await map_pixel(page, [0.7, 0.3]);
  const session = await page.context().newCDPSession(page);
  const touch = (type: string, points: {x: number; y: number}[]) =>
    session.send("Input.dispatchTouchEvent", {type: type as "touchStart", touchPoints: points});
  await touch("touchStart", [{x: aim.x - 30, y: aim.y + 30}]);
  await touch("touchMove", [{x: aim.x - 10, y: aim.y + 50}]);
  await touch("touchMove", [{x: aim.x, y: aim.y + 56}]);
  const axis = await read_state(page, (workbench) => workbench.task!.axes.input),
    aimed_at = [tau_at(axis, 0.7)!, tau_at(axis, 0.3)!] as const;
  const off = (of: "hovered" | "picked") =>
    read_state(
      page,
      ({hovered, picked}, [which, [a, b]]) => {
        const tau = which === "hovered" ? hovered : picked!.tau;
        return tau ? Math.hypot(tau[0] - a, tau[1] - b) : Infinity;
      },
      [of, aimed_at] as const,
    );
  await expect.poll(() => off("hovered")).toBeLessThan(0.02);
  await touch("touchEnd", []);
  await expect.poll(() => off("picked")).toBeLessThan(0.02);
  expect(await read_state(page, (workbench) => workbench.hovered)).toBeNull();
});

test("on its side, drawing and map stand beside each other; on the smallest phone below, and the title is whole", async ({
  page,
}) => {
  await page.setViewportSize({width: 844, height: 390});
  await open_workbench(page);
  const drawing = (await page.getByTestId("drawing.canvas").boundingBox())!,
    map = (await page.getByTestId("region.map").boundingBox())!;
  expect(drawing.x + drawing.width).toBeLessThanOrEqual(map.x);
  expect(map.y + map.height).toBeLessThanOrEqual(390);
  expect(await sideways(page)).toBe(0);
  await keep_screenshot(page, "phone-landscape");

  await page.setViewportSize({width: 320, height: 568});
  await shown(page);
  const box = async (name: string) => (await page.getByTestId(name).first().boundingBox())!;
  const [small_drawing, drive, play, small_map] = await Promise.all(
    ["drawing.canvas", "drive.title", "drive.play", "region.map"].map(box),
  );
  expect(small_drawing!.height).toBeGreaterThan(100);
  expect(small_drawing!.y + small_drawing!.height).toBeLessThanOrEqual(drive!.y + 1);
  expect(play!.y + play!.height).toBeLessThanOrEqual(drive!.y + drive!.height + 1);
  expect(drive!.y + drive!.height).toBeLessThanOrEqual(small_map!.y);
  const top = await page
    .locator("h2, header h1")
    .evaluateAll((all) =>
      all
        .filter((one) => one.checkVisibility() && one.scrollWidth > one.clientWidth + 1 && !one.matches(".unseen"))
        .map((one) => one.textContent),
    );
  expect(top).toEqual([]);
  expect(await sideways(page)).toBe(0);
  await keep_screenshot(page, "phone-320");
});

test("other kinds: positions in Chinese in the dark, a line with its magnifier, a sphere whose links are taken", async ({
  page,
}) => {
  await open_workbench(page);
  const open_example = async (name: string) => {
    await read_state(
      page,
      (workbench, problem) => {
        workbench.tour = null; // its hint lies over the drawing
        workbench.open(problem);
      },
      example(name),
    );
    await until_settled(page);
  };
  await test.step("three and five positions in Chinese in the dark", async () => {
    await page.evaluate(() => Object.assign(globalThis.__linkwright!.preferences, {language: "zh", theme: "dark"}));
    for (const name of ["latch", "nose_gear"]) {
      await open_example(name);
      await read_state(page, (workbench) => void (workbench.sheet = "task"));
      await expect(page.getByTestId("task.kind")).toHaveText(/四杆机构/);
      await expect_accessible(page);
      const small = await page
        .locator("button:visible")
        .evaluateAll((buttons) =>
          buttons
            .filter((b) => b.getBoundingClientRect().height < 43.5 && !b.closest("svg"))
            .map((b) => b.outerHTML.slice(0, 100)),
        );
      expect(small).toEqual([]);
      await keep_screenshot(page, `phone-${name}`);
      await read_state(page, (workbench) => void (workbench.sheet = null));
      expect(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth)).toBe(true);
    }
    await page.evaluate(() => Object.assign(globalThis.__linkwright!.preferences, {language: "en", theme: "light"}));
  });

  await test.step("line and map are both there, and the magnifier opens", async () => {
    await open_example("straight_luffing_crane");
    await expect(page.getByTestId("straight.line")).toBeAttached();
    const head = page.getByTestId("straight.magnifier_open");
    expect((await head.boundingBox())!.height).toBeGreaterThanOrEqual(44);
    await head.tap();
    await expect(page.getByTestId("straight.stretch_value")).toContainText("×");
    expect(await sideways(page)).toBeLessThanOrEqual(0);
    await keep_screenshot(page, "straight_line_phone");
  });

  await test.step("sphere and map are in sight together, and its links are taken", async () => {
    await open_example("folding_wing");
    for (const place of ["spherical.stage", "region.map"]) {
      const box = (await page.getByTestId(place).boundingBox())!;
      expect(box.x, place).toBeGreaterThanOrEqual(-1);
      expect(box.x + box.width, place).toBeLessThanOrEqual(391);
      expect(box.height, place).toBeGreaterThan(150);
    }
    await page.getByTestId("tab.numbers").click();
    const [download] = await Promise.all([page.waitForEvent("download"), page.getByTestId("num.stl").click()]);
    expect(download.suggestedFilename()).toMatch(/\.stl$/);
  });
});

test("tolerances have targets for fingers and a place in the line; card and plot stand on the sheet of the numbers", async ({
  page,
}) => {
  await open_workbench(page);
  await read_state(page, (workbench) => {
    workbench.edit((problem) => ({
      ...problem,
      tolerances: {length: 0.5, limit: {position: 2}, cost: {exponent: 1}},
    }));
    workbench.sheet = "limits";
  });
  await page.getByTestId("tolerance.each").click();
  const low = await page
    .locator("[data-testid='tolerance.row'] :is(button, input, select):not(.unseen)")
    .evaluateAll((all) =>
      all.filter((one) => one.getBoundingClientRect().height < 43.5).map((one) => one.outerHTML.slice(0, 80)),
    );
  expect(low).toEqual([]);
  await page.evaluate(() => (globalThis.__linkwright!.preferences.colour_by = "tolerance_error"));
  await expect(page.getByTestId("region.upper_end")).toHaveCount(1);
  expect(await page.evaluate(() => document.querySelector(".app")!.scrollWidth)).toBe(390);
  await until_settled(page);
  await expect(page.getByTestId("num.line_analysis")).toContainText("mm");

  await page.getByTestId("tab.numbers").click();
  await page.getByTestId("tolerances.tab").click();
  await expect(page.getByTestId("study.error")).toBeVisible();
  const bar = page.getByTestId("study.bar_output");
  await bar.scrollIntoViewIfNeeded();
  expect((await bar.boundingBox())!.height).toBeGreaterThanOrEqual(44);
  await page.getByTestId("front.tab").click();
  await expect(page.getByTestId("front.plot")).toBeVisible();
  expect(await sideways(page)).toBeLessThanOrEqual(0);
});
