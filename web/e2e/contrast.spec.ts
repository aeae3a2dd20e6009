// The system's own colours, and more contrast: what a colour tells is still told.
import type {Page} from "@playwright/test";
import {expect, keep_screenshot, open_workbench, test} from "./support";

const color = (page: Page, selector: string, property: string) =>
  page
    .locator(selector)
    .first()
    .evaluate((element, name) => getComputedStyle(element).getPropertyValue(name), property);

test("in forced colours swatches, chips, drive and crosshair are there, light and dark; more contrast is given", async ({
  page,
}) => {
  for (const theme of ["light", "dark"] as const) {
    await page.emulateMedia({forcedColors: "active", colorScheme: theme});
    await open_workbench(page);
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
    await keep_screenshot(page, `forced-colors-${theme}`);
  }
  await page.emulateMedia({forcedColors: "none", colorScheme: "light", contrast: "more"});
  await open_workbench(page);
  expect(await color(page, ".card", "border-top-color")).toBe("rgb(90, 100, 112)");
  await keep_screenshot(page, "more-contrast");
  await page.emulateMedia({contrast: "no-preference"});
});
