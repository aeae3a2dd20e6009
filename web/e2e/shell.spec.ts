// The page as a whole: first start, languages, keys, and an engine that dies. The numbers of the tests are the
// walk-throughs'.
import type {Page} from "@playwright/test";
import {
  expect,
  expect_accessible,
  file_menu,
  keep_screenshot,
  map_pixel,
  move_a_pose,
  open_workbench,
  page_in,
  read_state,
  shown,
  test,
  toasts,
  until_fine,
  until_ready,
  until_settled,
} from "./support";
import type {MotionTask} from "../src/kinds/motion/task";

// ---- 1 ----------------------------------------------------------------------------------------------------------

test("1 · first start: a map, a count, the linkage opens once, the tour goes with what one does and never comes back", async ({
  page,
}) => {
  await page.addInitScript(() => {
    const hook = globalThis as {lowest_stage?: number};
    const watch = () => {
      hook.lowest_stage = Math.min(
        hook.lowest_stage ?? Infinity,
        globalThis.__linkwright?.workbench?.stage ?? Infinity,
      );
      requestAnimationFrame(watch);
    };
    watch();
  });
  let release = (): void => {};
  const colored = new Promise<void>((resolve) => (release = resolve));
  await page.route(/\.wasm$/, async (route) => {
    await colored;
    await route.continue();
  });
  await page.goto("/");
  const colors = () =>
    page
      .getByTestId("region.map")
      .locator("canvas")
      .first()
      .evaluate((canvas: HTMLCanvasElement) => {
        const style = getComputedStyle(document.documentElement);
        const wanted = [
          "double_crank",
          "triple_rocker_input",
          "triple_rocker_output",
          "crank_rocker",
          "rocker_crank",
        ].map((name) => parseInt(style.getPropertyValue(`--${name}`).trim().slice(1), 16));
        if (canvas.width === 0) return 0;
        const {data} = canvas.getContext("2d")!.getImageData(0, 0, canvas.width, canvas.height);
        const found = new Set<number>();
        for (let i = 0; i < data.length; i += 4) found.add((data[i]! << 16) | (data[i + 1]! << 8) | data[i + 2]!);
        return wanted.filter((color) => found.has(color)).length;
      });
  await expect.poll(colors).toBeGreaterThanOrEqual(3); // before there is an engine
  expect(await page.evaluate(() => globalThis.__linkwright!.ready)).toBe(false);
  release();
  await expect(page.getByTestId("chip.title")).toContainText(
    /159.600 four-bars.*97.477 free of defects.*25.608 meet your requirements/,
  );
  await expect(page.locator(".tour_hint")).toContainText("1 of 3 · Drag position 4 within the green.");
  await until_ready(page);
  await expect(page.getByTestId("chip.title")).toContainText(/159.600 four-bars/);
  await expect(page.getByTestId("drawing.halo")).toHaveAttribute("data-squares", /\d{2}/); // where to drag it, before it is touched
  await expect_accessible(page);

  await page.waitForFunction(
    () =>
      (globalThis as {lowest_stage?: number}).lowest_stage! < 1 &&
      Math.abs(globalThis.__linkwright!.workbench.stage - 2.45) < 1e-9,
  );

  const disc = page.getByRole("button", {name: /3/}).locator("visible=true").first();
  await expect(page.locator(".tour_hint")).toContainText("1 of 3");
  await read_state(page, (workbench) => {
    workbench.begin_gesture();
    workbench.drag((problem) => ({
      ...problem,
      task: {
        ...problem.task,
        poses: (problem.task as MotionTask).poses.map((pose, i) => (i === 2 ? {...pose, x: -222} : pose)),
      },
    }));
  });
  await expect(disc).toBeAttached();
  await read_state(page, (workbench) => workbench.end_gesture());
  await expect(page.locator(".tour_hint")).toContainText("2 of 3 · Move over the solution region.");
  const from = await map_pixel(page, [0.7, 0.1]),
    to = await map_pixel(page, [0.3, 0.4]);
  await page.mouse.move(from.x, from.y);
  await page.mouse.move(to.x, to.y, {steps: 24});
  await expect(page.locator(".tour_hint")).toContainText("3 of 3 · Click to select it,");
  await page.mouse.click(to.x, to.y);
  await expect(page.locator(".tour_hint")).toBeHidden();
  await page.reload();
  await until_ready(page);
  await expect(page.locator(".tour_hint")).toBeHidden();
  await page.getByTestId("help.keys").click();
  await page.getByTestId("help.tour").click();
  await expect(page.locator(".tour_hint")).toContainText("1 of 3");
  await page.keyboard.press("Escape");
  await expect(page.locator(".tour_hint")).toBeHidden();

  await read_state(page, (workbench) => {
    while (workbench.can_undo) workbench.undo();
  });
  await until_fine(page);

  // Words explain themselves, to the pointer and to the focus; tasks begin from pictures, also from the kind of this one.
  await expect(async () => {
    await page.mouse.move(0, 0); // a word that was carried off from under the pointer is pointed at again
    await page.getByTestId("type.double_rocker").hover();
    await expect(page.getByTestId("term.tip")).toContainText("the coupler turns fully", {timeout: 3000});
  }).toPass();
  await expect(page.getByTestId("term.tip").locator("path")).not.toHaveCount(0);
  await page.getByTestId("num.type").locator("dfn").focus();
  await expect(page.getByTestId("term.tip")).toContainText("the input link is the longest");
  await page.keyboard.press("Escape");
  await expect(page.getByTestId("term.tip")).toBeHidden();
  await page.getByTestId("task.kind").click();
  await expect(page.getByTestId("dialog.new").locator(".picture")).toHaveCount(18);
  await keep_screenshot(page, "new-task");
});

