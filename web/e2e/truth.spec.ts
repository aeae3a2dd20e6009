// What is shown belongs to the task that is shown, or it is greyed out, or a sentence stands in its place.
import type {Page} from "@playwright/test";
import type {Problem} from "../src/state/problem";
import type {MotionTask} from "../src/tasks/motion/task";
import {
  example,
  expect,
  keep_screenshot,
  open_workbench,
  read_state,
  shown,
  test,
  until_ready,
  until_settled,
} from "./support";

const five: Problem = {
  linkwright: 1,
  title: "Five",
  length_unit: "mm",
  task: {
    kind: "motion",
    mechanism: "four_bar",
    poses: [
      [0, 0, 0],
      [100, 0, 40],
      [20, 90, -30],
      [-140, 50, 100],
      [60, -130, 10],
    ].map(([x, y, theta_deg]) => ({x: x!, y: y!, theta_deg: theta_deg!})),
  },
};
async function expect_no_linkage(page: Page): Promise<void> {
  await page.waitForFunction(() => {
    const {is_current, task} = globalThis.__linkwright!.workbench;
    return is_current && task !== null && task.status !== "solved";
  });
  await expect(page.getByTestId("num.none")).toHaveText("This task has no linkage; the solution region says why.");
  await expect(page.getByTestId("region.notice")).toBeVisible();
  for (const gone of ["num.verified", "num.verdict", "chip.title", "region.ring", "status.tau"])
    await expect(page.getByTestId(gone)).toHaveCount(0);
  await expect(page.getByTestId("drive.play")).toBeDisabled();
}

test("a task without a linkage shows none: no numbers, no verdict, no counts of the one before", async ({page}) => {
  await open_workbench(page);
  await expect(page.getByTestId("num.verified")).toBeVisible();
  await read_state(page, (workbench, problem) => workbench.open(problem), five);
  await expect_no_linkage(page);
  await page.getByTestId("edit.undo").click();
  await until_settled(page);
  await expect(page.getByTestId("num.verified")).toBeVisible();

  const three = example("footrest");
  await read_state(page, (workbench, problem) => workbench.open(problem), {
    ...three,
    task: {...three.task, given: {side_length: 60}},
  });
  await until_settled(page);
  await expect(page.getByTestId("num.verdict")).toBeVisible();
  await page.getByTestId("given.length_input").fill("5");
  await page.keyboard.press("Enter");
  await expect_no_linkage(page);
  await expect(page.getByTestId("region.notice")).toContainText("No input link of length 5 satisfies the positions");
  await keep_screenshot(page, "no-linkage");
  await page.getByTestId("edit.undo").click();
  await until_settled(page);
  await expect(page.getByTestId("num.verdict")).toBeVisible();
});

test("a part that cannot be drawn says so, with ways on; the others go on", async ({page, complaints}) => {
  await open_workbench(page);
  await read_state(page, (workbench) => workbench.edit((problem) => ({...problem, title: "Before the mistake"})));
  await shown(page); // nothing more comes by itself
  await expect(page.getByTestId("num.verified")).toBeVisible();
  await read_state(page, (workbench) => {
    workbench.answers.take_hand(
      {...workbench.hand!, lengths: {} as never, dead_points_deg: null as never},
      workbench.problem,
    );
  });
  const failed = page.getByTestId("failed.num.title");
  await expect(failed).toContainText("“Numbers” could not be drawn");
  await expect(page.getByTestId("num.verdict")).toHaveCount(0);
  await expect(page.getByTestId("task.x.1")).toBeVisible();
  await keep_screenshot(page, "not-drawn");
  await failed.getByTestId("failed.again").click();
  await expect(failed).toBeVisible(); // it is as it was
  await failed.getByTestId("failed.undo").click();
  await until_ready(page);
  await expect(page.getByTestId("num.verified")).toBeVisible();
  await expect(failed).toHaveCount(0);
  complaints.expect_and_forget(/TypeError/);
});

