// Walk-through 23: how long work takes, on a page that has the machine to itself (playwright.config.ts). The figures are
// printed; what is asserted is the size of what is loaded. Never how long something takes.
import {readFileSync} from "node:fs";
import {createServer, type Server} from "node:http";
import type {AddressInfo} from "node:net";
import {join, resolve} from "node:path";
import {gzipSync} from "node:zlib";
import type {Page} from "@playwright/test";
import {
  drag,
  expect,
  file_menu,
  map_hash,
  map_pixel,
  middle_of,
  open_workbench,
  test,
  until_fine,
  until_ready,
  until_settled,
} from "./support";
import type {MotionTask} from "../src/kinds/motion/task";

test.use({fresh: true}); // what is timed is what a visitor waits for

const served = resolve(process.env.LINKWRIGHT_WEB ?? "../build/web");

function median(values: number[]): number {
  return [...values].sort((a, b) => a - b)[values.length >> 1]!;
}

test("the map follows a drag and a slider, the linkage the mouse over the map", async ({page}) => {
  await open_workbench(page);
  await until_fine(page);
  await test.step("the map follows a drag", async () => {
    const moves = await page.evaluate(async () => {
      const hook = globalThis.__linkwright!,
        workbench = hook.workbench as any,
        {maps} = workbench,
        take = maps.take.bind(maps);
      const found: {engine: number; round: number; paint: number; samples: number}[] = [];
      workbench.begin_gesture();
      for (let i = 0; i < 60; ++i) {
        const start = performance.now(),
          dx = 5 * Math.sin(i / 5),
          dy = 5 * Math.cos(i / 7);
        let arrived = start;
        maps.take = (...answer: unknown[]) => {
          arrived = performance.now();
          take(...answer);
        };
        workbench.drag((problem: any) => ({
          ...problem,
          task: {
            ...problem.task,
            poses: (problem.task as MotionTask).poses.map((pose: any, k: number) =>
              k === 2 ? {...pose, x: -220 + dx, y: 220 + dy} : pose,
            ),
          },
        }));
        while (!workbench.is_current || hook.painted_map() !== workbench.map)
          await new Promise((done) => setTimeout(done));
        found.push({
          engine: workbench.engine_ms,
          round: arrived - start,
          paint: workbench.paint_ms,
          samples: workbench.map.samples,
        });
      }
      delete maps.take;
      workbench.cancel_gesture();
      return found;
    });
    const engine = median(moves.map((m) => m.engine)),
      transfer = median(moves.map((m) => m.round - m.engine)),
      paint = median(moves.map((m) => m.paint));
    console.log(
      `drag, ${moves.filter((m) => m.samples === 400).length} of 60 frames at 400²: engine ${engine.toFixed(1)} ms, transfer ${transfer.toFixed(1)} ms, paint ${paint.toFixed(1)} ms, together ${median(moves.map((m) => m.round + m.paint)).toFixed(1)} ms (medians)`,
    );
  });
  await test.step("the linkage follows the mouse over the map", async () => {
    await until_fine(page);
    const session = await page.context().newCDPSession(page);
    await session.send("Performance.enable");
    const busy = async () => {
      const {metrics} = await session.send("Performance.getMetrics");
      return (
        1000 *
        metrics
          .filter(({name}) => ["ScriptDuration", "LayoutDuration", "RecalcStyleDuration"].includes(name))
          .reduce((sum, {value}) => sum + value, 0)
      );
    };
    const hash = await map_hash(page),
      before = await busy();
    const times = await page.evaluate(async () => {
      const {workbench} = globalThis.__linkwright!,
        map = document.querySelector("[data-testid='region.map']")!,
        box = map.getBoundingClientRect();
      const next_task = () =>
        new Promise<void>((done) => {
          const {port1, port2} = new MessageChannel();
          port1.onmessage = () => done();
          port2.postMessage(0);
        });
      const found: {engine: number; drawn: number}[] = [];
      for (let i = 0; i < 100; ++i) {
        await new Promise(requestAnimationFrame);
        map.dispatchEvent(
          new PointerEvent("pointermove", {
            clientX: box.x + box.width * (0.5 + 0.4 * Math.cos(i / 8)),
            clientY: box.y + box.height * (0.5 + 0.4 * Math.sin(i / 8)),
            bubbles: true,
            pointerType: "mouse",
            pointerId: 1,
          }),
        );
        await new Promise(requestAnimationFrame); // where the page takes it up
        const start = performance.now();
        while (!workbench.hovered || workbench.hand?.tau.join() !== workbench.hovered.join()) await next_task();
        const engine = performance.now() - start;
        await new Promise<void>((done) => void Promise.resolve().then(done)); // Svelte changes the page in a microtask
        void document.body.offsetHeight; // and the browser lays it out
        found.push({engine, drawn: performance.now() - start});
      }
      return found;
    });
    const work = ((await busy()) - before) / times.length;
    console.log(
      `hover: linkage there after ${median(times.map((t) => t.engine)).toFixed(1)} ms, laid out after ${median(times.map((t) => t.drawn)).toFixed(1)} ms (medians of 100); main thread ${work.toFixed(1)} ms each`,
    );
    expect(await map_hash(page), "hovering never repaints the map").toBe(hash);
  });
  await test.step("a requirement is tried by its slider", async () => {
    await until_fine(page);
    const times = await page.evaluate(async () => {
      const hook = globalThis.__linkwright!,
        {workbench} = hook,
        found: {whole: number; engine: number; paint: number}[] = [];
      workbench.begin_gesture();
      for (let i = 0; i < 40; ++i) {
        const start = performance.now();
        workbench.drag((problem) => ({
          ...problem,
          requirements: {...problem.requirements, min_transmission_angle_deg: 31 + i},
        }));
        while (!workbench.is_current || hook.painted_map() !== workbench.map)
          await new Promise((done) => setTimeout(done));
        found.push({whole: performance.now() - start, engine: workbench.engine_ms, paint: workbench.paint_ms});
      }
      workbench.cancel_gesture();
      return found;
    });
    console.log(
      `requirement slider: engine ${median(times.map((t) => t.engine)).toFixed(1)} ms, paint ${median(times.map((t) => t.paint)).toFixed(1)} ms, until painted ${median(times.map((t) => t.whole)).toFixed(1)} ms (medians of 40)`,
    );
  });
});

