import {linkage_types} from "../src/contract/messages";
import {expect, expect_accessible, keep_screenshot, open_workbench, read_state, solve, test} from "./support";

test("the page opens with the example solved, for everybody, under its strict policy", async ({page}) => {
  const [response] = await Promise.all([
    page.waitForResponse((answer) => new URL(answer.url()).pathname === "/"),
    open_workbench(page),
  ]);
  expect(response.headers()["content-security-policy"]).toContain("default-src 'self'");
  expect(await page.evaluate(() => crossOriginIsolated)).toBe(true);

  await expect(page).toHaveTitle(/Tailgate hinge/);
  const problem = await read_state(page, (workbench) => workbench.whole_problem);
  const {region, status} = solve(problem);
  expect(status).toBe("solved");
  await expect
    .poll(() => read_state(page, (workbench) => workbench.census?.types.reduce((sum, n) => sum + n, 0)))
    .toBeGreaterThan(0);
  const types = await read_state(page, (workbench) => workbench.census!.types);
  expect(types).toEqual(linkage_types.map((type) => region.counts[type] ?? 0));
  await expect_accessible(page);
  await keep_screenshot(page, "first-start");
});
