// The built page in Firefox, as `linkwright studio` serves it: opens, follows a drag, keeps work, exports. Chromium has the
// long tests (e2e); here is what other engines do in their own way. Firefox is driven by WebDriver BiDi.
import assert from "node:assert/strict";
import {spawn} from "node:child_process";
import {mkdtempSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {after, before, test} from "node:test";
import {ALL_FORMATS, BufferSource, EncodedPacketSink, Input} from "mediabunny";
import puppeteer from "puppeteer-core";

const port = Number(process.env.LINKWRIGHT_PORT ?? 4189),
  program = process.env.LINKWRIGHT_CLI ?? "../build/release/bin/linkwright",
  web = process.env.LINKWRIGHT_WEB ?? "../build/web",
  executablePath = process.env.FIREFOX ?? "/usr/bin/firefox-esr";
const folder = mkdtempSync(join(tmpdir(), "linkwright-firefox-")),
  downloads = join(folder, "downloads"),
  patience = {timeout: 600_000};
let server, browser, page;
const complaints = [];

before(async () => {
  server = spawn(program, ["studio", "--port", String(port), "--folder", web], {stdio: "ignore"});
  browser = await puppeteer.launch({
    browser: "firefox",
    executablePath,
    headless: true,
    timeout: 1_200_000,
    extraPrefsFirefox: {
      "browser.download.folderList": 2,
      "browser.download.dir": downloads,
      "browser.download.alwaysOpenPanel": false,
      "intl.accept_languages": "en-GB",
    },
  });
  page = await browser.newPage();
  await page.setViewport({width: 1440, height: 900});
  page.on("console", (message) => {
    if (message.type() === "error") complaints.push(message.text());
  });
  page.on("pageerror", (error) => complaints.push(String(error)));
});
after(async () => {
  await browser?.close();
  server?.kill();
  rmSync(folder, {recursive: true, force: true});
});

const testid = (name) => `[data-testid="${name}"]`;
/** What `read` finds in the page's state. */
const state = (read) => page.evaluate(`(${read})(globalThis.__linkwright)`);
const until = (holds) => page.waitForFunction(`(${holds})(globalThis.__linkwright)`, patience);
const until_ready = () => until((hook) => hook?.ready === true && hook.painted_map() === hook.workbench.map);
const until_settled = () =>
  until(({workbench}) => {
    const {is_current, hand, tau_in_hand, linkages} = workbench;
    return is_current && !linkages.seeking_best && hand?.drive && hand.tau.join() === tau_in_hand?.join();
  });
async function middle_of(selector) {
  const {x, y, width, height} = await (await page.waitForSelector(selector, patience)).boundingBox();
  return {x: x + width / 2, y: y + height / 2};
}
async function open() {
  for (let left = 500; ; --left)
    try {
      await page.goto(`http://127.0.0.1:${port}/`);
      break;
    } catch (error) {
      if (left === 0) throw error; // the server may still be starting
      await new Promise((resolve) => setTimeout(resolve, 200));
    }
}
async function exported(format) {
  const known = new Set(files());
  await page.click(testid(`export.${format}`));
  for (let left = 3000; left > 0; --left) {
    const name = files().find((file) => !known.has(file));
    if (name) return {name, bytes: readFileSync(join(downloads, name))};
    await new Promise((resolve) => setTimeout(resolve, 200));
  }
  throw new Error(`no file of ${format} came`);
}
/** Those that are complete: Firefox makes the folder with the first file, and an empty file beside the part that it fills. */
function files() {
  try {
    const all = readdirSync(downloads);
    if (all.some((name) => name.endsWith(".part"))) return [];
    return all.filter((name) => statSync(join(downloads, name)).size > 0);
  } catch {
    return [];
  }
}

test("the page opens, and its map is painted", async () => {
  await open();
  await page.evaluate(() => localStorage.setItem("linkwright.preferences", '{"toured": true}'));
  await page.reload();
  await until_ready();
  await until_settled();
  const colors = await page.evaluate(() => {
    const canvas = [...document.querySelectorAll("canvas")].sort((a, b) => b.width * b.height - a.width * a.height)[0];
    const copy = new OffscreenCanvas(canvas.width, canvas.height),
      pen = copy.getContext("2d");
    pen.drawImage(canvas, 0, 0);
    return new Set(new Uint32Array(pen.getImageData(0, 0, copy.width, copy.height).data.buffer)).size;
  });
  assert.ok(colors > 5, `the map has ${colors} colours`);
});

test("a position follows the mouse, and the answer follows the position", async () => {
  const read = ({workbench}) => ({
    pose: workbench.problem.task.poses[1],
    census: JSON.stringify(workbench.census),
    map: globalThis.__linkwright.map_hash(),
  });
  const first = await state(read),
    {x, y} = await middle_of(testid("drawing.disc_2"));
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 40, y - 25, {steps: 8});
  await page.mouse.up();
  await until_settled();
  await until(({workbench, painted_map}) => workbench.census !== null && painted_map() === workbench.map);
  const then = await state(read);
  assert.notDeepEqual(then.pose, first.pose);
  assert.notEqual(then.census, first.census);
  assert.notEqual(then.map, first.map);
});