/** The time from one frame to the next while something is done. */
async function frame_times(page: Page, act: () => Promise<void>): Promise<string> {
  await page.evaluate(() => {
    const times: number[] = [],
      hook = globalThis as unknown as {spent?: number[]; watching?: boolean};
    [hook.spent, hook.watching] = [times, true];
    let before = performance.now();
    const frame = (now: number) => {
      times.push(now - before);
      before = now;
      if (hook.watching) requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  });
  await act();
  const times = await page.evaluate(() => {
    const hook = globalThis as unknown as {spent: number[]; watching: boolean};
    hook.watching = false;
    return hook.spent.toSorted((a, b) => a - b);
  });
  const at = (share: number) => times[Math.floor(share * (times.length - 1))]!.toFixed(1);
  return `median ${at(0.5)} ms, 95 % ${at(0.95)} ms of ${times.length} frames`;
}

test("the sphere follows a ring, the mouse over the map, and the drive", async ({page}) => {
  await open_workbench(page);
  await file_menu(page, "file.examples");
  await page.getByTestId("example.folding_wing").click();
  await expect(page.getByTestId("spherical.view")).not.toHaveAttribute("data-drawn", "0");
  await until_fine(page);
  await page.getByTestId("spherical.mark.3").click();
  const from = await middle_of(page.getByTestId("spherical.view.ring.z")),
    a = await map_pixel(page, [0.2, 0.3]),
    b = await map_pixel(page, [0.8, 0.7]);
  const ring = await frame_times(page, () => drag(page, from, {x: from.x + 24, y: from.y - 14}, 60));
  await until_fine(page);
  const hover = await frame_times(page, async () => {
    await page.mouse.move(a.x, a.y);
    await page.mouse.move(b.x, b.y, {steps: 60});
  });
  await page.mouse.move(0, 0);
  await page.getByTestId("num.best").click();
  await until_settled(page);
  await page.getByTestId("drive.play").click();
  const play = await frame_times(page, () => page.waitForTimeout(1500));
  console.log(`sphere, from frame to frame: ring ${ring}; hover ${hover}; play ${play}`);
});

/** What a first visit waits for, in bytes at most as it is sent, compressed. */
const parts = [
  {part: "page and its look", of: /\.(html|css|svg)$/, most: 25_000},
  {part: "engine, what a first minute runs", of: /\bfirst-[^/]*\.wasm$/, most: 475_000},
  {part: "scripts of the engine's workers", of: /\bworker-[^/]*\.js$/, most: 20_000},
  {part: "language in use", of: /\b(en|zh)-[^/]*\.js$/, most: 51_000},
  {part: "scripts of the page", of: /\.js$/, most: 290_000},
];
const visited_most = 835_000; // of all these: they are not at their bounds together
const rest_of_engine = /\brest-[^/]*\.wasm$/,
  rest_most = 1_520_000; // fetched at rest

const sum = (values: readonly number[]) => values.reduce((total, value) => total + value, 0);
const text_of = (file: string) => readFileSync(join(served, file));
const compressed_size = (files: readonly string[]) => sum(files.map((file) => gzipSync(text_of(file)).length));
const kB = (bytes: number) => `${(bytes / 1000).toFixed(0)} kB`;

test("what a first visit loads", async ({page}) => {
  const all: string[] = [];
  page.on("request", (request) => all.push(new URL(request.url()).pathname.slice(1) || "index.html"));
  const start = Date.now();
  await open_workbench(page);
  const ready = Date.now() - start;
  const first_paint = await page.evaluate(
    () => performance.getEntriesByName("first-contentful-paint")[0]?.startTime ?? NaN,
  );
  await until_fine(page);
  await expect.poll(() => all.some((file) => file.includes("ExportDialog"))).toBe(true); // what comes at rest has come
  const asked = [...new Set(all)],
    at = asked.findIndex((file) => rest_of_engine.test(file)),
    first = asked.slice(0, at),
    later = asked.slice(at + 1);
  const found = parts.map(({part, of, most}, i) => {
    const files = first.filter((file) => of.test(file) && !parts.slice(0, i).some((before) => before.of.test(file)));
    return {part, files, most, bytes: compressed_size(files)};
  });
  const bytes = sum(found.map((part) => part.bytes)),
    rest = compressed_size([asked[at]!]);
  for (const {part, bytes, files} of found) console.log(`first load: ${part}: ${files.length} files, ${kB(bytes)}`);
  console.log(
    `first load: together ${kB(bytes)} compressed; then the rest of the engine, ${kB(rest)}, and of the page, ${kB(compressed_size(later))}; first paint after ${first_paint.toFixed(0)} ms, engine ready after ${ready} ms`,
  );
  for (const {part, bytes, files, most} of found) {
    expect(files.length, part).toBeGreaterThan(0);
    expect(bytes, part).toBeLessThan(most);
  }
  expect(sum(found.map(({files}) => files.length))).toBe(first.length);
  expect(bytes).toBeLessThan(visited_most);
  expect(rest).toBeLessThan(rest_most);
  const files_of = (name: string) => found.find(({part}) => part === name)!.files;
  expect(files_of("language in use")).toHaveLength(1);
  for (const module of [parts[1]!.of, rest_of_engine]) expect(all.filter((file) => module.test(file))).toHaveLength(1); // for both workers
  for (const file of files_of("scripts of the page")) expect(text_of(file).includes("WebGLRenderer")).toBe(false);
});

/** The page as hosts send it: compressed. */
function start_host(): Promise<Server> {
  const types = {
    html: "text/html",
    js: "text/javascript",
    css: "text/css",
    wasm: "application/wasm",
    svg: "image/svg+xml",
  };
  const host = createServer(({url}, response) => {
    const path = new URL(url!, "http://host/").pathname.slice(1) || "index.html",
      type = types[path.split(".").at(-1) as keyof typeof types];
    response.writeHead(200, {"Content-Type": type, "Content-Encoding": "gzip"});
    response.end(gzipSync(readFileSync(join(served, path))));
  });
  return new Promise((resolve) => host.listen(0, "127.0.0.1", () => resolve(host)));
}

test("a first visit over a slow line", async ({page}) => {
  const host = await start_host(),
    session = await page.context().newCDPSession(page),
    bytes_a_second = 1.5e6 / 8;
  await session.send("Network.enable");
  await session.send("Network.emulateNetworkConditions", {
    offline: false,
    latency: 40,
    downloadThroughput: bytes_a_second,
    uploadThroughput: bytes_a_second,
  });
  const start = Date.now(),
    since = () => ((Date.now() - start) / 1000).toFixed(1);
  await page.goto(`http://127.0.0.1:${(host.address() as AddressInfo).port}/`);
  await page.getByTestId("region.map").waitFor();
  const drawn = since();
  await until_ready(page);
  console.log(`first load at 1.5 Mbit/s: the stored map after ${drawn} s, the engine's after ${since()} s`);
  host.close();
});
