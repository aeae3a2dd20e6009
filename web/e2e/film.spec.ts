// Films: one loop of the motion, MP4 and WebM, read back by the library that wrote them and played by the browser.
import {ALL_FORMATS, BufferSource, EncodedPacketSink, Input} from "mediabunny";
import {readFileSync} from "node:fs";
import type {BrowserContext, Page} from "@playwright/test";
import {expect, expect_accessible, open_workbench, read_state, test, until_settled} from "./support";

async function open_exports(page: Page): Promise<void> {
  await until_settled(page);
  await read_state(page, (workbench) => void (workbench.dialog = "export"));
  await expect(page.getByTestId("export.dialog")).toBeVisible();
}
async function film_of(page: Page, kind: "mp4" | "webm"): Promise<{name: string; bytes: Buffer}> {
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByTestId(`export.${kind}`).click()]);
  return {name: download.suggestedFilename(), bytes: readFileSync(await download.path())};
}
async function inside(bytes: Buffer) {
  using input = new Input({source: new BufferSource(new Uint8Array(bytes)), formats: ALL_FORMATS});
  const track = (await input.getPrimaryVideoTrack())!;
  let frames = 0;
  for await (const _ of new EncodedPacketSink(track).packets()) ++frames;
  return {
    frames,
    codec: await track.getCodec(),
    size: [await track.getDisplayWidth(), await track.getDisplayHeight()],
    seconds: await input.computeDuration(),
  };
}
/** What a browser shows of it after a second: its length, and how much of its far quarter is drawn on. */
async function played(context: BrowserContext, bytes: Buffer, type: string): Promise<{seconds: number; drawn: number}> {
  const page = await context.newPage();
  await page.goto("about:blank");
  const seen = await page.evaluate(
    async ([text, kind]) => {
      const video = document.createElement("video");
      video.muted = true;
      video.src = `data:${kind};base64,${text}`;
      await new Promise((resolve, reject) => {
        video.onloadeddata = resolve;
        video.onerror = () => reject(new Error(video.error?.message));
      });
      document.body.append(video);
      const shown = new Promise((resolve) => {
        const look: VideoFrameRequestCallback = (_, {mediaTime}) => {
          if (mediaTime > 0.9) resolve(null);
          else video.requestVideoFrameCallback(look);
        };
        video.requestVideoFrameCallback(look); // what was sought is shown a little later than it is found
      });
      video.currentTime = 1;
      await shown;
      const canvas = document.createElement("canvas"),
        {videoWidth: width, videoHeight: height} = video;
      [canvas.width, canvas.height] = [width, height];
      const pen = canvas.getContext("2d", {willReadFrequently: true})!;
      const share_drawn = () => {
        pen.drawImage(video, 0, 0);
        const {data} = pen.getImageData(width / 2, height / 2, width / 2, height / 2);
        let drawn = 0;
        for (let i = 0; i < data.length; i += 4) if (Math.abs((data[i] ?? 0) - (data[0] ?? 0)) > 40) ++drawn;
        return drawn / (data.length / 4);
      };
      return {seconds: video.duration, drawn: share_drawn()};
    },
    [bytes.toString("base64"), type] as const,
  );
  await page.close();
  return seen;
}

test("a film is one loop of five seconds, and plays; size and rate are chosen; one that is stopped leaves nothing", async ({
  page,
  context,
}) => {
  await open_workbench(page);
  await open_exports(page);
  await expect(page.getByTestId("export.webm")).toBeEnabled();
  await expect_accessible(page, "dialog");
  for (const [kind, codec] of [
    ["mp4", "avc"],
    ["webm", "vp9"],
  ] as const)
    await test.step(kind, async () => {
      await expect(page.getByTestId(`export.${kind}`)).toBeEnabled();
      const {name, bytes} = await film_of(page, kind);
      expect(name).toMatch(new RegExp(`^tailgate-hinge-.*\\.${kind}$`));
      expect(await inside(bytes)).toEqual({
        frames: 150,
        codec,
        size: [1280, 720],
        seconds: expect.closeTo(5, 1) as unknown,
      });
      const {seconds, drawn} = await played(context, bytes, `video/${kind}`);
      expect(seconds).toBeCloseTo(5, 1);
      expect(drawn, "of the lower right quarter").toBeGreaterThan(0.0005);
      await expect(page.getByTestId("export.status")).toContainText(name);
    });

  await test.step("size and frame rate are chosen", async () => {
    await page.getByTestId("export.film_size.480").click();
    await page.getByTestId("export.film_rate.24").click();
    expect(await inside((await film_of(page, "webm")).bytes)).toMatchObject({frames: 120, size: [640, 480]});
  });
  await test.step("a film that is stopped leaves nothing", async () => {
    let downloads = 0;
    page.on("download", () => ++downloads);
    await page.getByTestId("export.film_size.1080").click();
    await page.getByTestId("export.film_rate.60").click();
    await page.getByTestId("export.mp4").click();
    await page.getByTestId("export.stop").dispatchEvent("click");
    await expect(page.getByTestId("export.mp4")).toBeEnabled();
    await expect(page.getByTestId("export.status")).toHaveText("");
    expect(downloads).toBe(0);
  });
});