// ---- 6 ----------------------------------------------------------------------------------------------------------

test("6 · from the start to a DXF by keys alone, the focus always in sight", async ({page}) => {
  await open_workbench(page);
  await shown(page);
  const unseen: string[] = [];
  let past_the_end = 0; // Tab leaves the page for the browser's own controls once a round
  const look = async () => {
    const fault = await page.evaluate(() => {
      const element = document.activeElement as HTMLElement | SVGElement;
      if (element === document.body) return "nothing has the focus";
      const {outlineStyle, outlineWidth, boxShadow} = getComputedStyle(element),
        box = element.getBoundingClientRect();
      const marked =
        element.matches(":focus-visible") &&
        ((outlineStyle !== "none" && parseFloat(outlineWidth) >= 1) ||
          boxShadow !== "none" ||
          element.closest("svg") !== null);
      const inside = box.right > 0 && box.bottom > 0 && box.left < innerWidth && box.top < innerHeight;
      return marked && inside
        ? null
        : `${element.tagName} ${element.getAttribute("data-testid") ?? element.getAttribute("aria-label") ?? element.className}`;
    });
    if (fault === "nothing has the focus") ++past_the_end;
    else if (fault) unseen.push(fault);
  };
  const tab_to = async (testid: string) => {
    for (let i = 0; i < 150; ++i) {
      await page.keyboard.press("Tab");
      await look();
      if ((await page.evaluate(() => document.activeElement?.getAttribute("data-testid"))) === testid) return;
    }
    throw new Error(`Tab never comes to ${testid}`);
  };
  await tab_to("region.map");
  const before = await read_state(page, (workbench) => workbench.picked!.tau);
  for (const key of ["ArrowDown", "Shift+ArrowDown", "ArrowLeft", "Enter"]) await page.keyboard.press(key);
  expect(await read_state(page, (workbench) => workbench.picked!.tau)).not.toEqual(before);
  await until_settled(page);
  const title = await page.getByTestId("num.type").innerText();
  await expect(page.locator("#region_spoken")).toContainText(title.trim());
  await page.keyboard.press("p");
  expect(await read_state(page, (workbench) => workbench.pins.length)).toBe(1);
  await tab_to("export.title");
  await page.keyboard.press("Enter");
  await expect(page.getByTestId("export.dxf")).toBeVisible();
  for (
    let i = 0;
    i < 30 && (await page.evaluate(() => document.activeElement?.getAttribute("data-testid"))) !== "export.dxf";
    ++i
  )
    await page.keyboard.press("Tab");
  const [download] = await Promise.all([page.waitForEvent("download"), page.keyboard.press("Enter")]);
  expect(download.suggestedFilename()).toMatch(/^tailgate-hinge.*\.dxf$/);
  expect(unseen).toEqual([]);
  expect(past_the_end).toBeLessThanOrEqual(1);
});

test("a visitor who comes back sees his own map before the engine is there", async ({page}) => {
  await open_workbench(page);
  await move_a_pose(page);
  await until_settled(page);
  const before = await shown(page);
  await expect.poll(() => kept_view(page)).toEqual({question: await question(page), picked: before.picked});
  let release = (): void => {};
  const released = new Promise<void>((resolve) => (release = resolve));
  await page.route(/\.wasm$/, async (route) => {
    await released;
    await route.continue();
  });
  await page.reload();
  await page.waitForFunction(() => globalThis.__linkwright?.painted_map());
  expect(await read_state(page, ({engine_state}) => engine_state)).toBe("loading");
  expect(await read_state(page, ({map, hand}) => [map!.rows > 0, hand!.fails])).toEqual([true, 0]);
  await keep_screenshot(page, "come-back");
  release();
  await until_ready(page);
  await until_settled(page);
  expect(await shown(page)).toEqual(before);
});
const question = (page: Page) =>
  read_state(page, ({problem}) => {
    const {view: _, ...rest} = problem;
    return JSON.stringify(rest);
  });
