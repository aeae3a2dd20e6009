// What the browser tests share: a page that must not complain, the page's state, and the program to compare with.
import {test as base, expect, type BrowserContext, type Locator, type Page} from "@playwright/test";
import {mkdirSync, readFileSync} from "node:fs";
import {createRequire} from "node:module";
import {join} from "node:path";
import type {TauPair} from "../src/contract/messages";
import type {Pose} from "../src/state/task";
import type {Preferences} from "../src/state/preferences.svelte";
import type {Workbench} from "../src/state/workbench.svelte";
import type {MotionTask} from "../src/kinds/motion/task";
import {root} from "../tests/program";

export * from "../tests/program";
const screenshots = join(root, "build/web-screenshots");

/** Where the page says what it holds (App.svelte, region/MapCanvas.svelte, solid/SolidView.svelte). */
interface Hook {
  workbench: Workbench;
  preferences: Preferences;
  ready: boolean;
  map_hash(): string;
  painted_map(): unknown;
  map_point(place: TauPair): Pixel;
  solid_pixel(pivot: {side: "input" | "output"; end: "center" | "circle"}): [number, number];
}
declare global {
  var __linkwright: Hook | undefined;
}

// What Chromium says of drawing without a graphics card, and of requests that a reload cut short.
const harmless = /^\[\.WebGL-|GPU stall|software WebGL/;
const cut_short = "net::ERR_ABORTED";

/** What a page complained of. A test that expects complaints takes them out. */
export class Complaints {
  readonly all: string[] = [];

  constructor(page: Page) {
    page.on("console", (message) => {
      if (/^(error|warning)$/.test(message.type()) && !harmless.test(message.text()))
        this.all.push(`${message.type()}: ${message.text()}`);
    });
    page.on("pageerror", (error) => this.all.push(`exception: ${error.stack ?? error.message}`));
    page.on("crash", () => this.all.push("the page crashed"));
    page.on("requestfailed", (request) => {
      const reason = request.failure()?.errorText;
      if (reason !== cut_short) this.all.push(`request failed: ${request.url()} ${reason}`);
    });
  }
  /** Removes the complaints that were expected; there must be some. */
  expect_and_forget(pattern: RegExp): void {
    const left = this.all.filter((complaint) => !pattern.test(complaint));
    expect(left.length, `a complaint like ${pattern}`).toBeLessThan(this.all.length);
    this.all.splice(0, this.all.length, ...left);
  }
}

/** So many times slower than it is, each page computes: LINKWRIGHT_THROTTLE=4 shows what is waited for and what by luck is there. */
const times_slower = Number(process.env.LINKWRIGHT_THROTTLE ?? 1);
export async function page_in(context: BrowserContext): Promise<Page> {
  const page = await context.newPage();
  if (times_slower > 1) {
    const session = await context.newCDPSession(page); // as long as it is there
    await session.send("Emulation.setCPUThrottlingRate", {rate: times_slower});
  }
  return page;
}

interface Fixtures {
  complaints: Complaints;
  /** In a browser profile that has never seen the workbench. */
  fresh: boolean;
}
/** The tests' `test`: with the complaints of the page, which must be none in the end, and with one page for all tests of a
 *  worker, which begins for each as new; a page that has had the workbench before opens it in a third of the time. */
export const test = base.extend<Fixtures, {lent: Page}>({
  fresh: [false, {option: true}],
  lent: [
    async ({browser}, use, {project}) => {
      const {baseURL, viewport, locale, timezoneId, colorScheme} = project.use,
        context = await browser.newContext({baseURL, viewport, locale, timezoneId, colorScheme});
      await use(await page_in(context));
      await context.close();
    },
    {scope: "worker"},
  ],
  page: async ({lent, browser, fresh, hasTouch, viewport, colorScheme}, use) => {
    if (fresh || hasTouch) {
      const context = await browser.newContext();
      await use(await page_in(context));
      return context.close();
    }
    const forget_scripts = remembered_scripts(lent);
    await lent.setViewportSize(viewport!);
    await use(lent);
    await forget_scripts();
    await made_new(lent, colorScheme!);
  },
  context: async ({page}, use) => use(page.context()),
  complaints: [
    async ({page}, use) => {
      const complaints = new Complaints(page);
      await use(complaints);
      expect(complaints.all, "complaints of the page").toEqual([]);
    },
    {auto: true},
  ],
});
/** Returns how to take back what a test gives to the page to run at its start. */
function remembered_scripts(page: Page): () => Promise<void> {
  const given: {dispose(): Promise<void>}[] = [],
    add = page.addInitScript;
  page.addInitScript = async (...script: Parameters<typeof add>) => {
    const disposable = await add.apply(page, script);
    given.push(disposable);
    return disposable;
  };
  return async () => {
    page.addInitScript = add;
    for (const script of given) await script.dispose();
  };
}
/** Nothing is left of what a test did: neither handlers nor screen nor what the browser has stored. */
async function made_new(page: Page, color_scheme: "light" | "dark" | "no-preference" | null): Promise<void> {
  const context = page.context();
  page.removeAllListeners();
  await page.unrouteAll();
  await page.mouse.move(0, 0);
  for (const other of context.pages()) if (other !== page) await other.close();
  await context.clearPermissions();
  await page.emulateMedia({
    media: null,
    colorScheme: color_scheme,
    reducedMotion: null,
    forcedColors: null,
    contrast: null,
  });
  await page.goto("/icon.svg"); // there is no workbench that would keep its work
  const session = await context.newCDPSession(page);
  await session.send("Storage.clearDataForOrigin", {origin: new URL(page.url()).origin, storageTypes: "all"});
  await session.detach();
  await page.evaluate(() => sessionStorage.clear());
}
export {expect};

/** Opens the page and waits until the engine has answered. */
export async function open_workbench(page: Page, address = "/"): Promise<void> {
  await page.addInitScript(() => {
    if (!localStorage.getItem("linkwright.preferences"))
      localStorage.setItem("linkwright.preferences", '{"toured": true}'); // no first start: no tour, no opening
  });
  await page.goto(address);
  await until_ready(page);
}
export async function until_ready(page: Page): Promise<void> {
  await page.waitForFunction(() => globalThis.__linkwright?.ready === true);
}

/** What a first visit did without has come, too. */
export async function until_at_rest(page: Page): Promise<void> {
  const has_come = () => performance.getEntriesByType("resource").some(({name}) => name.includes("ExportDialog"));
  await page.waitForFunction(has_come);
  await page.waitForLoadState("networkidle");
}
/** All that was asked of the engine has its answer, but what is asked at leisure. */
export async function until_answered(page: Page): Promise<void> {
  await page.waitForFunction(() => globalThis.__linkwright!.workbench.questions.settled());
}
/** The map on screen is that of the problem as it is. */
export async function until_mapped(page: Page): Promise<void> {
  await page.waitForFunction(() => {
    if (!globalThis.__linkwright) return false; // a page that begins waits for what it needs first
    const {workbench, painted_map} = globalThis.__linkwright;
    return workbench.is_current && workbench.census !== null && painted_map() === workbench.map;
  });
}
/** And so are its counts and the linkage in hand; another map begins with its best one, which takes another answer. */
export async function until_settled(page: Page, at_least = 0): Promise<void> {
  await page.waitForFunction((least) => {
    if (!globalThis.__linkwright) return false;
    const {workbench, painted_map} = globalThis.__linkwright,
      {is_current, census, map, hand, tau_in_hand, questions} = workbench;
    return (
      is_current &&
      census !== null &&
      painted_map() === map &&
      questions.settled() &&
      hand?.tau.join() === tau_in_hand?.join() &&
      (map?.samples ?? 0) >= least
    );
  }, at_least);
}
/** And the map is the finest, after which nothing comes by itself. */
export const until_fine = (page: Page): Promise<void> => until_settled(page, 1000);

/** What `read` finds in the page's state. It runs in the page: of all that is outside of it, it sees its argument only. */
export async function read_state<T, A = undefined>(
  page: Page,
  read: (workbench: Workbench, argument: A) => T,
  argument?: A,
): Promise<T> {
  const workbench = await page.evaluateHandle(() => globalThis.__linkwright!.workbench);
  try {
    return (await workbench.evaluate(read as never, argument)) as T;
  } finally {
    await workbench.dispose();
  }
}

/** Plays to the end of the travel: the poses that lit up on the way. */
export async function played_poses(page: Page): Promise<number[]> {
  const lit = read_state(
    page,
    (workbench) =>
      new Promise<number[]>((resolve) => {
        const passed: number[] = [],
          {get, set} = Object.getOwnPropertyDescriptor(Object.getPrototypeOf(workbench), "lit_pose")!;
        Object.defineProperty(workbench, "lit_pose", {
          get: () => get!.call(workbench),
          set(pose: number | null) {
            if (pose !== null) passed.push(pose);
            set!.call(workbench, pose);
          },
        });
        let started = false;
        const look = () => {
          started ||= workbench.playing;
          if (started && !workbench.playing) resolve(passed);
          else requestAnimationFrame(look);
        };
        look();
      }),
  );
  await page.getByTestId("drive.play").click();
  return lit;
}

export interface Shown {
  map: string;
  picked: string;
  pins: string;
  poses: string;
}
/** What is on screen, by what it is drawn from. Waits until the map is the problem's at 1000². */
export async function shown(page: Page): Promise<Shown> {
  await page.waitForFunction(() => {
    const {workbench, ready} = globalThis.__linkwright!;
    const {picked, picked_linkage, just_changed} = workbench; // what the change has cost may yet be replaced
    return (
      ready &&
      !just_changed &&
      workbench.map!.samples === 1000 &&
      picked !== null &&
      picked_linkage?.tau.join() === picked.tau.join()
    );
  });
  return read_state(page, ({map, picked, pins, problem}) => {
    let sum = 0x811c9dc5;
    for (const bytes of [map!.type, map!.defects, map!.fails])
      for (const byte of bytes) sum = Math.imul(sum ^ byte, 0x01000193);
    return {
      map: `${map!.samples} ${sum >>> 0}`,
      picked: picked!.tau.join(),
      pins: JSON.stringify(pins.map(({name, note, tau}) => [name, note, tau])),
      poses: JSON.stringify((problem.task as MotionTask).poses.map(({x, y, theta_deg}) => [x, y, theta_deg])),
    };
  });
}
export async function move_a_pose(page: Page, x = -222): Promise<void> {
  await read_state(
    page,
    (workbench, value) => {
      workbench.edit((problem) => ({
        ...problem,
        task: {
          ...problem.task,
          poses: (problem.task as MotionTask).poses.map((pose, i) => (i === 2 ? {...pose, x: value} : pose)),
        },
      }));
    },
    x,
  );
}

// ---- panels -----------------------------------------------------------------------------------------------------

/** Opens the page in English, and waits until all of it is that of the first example. */
export async function open_settled(page: Page): Promise<void> {
  await page.addInitScript(() =>
    localStorage.setItem("linkwright.preferences", JSON.stringify({language: "en", theme: "light", toured: true})),
  );
  await open_workbench(page);
  await until_settled(page);
}
export async function set_theme(page: Page, theme: "light" | "dark"): Promise<void> {
  await page.evaluate((name) => (globalThis.__linkwright!.preferences.theme = name), theme);
  await expect(page.locator("html")).toHaveAttribute("data-theme", theme);
}
export const poses_of_page = (page: Page): Promise<Pose[]> =>
  read_state(page, (workbench) => (workbench.problem.task as MotionTask).poses as Pose[]);
export async function type_into(page: Page, name: string, text: string, key = "Enter"): Promise<void> {
  await page.getByTestId(name).click();
  await page.keyboard.press("Control+a");
  await page.keyboard.type(text);
  await page.keyboard.press(key);
}

// ---- files and sentences ----------------------------------------------------------------------------------------

export async function file_menu(page: Page, item: string): Promise<void> {
  await page.getByTestId("file.menu").click();
  await page.getByTestId(item).click();
}
export async function open_files(
  page: Page,
  file: string | {name: string; mimeType: string; buffer: Buffer},
): Promise<void> {
  const [chooser] = await Promise.all([page.waitForEvent("filechooser"), file_menu(page, "file.open")]);
  await chooser.setFiles(file);
}
export const toasts = (page: Page) => page.getByTestId("toast.title");

// ---- places on the page -----------------------------------------------------------------------------------------

export interface Pixel {
  x: number;
  y: number;
}
/** Where a pair of places on the two axes of the map lies on the page: input upwards, output to the right. */
export function map_pixel(page: Page, place: TauPair): Promise<Pixel> {
  return page.evaluate(([given]) => globalThis.__linkwright!.map_point(given), [place] as const);
}
/** Tells two pictures of the map apart. */
export function map_hash(page: Page): Promise<string> {
  return page.evaluate(() => globalThis.__linkwright!.map_hash());
}
/** Where the middle of a thing on the page lies: what is dragged. */
export async function middle_of(thing: Locator): Promise<Pixel> {
  const box = (await thing.boundingBox())!;
  return {x: box.x + box.width / 2, y: box.y + box.height / 2};
}
/** Drags from one pixel to another in steps, as a hand does; `before_release` runs while the button is held. */
export async function drag(
  page: Page,
  from: Pixel,
  to: Pixel,
  steps = 10,
  before_release?: () => Promise<void>,
): Promise<void> {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, to.y, {steps});
  await before_release?.();
  await page.mouse.up();
}