test("the work is there after a reload", async () => {
  const pose = await state(({workbench}) => workbench.problem.task.poses[1]);
  await page.waitForNetworkIdle({idleTime: 1500, ...patience}); // a page that goes complains of what it was still fetching
  await page.reload();
  await until_ready();
  await until_settled();
  assert.deepEqual(await state(({workbench}) => workbench.problem.task.poses[1]), pose);
  assert.equal(await state(({workbench}) => workbench.can_undo), true);
});

test("a linkage is exported: JSON, SVG, PNG", async () => {
  await page.evaluate(() => void (globalThis.__linkwright.workbench.dialog = "export"));
  const {input, output} = await state(({workbench}) => JSON.parse(JSON.stringify(workbench.picked_linkage)));
  const {name, bytes} = await exported("json");
  assert.match(name, /\.json$/);
  const {linkage} = JSON.parse(bytes.toString());
  for (const [told, shown] of [
    [linkage.input.center_point, input.center],
    [linkage.input.circle_point, input.circle],
    [linkage.output.center_point, output.center],
    [linkage.output.circle_point, output.circle],
  ])
    told.forEach((value, i) => assert.ok(Math.abs(value - shown[i]) < 1e-6 * (1 + Math.abs(value))));
  assert.match((await exported("svg")).bytes.toString(), /<svg /);
  assert.equal((await exported("png")).bytes.subarray(1, 4).toString(), "PNG");
});

for (const kind of ["mp4", "webm"])
  test(`a film (${kind}) is one loop, or the reason is told why there is none`, async (context) => {
    const row = testid(`export.${kind}`);
    await page.waitForFunction(
      (button) => !button.disabled || /encode/.test(button.textContent),
      patience,
      await page.$(row),
    );
    if (await page.$eval(row, (button) => button.disabled)) return context.diagnostic("not offered");
    for (const choice of ["export.film_size.480", "export.film_rate.24"]) {
      const button = await page.waitForSelector(testid(choice), patience);
      await button.evaluate((element) => element.scrollIntoView({block: "center"})); // the status line lies over the end
      await button.click();
      await page.waitForSelector(`${testid(choice)}[aria-pressed="true"]`, patience);
    }
    const {bytes} = await exported(kind),
      input = new Input({source: new BufferSource(new Uint8Array(bytes)), formats: ALL_FORMATS}),
      track = await input.getPrimaryVideoTrack();
    let frames = 0;
    for await (const _ of new EncodedPacketSink(track).packets()) ++frames;
    assert.equal(frames, 120);
    assert.ok(Math.abs((await input.computeDuration()) - 5) < 0.1);
    context.diagnostic(await track.getCodec());
  });

test("an outline comes out of a drawing of several shapes", async () => {
  const drawing = join(folder, "plate.svg");
  writeFileSync(
    drawing,
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 210 297"><rect width="210" height="297"/>' +
      '<g transform="translate(20 20)"><path d="M0 0h80a20 20 0 0 1 20 20v30h-100z"/></g></svg>',
  );
  await page.keyboard.press("Escape"); // the export dialog
  await page.click(testid("drawing.tools"));
  await (await page.$$(testid("task.outline"))).at(-1).click();
  const chooser = await page.waitForSelector('input[type="file"][accept*=".dxf"]');
  await chooser.uploadFile(drawing);
  await page.waitForSelector(testid("outline.choice"), patience);
  assert.equal((await page.$$('[role="radiogroup"] input')).length, 2);
  await page.click(testid("outline.use"));
  await until(({workbench}) => workbench.problem.view?.outline?.length > 6);
  const xs = await state(({workbench}) => workbench.problem.view.outline.map(([x]) => x));
  assert.ok(Math.abs(Math.max(...xs) - Math.min(...xs) - 100) < 1e-6);
});

test("3-D view, dialogs, the other language and a phone's width", async () => {
  await page.click(testid("drawing.done"));
  await page.click(testid("view.solid"));
  await page.waitForSelector(`.solid canvas, ${testid("toast.title")}`, patience); // or says that there is no WebGL here
  await page.click(testid("view.flat"));
  for (const dialog of ["examples", "keys", "new"]) {
    await page.evaluate((name) => void (globalThis.__linkwright.workbench.dialog = name), dialog);
    await page.waitForSelector("dialog[open]", patience);
    await page.keyboard.press("Escape");
    await page.waitForFunction(() => !document.querySelector("dialog[open]"), patience);
  }
  await page.evaluate(() => void (globalThis.__linkwright.preferences.language = "zh"));
  await page.waitForFunction(() => document.documentElement.lang === "zh-CN", patience);
  await page.setViewport({width: 390, height: 844});
  await page.waitForSelector(".app.phone", patience);
});

test("the browser had nothing to complain of", () => assert.deepEqual(complaints, []));
