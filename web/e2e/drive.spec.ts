// Walk-throughs 14 (drive), 18 (exports) and 24 (3-D).
import {readFileSync} from "node:fs";
import {join} from "node:path";
import type {Page} from "@playwright/test";
import {
  drag,
  expect,
  expect_accessible,
  keep_screenshot,
  open_files,
  open_workbench,
  read_state,
  root,
  test,
  toasts,
  type_into,
  until_at_rest,
  until_settled,
} from "./support";
import type {MotionTask} from "../src/kinds/motion/task";

/** Opens the example and waits for the picked linkage and its drive. */
async function open_with_drive(page: Page): Promise<void> {
  await page.addInitScript(() => localStorage.setItem("linkwright.preferences", '{"toured":true}')); // nothing moves by itself
  await open_workbench(page);
  await until_settled(page);
}
/** Where the drive stands, and how far the body is there from a position (from 0). */
function body_at(page: Page, pose: number) {
  return read_state(
    page,
    (workbench, index) => {
      const {states, ticks} = workbench.hand!.drive!,
        width = states.length / Math.round(states.length / 13);
      const at = ticks[index]!.state * width,
        wanted = (workbench.problem.task as MotionTask).poses[index];
      const turn = ((states[at + 7]! - wanted!.theta_deg) / 360) % 1;
      return {
        angle: states[at]! + 0,
        now: workbench.angle + 0, // no −0
        away: Math.hypot(states[at + 5]! - wanted!.x, states[at + 6]! - wanted!.y),
        turned: Math.abs(turn - Math.round(turn)) * 360,
      };
    },
    pose,
  );
}

test.describe("drive", () => {
  test("the scrub bar snaps to the positions, the body is exactly there, and plots are tied to the bar", async ({
    page,
  }) => {
    await open_with_drive(page);
    const sweep = await read_state(page, (workbench) => workbench.hand!.driver_sweep_deg);
    const bar = page.getByTestId("drive.angle");
    for (const pose of [0, 1, 2, 3]) {
      const dot = (await bar.locator(".name", {hasText: String(pose + 1)}).boundingBox())!;
      const box = (await bar.boundingBox())!;
      await page.mouse.click(dot.x + dot.width / 2 + 4, box.y + 12); // four pixels beside it
      const body = await body_at(page, pose);
      expect(body.now).toBe(body.angle);
      expect(body.away).toBeLessThan(1e-9);
      expect(body.turned).toBeLessThan(1e-9);
      await expect(bar).toHaveAttribute("aria-valuetext", new RegExp(`position ${pose + 1}$`));
    }
    expect((await body_at(page, 3)).angle - (await body_at(page, 0)).angle).toBeCloseTo(sweep!, 9);

    await page.getByTestId("drive.angle").focus();
    await page.keyboard.press("Home");
    await page.keyboard.press("Shift+ArrowRight");
    const first = await read_state(page, ({hand}) =>
      Array.from(hand!.drive!.states.slice(13 * hand!.drive!.ticks[0]!.state, 13 * hand!.drive!.ticks[0]!.state + 13)),
    );
    await expect(page.getByTestId("plot.value")).toHaveText(`${first[8]!.toFixed(1)}°`);
    const over = page.getByTestId("plot.title").locator(".u-over");
    const plot = (await over.boundingBox())!;
    await page.mouse.click(plot.x + plot.width / 2, plot.y + plot.height / 2);
    expect(await read_state(page, (workbench) => workbench.angle)).toBeCloseTo((await body_at(page, 3)).angle / 2, 0);
    for (const kind of ["coupler", "velocity", "advantage", "path"]) {
      await page.getByTestId(`plot.${kind}`).click();
      await expect(page.getByTestId("plot.value")).not.toHaveText(/NaN|^$/);
    }
  });
});

// ---- exports ------------------------------------------------------------------------------------------------------