// ---- accessibility ----------------------------------------------------------------------------------------------

const axe_source = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** No violations of WCAG 2.2 A and AA, as far as axe-core sees, in the page or parts of it. */
export async function expect_accessible(page: Page, ...parts: string[]): Promise<void> {
  const is_there = await page.evaluate(() => "axe" in globalThis);
  if (!is_there) await page.evaluate(axe_source); // by the debugger, which the page's Content-Security-Policy does not bind
  const violations = await page.evaluate(async (selectors) => {
    const {axe} = globalThis as unknown as {
      axe: {run(context: object, options: object): Promise<{violations: Violation[]}>};
    };
    interface Violation {
      id: string;
      help: string;
      nodes: {target: unknown[]; failureSummary?: string}[];
    }
    const found = await axe.run(
      {include: selectors.length ? selectors : ["html"]},
      {
        runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"],
      },
    );
    return found.violations.map(({id, help, nodes}) => ({
      id,
      help,
      where: nodes.slice(0, 5).map((node) => `${node.target.join(" ")}: ${node.failureSummary}`),
    }));
  }, parts);
  expect(violations, "violations of accessibility").toEqual([]);
}

// ---- pictures ---------------------------------------------------------------------------------------------------

/** Keeps a picture of a main state in build/web-screenshots, for people. */
export async function keep_screenshot(page: Page, name: string): Promise<void> {
  mkdirSync(screenshots, {recursive: true});
  await page.screenshot({path: join(screenshots, `${name}.png`), animations: "disabled"});
}
