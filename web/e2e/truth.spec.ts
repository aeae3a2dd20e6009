// What is shown belongs to the task that is shown, or it is greyed out, or a sentence stands in its place.
import {expect, open_workbench, read_state, test, until_settled} from "./support";

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