async function exported(page: Page, format: string): Promise<Buffer> {
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByTestId(`export.${format}`).click()]);
  return readFileSync(await download.path());
}
async function open_exports(page: Page): Promise<void> {
  await open_with_drive(page);
  await read_state(page, (workbench) => void (workbench.dialog = "export"));
  await expect(page.getByTestId("export.dialog")).toBeVisible();
}
test.describe("exports", () => {
  test("pictures and animations are what their names say", async ({page}) => {
    await open_exports(page);
    await page.getByTestId("export.plates.fold").locator("summary").click();
    await expect_accessible(page, "dialog");
    await keep_screenshot(page, "export");
    const png = await exported(page, "png");
    expect(png.subarray(0, 8)).toEqual(Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]));
    const drawing = (await page.getByTestId("drawing.canvas").boundingBox())!;
    expect(Math.abs(png.readUInt32BE(16) - 2 * drawing.width)).toBeLessThanOrEqual(2);

    const gif = await exported(page, "gif");
    expect(gif.subarray(0, 6).toString()).toBe("GIF89a");
    expect([gif.readUInt16LE(6), gif.readUInt16LE(8)]).toEqual([640, 480]);
    expect(gif.at(-1)).toBe(0x3b);
    expect(gif.length).toBeLessThan(3_000_000);
    expect(gif.toString("latin1").split("\x21\xf9\x04").length - 1, "frames").toBeGreaterThanOrEqual(80);

    // One that is stopped leaves nothing.
    await page.getByTestId("export.gif").click();
    await page.getByTestId("export.stop").dispatchEvent("click"); // it moves and may be gone before a hand is there
    await expect(page.getByTestId("export.gif")).toBeEnabled();
    await expect(page.getByTestId("export.status")).toHaveText("");
    await page.keyboard.press("Escape");
    await expect(page.getByTestId("export.dialog")).toBeHidden();
  });

  test("nothing is drawn for the printer before anyone prints; the sheet is one page with drawing, instant, map and numbers", async ({
    page,
  }) => {
    await page.addInitScript(() => {
      let prints = 0;
      window.print = () => {
        dispatchEvent(new Event("beforeprint"));
        document.documentElement.dataset.prints = String(++prints);
      };
    });
    await open_with_drive(page);
    await until_at_rest(page);
    const sheet = page.getByTestId("export.sheet"),
      stand_in = sheet.getByTestId("print.stand_in").locator("svg"),
      drawing = sheet.locator(".drawing img"),
      has_printed = (times: number) => expect(page.locator("html")).toHaveAttribute("data-prints", String(times));
    await expect(sheet).toBeAttached();
    await expect(drawing).toHaveCount(0);

    // By the browser's own menu: what is on screen.
    await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
    await expect(stand_in).toHaveCount(1);
    await page.evaluate(() => dispatchEvent(new Event("afterprint")));
    await expect(stand_in).toHaveCount(0);

    await read_state(page, (workbench) => void (workbench.dialog = "export"));
    await page.getByTestId("export.print").click();
    await has_printed(1);
    await page.emulateMedia({media: "print"});
    await expect(sheet).toBeVisible();
    await expect(sheet.locator("h1")).toHaveText("Tailgate hinge");
    expect(await drawing.evaluate((image: HTMLImageElement) => image.complete && image.naturalWidth > 0)).toBe(true);
    expect(
      await sheet.locator("canvas").evaluate((canvas: HTMLCanvasElement) => {
        const {data} = canvas.getContext("2d")!.getImageData(0, 0, canvas.width, canvas.height);
        return new Set(new Uint32Array(data.buffer)).size;
      }),
    ).toBeGreaterThan(8);
    await expect(sheet).toContainText("No link is printed: 127.0.0.1"); // which nobody else could open
    const pdf = (await page.pdf({preferCSSPageSize: true})).toString("latin1");
    expect(pdf.match(/\/Type \/Page\b(?!s)/g)).toHaveLength(1);

    await has_printed(1); // not once more when the drawing had come
    // With the instant, which is of the screen, the drawing is the screen's.
    await page.emulateMedia({media: "screen"});
    await page.evaluate(() => dispatchEvent(new Event("afterprint")));
    const width = await page.locator("svg.drawing").evaluate((svg) => svg.clientWidth);
    await expect(drawing).not.toHaveJSProperty("naturalWidth", width);
    await page.keyboard.press("i");
    await expect(page.getByTestId("drawing.instant_circling")).toBeAttached();
    await page.keyboard.press("Control+p");
    await has_printed(2);
    await expect(drawing).toHaveJSProperty("naturalWidth", width);
  });
});

// ---- 3-D ----------------------------------------------------------------------------------------------------------

/** Some pixels of the 3-D picture, to tell one from another. */
function solid_print(page: Page): Promise<string> {
  return page
    .getByTestId("solid.figure")
    .locator("canvas")
    .evaluate((canvas: HTMLCanvasElement) => {
      const copy = document.createElement("canvas");
      [copy.width, copy.height] = [96, 96];
      const context = copy.getContext("2d", {willReadFrequently: true})!;
      context.drawImage(canvas, 0, 0, 96, 96);
      const data = new Uint32Array(context.getImageData(0, 0, 96, 96).data.buffer);
      let sum = 0;
      for (const pixel of data) sum = (Math.imul(sum, 31) + pixel) | 0;
      return new Set(data).size > 20 ? String(sum) : "blank";
    });
}
/** What is shown is the linkage in hand. */
function machine_is_of_hand(page: Page): Promise<boolean> {
  return read_state(page, ({machines, hand}) => hand !== null && machines.of?.tau.join() === hand.tau.join());
}
async function changed_from(page: Page, before: string): Promise<string> {
  await expect.poll(() => solid_print(page)).not.toBe(before);
  return solid_print(page);
}