/** What the view that is kept for the next visit is of. */
const kept_view = (page: Page) =>
  page.evaluate(async () => {
    const is_there = (await indexedDB.databases()).some(({name}) => name === "linkwright_view");
    if (!is_there) return null; // opening it would make it
    const database = await new Promise<IDBDatabase>((resolve) => {
      const opening = indexedDB.open("linkwright_view");
      opening.onsuccess = () => resolve(opening.result);
    });
    const view = await new Promise<{question: string; linkage: {tau: number[]}} | undefined>((resolve) => {
      const reading = database.transaction("view").objectStore("view").get("last");
      reading.onsuccess = () => resolve(reading.result);
    });
    database.close();
    return view ? {question: view.question, picked: view.linkage.tau.join()} : null;
  });

// ---- 19 ---------------------------------------------------------------------------------------------------------

test("19 · the engine dies in the middle of a map, and nothing is lost", async ({page}) => {
  await open_workbench(page);
  await until_settled(page);
  await move_a_pose(page);
  await until_settled(page);
  expect(await read_state(page, ({hand}) => hand!.fails)).toBe(0);
  const before = await shown(page);
  const killed = page.evaluate(
    () =>
      new Promise<number>((resolve) => {
        const {workbench} = globalThis.__linkwright as unknown as {
          workbench: {
            engine: {busy: boolean; worker: Worker};
            maps: {fine: boolean};
            edit(change: (problem: object) => object): void;
          };
        };
        workbench.edit((problem) => ({
          ...problem,
          requirements: {...(problem as {requirements: object}).requirements, max_link_ratio: 7},
        }));
        const look = () => {
          if (!(workbench.maps.fine && workbench.engine.busy)) return void setTimeout(look, 1);
          const {worker} = workbench.engine;
          worker.terminate();
          worker.dispatchEvent(new ErrorEvent("error", {message: "killed", cancelable: true}));
          resolve(performance.now());
        };
        look();
      }),
  );
  await killed;
  await expect(toasts(page)).toContainText("The engine stopped and was restarted. Nothing was lost.");
  await until_ready(page);
  await until_fine(page);
  const requirements = await read_state(page, (workbench) => workbench.problem.requirements!.max_link_ratio);
  expect(requirements).toBe(7);
  await page.keyboard.press("Control+z");
  expect(await shown(page)).toEqual(before);
  await page.keyboard.press("Control+z");
  expect(await read_state(page, ({can_undo, problem}) => [can_undo, (problem.task as MotionTask).poses[2]!.x])).toEqual(
    [false, -220],
  );
});

test("19 · the rest of the engine's code cannot be had, and is asked for again", async ({page, complaints}) => {
  const rest = /\/rest-[^/]*\.wasm$/;
  await page.route(rest, (route) => route.abort("connectionfailed"));
  await open_workbench(page);
  await move_a_pose(page);
  await until_settled(page); // a four-bar does without
  await file_menu(page, "file.examples");
  await page.getByTestId("example.folding_wing").click();
  await expect(toasts(page)).toContainText("The engine failed several times in a row and is paused.");
  await page.unroute(rest);
  await toasts(page).getByRole("button", {name: "Start it again"}).click();
  await until_ready(page);
  await until_settled(page);
  expect(await read_state(page, ({map}) => map!.census.pairs)).toBeGreaterThan(0);
  complaints.expect_and_forget(/CONNECTION_FAILED|Failed to fetch|rest-/);
});

// ---- 21 ---------------------------------------------------------------------------------------------------------

/** Words of Latin letters that are seen or spoken, but for names, units, signs, commands and files. */
function latin_words(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const allowed =
      /^(Linkwright|linkwright|solve|analyze|English|mm|kg|DXF|SVG|PNG|CSV|JSON|GIF|MP|MF|STL|WebM|URDF|ROS|SDF|Gazebo|SDFormat|MJCF|MuJoCo|STEP|CAD|A4|A3|MB|kB|PP?P?|Ctrl|Shift|Alt|Tab|Enter|Space|Esc|Mac|[A-Za-z])$/;
    const texts: string[] = [];
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_ELEMENT | NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
      if (node instanceof Text) {
        const parent = node.parentElement!;
        if (!["SCRIPT", "STYLE", "CODE"].includes(parent.tagName) && parent.checkVisibility()) texts.push(node.data);
      } else if (node instanceof Element && node.checkVisibility()) {
        for (const name of ["aria-label", "title", "placeholder", "aria-valuetext"])
          texts.push(node.getAttribute(name) ?? "");
      }
    }
    const words = texts.flatMap((text) => text.replace(/“[^”]*\.json”/g, "").match(/[A-Za-z][A-Za-z'’]*/g) ?? []);
    return [...new Set(words.filter((word) => !allowed.test(word)))];
  });
}

