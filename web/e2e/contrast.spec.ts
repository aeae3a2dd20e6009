// The system's own colours, and more contrast: what a colour tells is still told.
import type {Page} from "@playwright/test";
import {expect, keep_screenshot, open_workbench, read_state, set_theme, test} from "./support";

const color = (page: Page, selector: string, property: string) =>
  page
    .locator(selector)
    .first()
    .evaluate((element, name) => getComputedStyle(element).getPropertyValue(name), property);

const grounds = (page: Page, selector: string) =>
  page
    .locator(selector)
    .evaluateAll((elements) => elements.map((element) => getComputedStyle(element).backgroundColor));

test("what colours tell is told with more contrast, and in forced colours, light and dark", async ({page}) => {
  await page.emulateMedia({contrast: "more"});
  await open_workbench(page);
  await test.step("more contrast is given where it is asked for", async () => {
    expect(await color(page, ".card", "border-top-color")).toBe("rgb(90, 100, 112)");
    expect(await color(page, ".faint", "color")).toBe("rgb(44, 54, 64)");
    await keep_screenshot(page, "more-contrast");
  });

  const types = "[data-testid^='type.'] .swatch",
    double_crank = page.getByTestId("type.double_crank");
  for (const theme of ["light", "dark"] as const)
    await test.step(`in forced colours swatches, chips, drive and crosshair are there: ${theme}`, async () => {
      await page.emulateMedia({forcedColors: "active", colorScheme: theme, contrast: null});
      await set_theme(page, theme);
      const paper = await color(page, "body", "background-color");
      for (const seen of [
        ".numbers .swatch",
        ".track .rail",
        ".track .thumb",
        ".column.output, .column.input",
        ".transport .play",
      ])
        expect(await color(page, seen, "background-color"), seen).not.toBe(paper);
      expect(await color(page, ".chip", "border-top-width")).not.toBe("0px");
      const all = await grounds(page, types);
      expect(all).toHaveLength(8);
      expect(new Set([...all, paper]).size, "a colour for each type, none of them the paper's").toBe(9);
      await double_crank.click();
      await expect(double_crank.locator(".swatch")).toHaveCSS("background-color", /rgba\(.*, 0\)/);
      await keep_screenshot(page, `forced-colors-${theme}`);
      await double_crank.click();
    });

  await test.step("what is chosen, and how much of an error is whose", async () => {
    await page.emulateMedia({forcedColors: "active", colorScheme: "light"});
    await set_theme(page, "light");
    await page.getByTestId("task.x.2").focus();
    const badges = await grounds(page, ".badge");
    expect(new Set(badges).size, "the chosen position's number has a ground of its own").toBe(2);
    await page.getByTestId("pin.add").click();
    await expect(page.locator("tr.in_hand")).toHaveCSS("outline-style", "solid");

    await read_state(page, (workbench) =>
      workbench.edit((problem) => ({...problem, tolerances: {length: 0.5, limit: {position: 2}}})),
    );
    await page.getByTestId("tolerances.tab").click();
    await expect(page.getByTestId("study.shares")).toBeVisible();
    const paper = await color(page, "body", "background-color"),
      shares = await grounds(page, "[data-testid='study.shares'] .bar");
    expect(shares.length).toBeGreaterThan(1);
    expect(shares).not.toContain(paper);
    await keep_screenshot(page, "forced-colors-tolerances");
  });
});