test.describe("3-D", () => {
  test.use({viewport: {width: 1440, height: 640}}); // without a graphics card each pixel takes its time
  test("shows the linkage, plays and turns, and says when it cannot be loaded", async ({page, complaints}) => {
    await open_with_drive(page);
    await page.route(/\/SolidView[^/]*\.js$/, (route) => route.abort());
    await page.getByTestId("view.solid").click();
    await expect(toasts(page)).toContainText("The 3-D view could not be loaded");
    expect(await read_state(page, (workbench) => workbench.solid)).toBe(false);
    complaints.expect_and_forget(/SolidView|Failed to load resource/);
    await page.unrouteAll();
    await toasts(page).getByRole("button", {name: "Try again"}).click();
    await expect(page.getByTestId("solid.figure")).toBeVisible();
    await changed_from(page, "blank");
    await keep_screenshot(page, "solid");

    for (const by of [1e-3, 2e-3, 3e-3, null]) {
      await read_state(
        page,
        (workbench, more) => {
          const [input, output] = workbench.picked!.tau;
          workbench.hover(more === null ? null : [input + more, output]);
        },
        by,
      );
      await until_settled(page);
      expect(await machine_is_of_hand(page)).toBe(true);
    }
    let print = await solid_print(page);

    await page.getByTestId("drive.step").click();
    print = await changed_from(page, print);
    await page.getByTestId("drive.play").click();
    await changed_from(page, print);
    await page.getByTestId("drive.play").click();
    expect(await read_state(page, (workbench) => workbench.playing)).toBe(false);

    const box = (await page.getByTestId("solid.figure").boundingBox())!;
    print = await solid_print(page);
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2 + 120, box.y + box.height / 2 + 40, {steps: 4});
    await page.mouse.up();
    print = await changed_from(page, print);
    await page.getByTestId("solid.figure").focus();
    await page.keyboard.press("ArrowLeft");
    await changed_from(page, print);

    await page.getByTestId("solid.layers").click();
    await expect(page.locator("#solid_layers")).toContainText("Coupler");
    await expect_accessible(page, ".solid");
    await read_state(page, (workbench) => void (workbench.solid = false));
    await expect(page.getByTestId("solid.figure")).toHaveCount(0);
    await expect(page.getByTestId("drawing.canvas")).toBeVisible();
  });

  test("shows linkages of all kinds, and moves them", async ({page}) => {
    await open_workbench(page);
    for (const [example, bodies] of [
      ["loader_bucket_chain", ["driver", "added link 5"]],
      ["folding_wing", ["Input link", "Output link"]],
      ["universal_joint_like", ["Input link", "Output link"]],
    ] as const)
      await test.step(example, async () => {
        await open_files(page, join(root, `examples/${example}.json`));
        await until_settled(page);
        await page.getByTestId("view.solid").click();
        const print = await changed_from(page, "blank"); // by what is loaded with the view
        await until_settled(page);
        expect(await machine_is_of_hand(page)).toBe(true);
        await keep_screenshot(page, `solid_${example}`);
        await page.getByTestId("drive.step").click();
        await changed_from(page, print);
        await page.getByTestId("solid.layers").click();
        for (const body of bodies) await expect(page.locator("#solid_layers")).toContainText(body);
        await expect_accessible(page, ".solid");
        await page.getByTestId("view.flat").click();
        await expect(page.getByTestId("solid.figure")).toHaveCount(0);
      });
  });

  test("takes a pivot along its curve, which one undo puts back; has the sizes that its files have, and says why there is nothing to see", async ({
    page,
  }) => {
    await open_with_drive(page);
    await read_state(page, (workbench) => void (workbench.solid = true));
    const figure = (await page.getByTestId("solid.figure").boundingBox())!;
    await page.waitForFunction(() => globalThis.__linkwright!.solid_pixel?.({side: "input", end: "center"}));
    const pivots = () =>
      page.evaluate(() =>
        (["input", "output"] as const).flatMap((side) =>
          (["center", "circle"] as const).map((end) => globalThis.__linkwright!.solid_pixel({side, end})),
        ),
      );
    const before = await pivots(),
      picked = await read_state(page, (workbench) => workbench.picked!.tau);
    const from = {x: figure.x + before[2]![0], y: figure.y + before[2]![1]};
    await drag(page, from, {x: from.x - 14, y: from.y + 10}, 6);
    const [input, output] = await read_state(page, (workbench) => workbench.picked!.tau);
    expect(input).toBe(picked[0]);
    expect(Math.abs(output - picked[1])).toBeGreaterThan(1e-4);
    await until_settled(page);
    expect(await read_state(page, (workbench) => workbench.hand!.residual)).toBeLessThan(1e-9);
    // The input's ground pivot neither moved nor turned; plates of another linkage are a little thicker or thinner.
    const [now] = await pivots();
    expect(Math.hypot(now![0] - before[0]![0], now![1] - before[0]![1])).toBeLessThan(2);
    await page.keyboard.press("Control+z");
    expect(await read_state(page, (workbench) => workbench.picked!.tau)).toEqual(picked);

    const give_pin = async (size: string) => {
      await page.getByTestId("export.title").click();
      await page.getByTestId("export.plates.fold").locator("summary").click();
      await type_into(page, "export.plates.pin", size);
      await page.keyboard.press("Escape");
    };
    await give_pin("5");
    await until_settled(page);
    expect(await read_state(page, (workbench) => workbench.machines.value?.sizes.pin)).toBe(5);
    await give_pin("5000");
    await expect(page.getByTestId("solid.missing")).toContainText("beside this linkage it is a length from");
    await give_pin("7");
    await expect(page.getByTestId("solid.layers")).toBeVisible();
  });
});