test("21 · in Chinese nothing is left in English, in the dark all can be read, and both are kept; the browser's own come first", async ({
  page,
  browser,
}) => {
  await open_workbench(page);
  await shown(page);
  await read_state(page, (workbench) => workbench.pin());
  await page.route(/\/zh-[^/]*\.js$/, async (route) => {
    await new Promise((resolve) => setTimeout(resolve, 300)); // the words come after what is spoken would have been said
    await route.continue();
  });
  await page.getByTestId("view.language").click();
  await page.getByTestId("view.theme").click();
  await expect(page.locator("html")).toHaveAttribute("lang", "zh-CN");
  await expect(page).toHaveTitle("汽车尾门铰链 · Linkwright");
  await expect.poll(() => latin_words(page)).toEqual([]); // what is spoken follows after a moment
  await expect_accessible(page);
  await keep_screenshot(page, "wide-dark-zh");
  for (const dialog of ["examples", "keys", "new", "export", "compare"] as const) {
    await read_state(page, (workbench, name) => void (workbench.dialog = name), dialog);
    await expect(page.locator("dialog[open]")).toBeVisible();
    expect(await latin_words(page), dialog).toEqual([]);
    await expect_accessible(page, "dialog[open]"); // of the page behind all has been seen
    await page.keyboard.press("Escape");
    await expect(page.locator("dialog[open]")).toHaveCount(0);
  }
  await page.reload();
  await until_ready(page);
  await expect(page.locator("html")).toHaveAttribute("lang", "zh-CN");
  await expect(page.locator("html")).toHaveAttribute("data-theme", "dark");
  await expect(page.getByTestId("chip.title")).toContainText(/个满足要求/);

  await test.step("the browser's own language and theme come first", async () => {
    const context = await browser.newContext({locale: "zh-CN", colorScheme: "dark"});
    const other = await page_in(context);
    await other.goto("/");
    await expect(other.locator("html")).toHaveAttribute("lang", "zh-CN");
    await expect(other.locator("html")).toHaveAttribute("data-theme", "dark");
    await context.close();
  });
});

// ---- the frame --------------------------------------------------------------------------------------------------

test("columns are as wide as one wants, also after a reload; a laptop has its panels over the drawing, never over the map", async ({
  page,
}) => {
  await open_workbench(page);
  const splitter = page.getByTestId("splitter.left"),
    width = () => page.locator("aside.left").evaluate((element) => Math.round(element.getBoundingClientRect().width));
  const box = (await splitter.boundingBox())!;
  await page.mouse.move(box.x + 4, 500);
  await page.mouse.down();
  await page.mouse.move(box.x + 54, 500, {steps: 3});
  await page.mouse.up();
  await expect.poll(width).toBe(318);
  await page.reload();
  await until_ready(page);
  await expect.poll(width).toBe(318);
  await splitter.focus();
  for (let i = 0; i < 10; ++i) await page.keyboard.press("ArrowLeft");
  await expect.poll(width).toBe(240);
  await splitter.dblclick();
  await expect.poll(width).toBe(268);

  await page.setViewportSize({width: 1024, height: 768});
  await shown(page);
  const map = (await page.getByTestId("region.map").boundingBox())!;
  for (const name of ["num.best", "pin.add", "region.improve", "num.dxf", "bar.new"])
    await expect(page.getByTestId(name), name).toBeInViewport({ratio: 1});
  for (const name of ["rail.task", "rail.limits", "rail.pins"]) {
    await page.getByTestId(name).click();
    const sheet = (await page.locator("#rail_sheet").boundingBox())!;
    expect(sheet.x + sheet.width).toBeLessThan(map.x);
    await expect(page.getByTestId(name)).toHaveAttribute("aria-expanded", "true");
    if (name === "rail.limits") await keep_screenshot(page, "laptop");
  }
  await expect_accessible(page);
  await page.getByTestId("rail.pins").click();
  await expect(page.locator("#rail_sheet")).toBeHidden();
  await expect(page.getByTestId("chip.title")).toHaveText(/^\s*25.608 meet your requirements$/);
});