test("every canvas has the pixels of its place, at five sizes and two pixel ratios", async ({page}) => {
  const sizes = [
    [1366, 768],
    [1440, 900],
    [1280, 720],
    [1024, 768],
    [390, 844],
  ] as const;
  await page.setViewportSize({width: sizes[0][0], height: sizes[0][1]}); // where the map is as wide as a canvas is from the start
  await open_workbench(page);
  await until_settled(page);
  const misfits = () =>
    page.evaluate(() =>
      [...document.querySelectorAll("canvas")].flatMap((canvas) => {
        const {width, height} = canvas.getBoundingClientRect(),
          off = (pixels: number, length: number) => Math.abs(pixels - length * devicePixelRatio) > 1;
        const place = `${canvas.className} in ${canvas.parentElement!.className} at ${innerWidth} × ${innerHeight} × ${devicePixelRatio}`;
        if (canvas.classList.contains("faded")) return [`${place}: not drawn yet`];
        return width > 0 && (off(canvas.width, width) || off(canvas.height, height))
          ? [`${place}: ${canvas.width} × ${canvas.height} for ${width} × ${height}`]
          : [];
      }),
    );
  await expect(page.locator(".map canvas")).toHaveCount(2);
  const session = await page.context().newCDPSession(page);
  const check = async (width: number, height: number, deviceScaleFactor: number) => {
    await session.send("Emulation.setDeviceMetricsOverride", {width, height, deviceScaleFactor, mobile: false});
    await page.waitForFunction((ratio) => devicePixelRatio === ratio, deviceScaleFactor);
    await expect.poll(misfits).toEqual([]);
  };
  for (const ratio of [1, 2]) for (const [width, height] of sizes) await check(width, height, ratio);
  await read_state(page, (workbench) => void (workbench.solid = true));
  await expect(page.locator(".solid canvas")).toBeVisible();
  await check(1024, 768, 2);
  await check(1366, 768, 1);
  await session.detach();
});

test("what was typed stays until it is valid or taken back, and no number moves by itself", async ({page}) => {
  await open_workbench(page);
  await until_settled(page);
  const field = (id: string) => page.getByTestId(id),
    type = async (id: string, text: string, key = "Enter") => {
      await field(id).fill(text);
      await page.keyboard.press(key);
    };
  const box = () => read_state(page, (workbench) => workbench.problem.requirements!.ground_pivots_within!.x),
    sentence = field("req.row.ground_pivots_within").locator(".fault");
  await type("req.ground_box.x0", "500", "Tab");
  await expect(field("req.ground_box.x0")).toHaveValue("500");
  await expect(field("req.ground_box.x0")).toHaveAttribute("aria-invalid", "true");
  await expect(sentence).toContainText("“from” is above “to”");
  expect(await box()).toEqual([70, 430]);
  await type("req.ground_box.x1", "600");
  await expect(sentence).toHaveCount(0);
  expect(await box()).toEqual([500, 600]);
  await field("edit.undo").click();
  expect(await box()).toEqual([70, 430]);
  await expect(field("req.ground_box.x0")).toHaveValue("70");
  await type("req.ground_box.x1", "60");
  await expect(sentence).toBeVisible();
  await page.keyboard.press("Escape");
  await expect(field("req.ground_box.x1")).toHaveValue("430");
  await expect(sentence).toHaveCount(0);

  await type("task.y.3", "75");
  await type("task.theta_deg.3", "-25");
  await until_settled(page);
  await type("task.x.3", "-125"); // now as position 2
  await expect(field("task.fault").first()).toBeVisible();
  await expect(field("task.x.3")).toHaveValue("-125");
  const x = () => read_state(page, (workbench) => (workbench.problem.task as MotionTask).poses[2]!.x);
  expect(await x()).toBe(-220);
  await read_state(page, (workbench) => workbench.zoom({input: [0, 0.5], output: [0, 0.5]})); // another answer of the engine
  await until_settled(page);
  await expect(field("task.x.3")).toHaveValue("-125");
  await expect(field("task.fault").first()).toBeVisible();
  await field("task.x.3").press("Escape");
  await expect(field("task.x.3")).toHaveValue("-220");
  await expect(field("task.fault")).toHaveCount(0);
});
