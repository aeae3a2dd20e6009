// The panels at the sides: the table of positions, requirements (walk-throughs 7, 8, 10), pins, and the numbers of the
// linkage in hand.
import {readFileSync} from "node:fs";
import type {Page} from "@playwright/test";
import type {RequirementKey, TauPair} from "../src/engine/protocol";
import type {Pose} from "../src/state/task";
import type {MotionTask} from "../src/tasks/motion/task";
import {planar_requirements} from "../src/tasks/planar";
import {
  example,
  expect,
  expect_accessible,
  keep_screenshot,
  open_workbench,
  read_state,
  solve,
  test,
  until_settled,
} from "./support";

type Hooked = {__linkwright: {workbench: any; preferences: any}};

test.beforeEach(async ({page}) => {
  await page.addInitScript(() =>
    localStorage.setItem("linkwright.preferences", JSON.stringify({language: "en", theme: "light", toured: true})),
  );
  await open_workbench(page);
  await until_settled(page);
});

const poses = (page: Page): Promise<Pose[]> =>
  read_state(page, (workbench) => (workbench.problem.task as MotionTask).poses as Pose[]);
const meeting = (page: Page): Promise<number> => read_state(page, (workbench) => workbench.census!.meeting);
const grouped = (count: number) => String(count).replace(/\B(?=(\d{3})+$)/g, "\u202f");

async function type_into(page: Page, name: string, text: string, key = "Enter"): Promise<void> {
  await page.getByTestId(name).click();
  await page.keyboard.press("Control+a");
  await page.keyboard.type(text);
  await page.keyboard.press(key);
}
async function paste_into(page: Page, name: string, text: string): Promise<void> {
  await page.getByTestId(name).focus();
  await page.getByTestId(name).evaluate((field, pasted) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData("text/plain", pasted);
    field.dispatchEvent(new ClipboardEvent("paste", {clipboardData, bubbles: true, cancelable: true}));
  }, text);
}
async function pick(page: Page, tau: TauPair): Promise<void> {
  await read_state(page, (workbench, to) => workbench.pick(to), tau);
  await page.waitForFunction(
    (to) => (globalThis as unknown as Hooked).__linkwright.workbench.picked_linkage?.tau.join() === to,
    tau.join(),
  );
}

test.describe("table of positions", () => {
  test("takes arithmetic, units and steps; Enter goes down; undo goes back", async ({page}) => {
    const before = await poses(page);
    await type_into(page, "task.x.3", "=-440/2+5");
    expect((await poses(page))[2]!.x).toBe(-215);
    await expect(page.getByTestId("task.x.4")).toBeFocused();
    await type_into(page, "task.theta_deg.2", "-0,5rad");
    expect((await poses(page))[1]!.theta_deg).toBeCloseTo((-0.5 * 180) / Math.PI, 12);
    await type_into(page, "task.y.2", "80 mm", "Tab");
    expect((await poses(page))[1]!.y).toBe(80);
    for (let steps = 0; steps < 3; ++steps) await page.keyboard.press("Control+z");
    expect(await poses(page)).toEqual(before);

    await page.getByTestId("task.x.4").focus();
    for (const key of ["ArrowUp", "Shift+ArrowUp", "Alt+ArrowDown"]) await page.keyboard.press(key);
    expect((await poses(page))[3]!.x).toBe(-209.1);
    await page.keyboard.press("Control+z"); // steps within a second are one
    expect(await poses(page)).toEqual(before);
  });

  test("says what is wrong and keeps the last good value", async ({page}) => {
    const before = await poses(page);
    await type_into(page, "task.y.2", "12elve", "Tab"); // a letter alone is handed on to the page
    await expect(page.getByTestId("task.y.2")).toHaveAttribute("aria-invalid", "true");
    await expect(page.getByTestId("task.fault")).toContainText(
      "must be a number between −1 000 000 000 and 1 000 000 000. The last valid value is kept.",
    );
    expect(await poses(page)).toEqual(before);
    await page.getByTestId("task.y.2").focus();
    await page.keyboard.press("Escape");
    await expect(page.getByTestId("task.fault")).toHaveCount(0);
    await expect(page.getByTestId("task.y.2")).toHaveValue("75");
    await type_into(page, "task.y.2", "1e10", "Tab");
    await expect(page.getByTestId("task.fault")).toBeVisible();
    await type_into(page, "task.y.2", "75", "Tab");
    await expect(page.getByTestId("task.fault")).toHaveCount(0);

    // Refused by the engine: the same pose twice. Typed cell by cell, only the last one makes it so.
    await paste_into(page, "task.x.2", "0\t0\t0");
    await expect(page.getByTestId("task.fault").first()).toContainText("Position 2 is the same as an earlier one.");
    await expect(page.getByTestId("task.x.2")).toHaveAttribute("aria-invalid", "true");
    expect(await poses(page)).toEqual(before);
  });

  test("takes a pasted block as one step", async ({page}) => {
    const before = await poses(page);
    await paste_into(
      page,
      "task.x.1",
      "x\ty\tθ\r\n0\t0\t0\r\n-120,5\t80\t-25\r\n-210\t225,25\t-50\r\n-220\t440\t-80\r\n",
    );
    expect(await poses(page)).toEqual([
      {x: 0, y: 0, theta_deg: 0},
      {x: -120.5, y: 80, theta_deg: -25},
      {x: -210, y: 225.25, theta_deg: -50},
      {x: -220, y: 440, theta_deg: -80},
    ]);
    await page.keyboard.press("Control+z");
    expect(await poses(page)).toEqual(before);
    await paste_into(page, "task.y.3", "221; -53\n451; -83");
    expect((await poses(page)).slice(2)).toEqual([
      {x: -220, y: 221, theta_deg: -53},
      {x: -220, y: 451, theta_deg: -83},
    ]);
    await page.keyboard.press("Control+z");
    await paste_into(page, "task.x.1", "1\t2\t3\n4\tfive\t6");
    await expect(page.getByTestId("task.fault")).toHaveText(
      "Row 2, column 2: “five” is not a number. Nothing was pasted.",
    );
    expect(await poses(page)).toEqual(before);
  });

  test("reorders by keys and by drag, doubles, adds, removes, changes the reference", async ({page}) => {
    const before = await poses(page),
      [a, b, c, d] = before;
    await page.getByTestId("task.reorder.1").focus();
    await page.keyboard.press("Alt+ArrowDown");
    expect(await poses(page)).toEqual([b, a, c, d]);
    await expect(page.getByTestId("task.reorder.2")).toBeFocused();
    await page.keyboard.press("Control+z");
    expect(await poses(page)).toEqual(before);

    const from = (await page.getByTestId("task.reorder.4").boundingBox())!,
      to = (await page.getByTestId("task.reorder.2").boundingBox())!;
    await page.mouse.move(from.x + 8, from.y + 12);
    await page.mouse.down();
    await page.mouse.move(to.x + 8, to.y + 12, {steps: 5});
    expect(await poses(page)).toEqual([a, d, b, c]);
    await page.keyboard.press("Escape");
    expect(await poses(page)).toEqual(before);
    await page.mouse.up();
    await page.mouse.move(from.x + 8, from.y + 12);
    await page.mouse.down();
    await page.mouse.move(to.x + 8, to.y + 12, {steps: 5});
    await page.mouse.up();
    expect(await poses(page)).toEqual([a, d, b, c]);
    await read_state(page, (workbench) => workbench.undo()); // one drag, one step
    expect(await poses(page)).toEqual(before);

    await page.getByTestId("task.add").click();
    expect((await poses(page))[4]).toEqual({x: -220, y: 680, theta_deg: -112});
    await page.getByTestId("task.add").click();
    await expect(page.getByTestId("task.missing")).toContainText("6 positions");
    for (const row of [6, 5]) {
      await page.getByTestId(`task.menu.${row}`).click();
      await page.getByTestId("task.remove").click();
    }
    expect(await poses(page)).toEqual(before);

    await page.getByTestId("task.menu.3").click();
    await page.getByTestId("task.make_reference").click();
    const moved = await poses(page);
    expect(moved[2]).toEqual({x: 0, y: 0, theta_deg: 0});
    expect(Math.hypot(moved[3]!.x - moved[0]!.x, moved[3]!.y - moved[0]!.y)).toBeCloseTo(
      Math.hypot(d!.x - a!.x, d!.y - a!.y),
      9,
    );
    await until_settled(page);
    // The same linkage, seen from elsewhere.
    const {lengths} = await read_state(page, (workbench) => workbench.hand!);
    await read_state(page, (workbench) => workbench.undo());
    await until_settled(page);
    const original = await read_state(page, (workbench) => workbench.hand!.lengths!);
    for (const link of ["ground", "input", "coupler", "output"] as const)
      expect(lengths![link] / original[link]).toBeCloseTo(1, 9);
  });

  test("holds directions and curvatures of travel", async ({page}) => {
    await page.getByTestId("task.menu.2").click();
    await page.getByTestId("task.tangent").click();
    await expect(page.getByTestId("task.pattern")).toHaveText("P-PP-P-P");
    await type_into(page, "task.direction_deg.2", "120");
    const {x, y} = (await poses(page))[1]!.derivatives![0]!;
    expect(x).toBeCloseTo(Math.cos((120 * Math.PI) / 180), 12);
    expect(y).toBeCloseTo(Math.sin((120 * Math.PI) / 180), 12);
    await page.getByTestId("task.menu.2").click();
    await page.getByTestId("task.curvature").click();
    await expect(page.getByTestId("task.pattern")).toHaveText("P-PPP-P-P");
    await page.getByTestId("task.pattern").hover();
    await expect(page.getByRole("tooltip")).toBeVisible();
    await page.getByTestId("task.menu.2").click();
    await page.getByTestId("task.next_derivative").click();
    await type_into(page, "task.curvature.2.3", "0.002");
    await type_into(page, "task.direction_deg.2", "60"); // keeps what stands below it
    await expect(page.getByTestId("task.curvature.2.3")).toHaveValue("0.002");
    await expect(page.getByTestId("task.pattern")).toHaveText("P-PPPP-P-P");
    await page.getByTestId("task.remove_derivative.2.2").click();
    await expect(page.getByTestId("task.pattern")).toHaveText("P-PP-P-P");
    await page.getByTestId("task.remove_derivative.2.1").click();
    expect(await poses(page)).toEqual(example("tailgate").task.poses);
  });
});

test.describe("requirements", () => {
  test("none left: the sentence names a value, and the value keeps its promise", async ({page}) => {
    await type_into(page, "req.min_transmission.number", "89");
    await until_settled(page);
    expect(await meeting(page)).toBe(0);
    await expect(page.getByTestId("req.none_left")).toContainText("The transmission angle is the most restrictive");
    const problem = example("tailgate");
    problem.requirements.min_transmission_angle_deg = 89;
    const {relax} = solve(problem);
    const [promise] = await read_state(page, (workbench) => workbench.census!.relax);
    expect(promise!.requirement).toBe("min_transmission_angle_deg");
    expect(relax[0].leaves).toBe(promise!.leaves);
    const button = page.getByTestId("req.relax.min_transmission_angle_deg");
    await expect(button).toHaveText(`${promise!.value}° would leave ${grouped(promise!.leaves)}`);
    await keep_screenshot(page, "none-left");
    await button.click();
    await until_settled(page);
    expect(promise!.leaves).toBeGreaterThan(0);
    expect(await meeting(page)).toBe(promise!.leaves);
    await expect(page.getByTestId("req.none_left")).toHaveCount(0);

    // Rows stay where they are under the hand that types, whatever becomes of the counts.
    const tops = () =>
      page
        .locator("[data-testid^='req.row.']")
        .evaluateAll((rows) => rows.map((row) => row.getBoundingClientRect().top));
    const field = page.getByTestId("req.max_length"),
      before = await tops();
    await field.focus();
    await field.fill("5");
    await field.press("Enter");
    await until_settled(page);
    expect(await meeting(page)).toBe(0);
    expect(await tops()).toEqual(before);
  });

  test("each is worth exactly what it says", async ({page}) => {
    const keys = Object.keys(planar_requirements) as RequirementKey[],
      asked = keys.slice(2);
    await page.getByTestId("req.types.double_crank").click();
    await type_into(page, "req.max_length", "300");
    await until_settled(page);
    let worth_something = 0;
    for (const key of ["types" as const, ...asked]) {
      const before = await meeting(page),
        only = await read_state(page, (workbench, bit) => workbench.census!.only[bit], keys.indexOf(key));
      const drop = page.getByTestId(`req.without.${key}`);
      await expect(drop).toHaveText(`+${grouped(only!)} if dropped`);
      await drop.click();
      await until_settled(page);
      expect(await meeting(page), key).toBe(before + only!);
      await read_state(page, (workbench) => workbench.undo());
      await until_settled(page);
      expect(await meeting(page)).toBe(before);
      if (only! > 0) ++worth_something;
    }
    expect(worth_something).toBeGreaterThan(3);

    // "No defects" goes alone only where no transmission angle is asked for.
    await page.getByTestId("req.without.min_transmission_angle_deg").click();
    await until_settled(page);
    const before = await meeting(page),
      [, only] = await read_state(page, (workbench) => workbench.census!.only);
    expect(only).toBeGreaterThan(0);
    await page.getByTestId("req.without.no_defects").click();
    await until_settled(page);
    expect(await meeting(page)).toBe(before + only!);
  });

  test("the slider is live, one drag is one undo, Esc takes it back", async ({page}) => {
    const before = await read_state(page, (workbench) => JSON.stringify(workbench.problem));
    const slider = page.getByTestId("req.min_transmission"),
      box = (await slider.boundingBox())!;
    const at = (share: number) => [box.x + 8 + share * (box.width - 16), box.y + box.height / 2] as const;
    await page.mouse.move(...at(30 / 89));
    await page.mouse.down();
    const seen = new Set<number>();
    for (const share of [0.45, 0.6, 0.75]) {
      await page.mouse.move(...at(share));
      await until_settled(page);
      seen.add(await meeting(page));
    }
    expect(seen.size).toBe(3);
    await page.keyboard.press("Escape");
    expect(await read_state(page, (workbench) => JSON.stringify(workbench.problem))).toBe(before);
    await page.mouse.up();
    await expect(slider).toHaveValue("30");
    await page.mouse.move(...at(30 / 89));
    await page.mouse.down();
    for (const share of [0.45, 0.6, 0.75]) await page.mouse.move(...at(share));
    await page.mouse.up();
    await page.waitForFunction(() => !(globalThis as unknown as Hooked).__linkwright.workbench.gesture);
    expect(
      await read_state(page, (workbench) => workbench.problem.requirements!.min_transmission_angle_deg),
    ).toBeGreaterThan(50);
    await read_state(page, (workbench) => workbench.undo());
    expect(await read_state(page, (workbench) => [JSON.stringify(workbench.problem), workbench.can_undo])).toEqual([
      before,
      false,
    ]);
  });

  test("every cell in full colour has its ground pivots in the box", async ({page}) => {
    await page.getByTestId("req.ground_box.draw").click();
    expect(await read_state(page, (workbench) => workbench.mode)).toBe("ground_box");
    await page.getByTestId("req.ground_box.draw").click();
    for (const [side, value] of [
      ["x0", "100"],
      ["x1", "300"],
      ["y0", "280"],
      ["y1", "380"],
    ])
      await type_into(page, `req.ground_box.${side}`, value!, "Tab");
    await until_settled(page);
    const taus = await read_state(page, (workbench) => {
      const {fails, input_tau, output_tau, samples} = workbench.map!;
      const found: [number, number][] = [];
      for (let cell = 0; found.length < 50 && cell < 50 * fails.length; cell += 7919) {
        // a prime: all over the map
        if (fails[cell % fails.length] === 0)
          found.push([
            input_tau[Math.floor((cell % fails.length) / samples)]!,
            output_tau[(cell % fails.length) % samples]!,
          ]);
      }
      return found;
    });
    expect(taus).toHaveLength(50);
    for (const tau of taus) {
      await read_state(page, (workbench, to) => workbench.hover(to), tau);
      await page.waitForFunction(
        (to) => (globalThis as unknown as Hooked).__linkwright.workbench.hand?.tau.join() === to,
        tau.join(),
      );
      for (const side of ["input", "output"]) {
        const text = await page.getByTestId(`num.${side}_center`).innerText();
        const [x, y] = text.replaceAll("−", "-").split(", ").map(Number);
        expect(x! >= 99.95 && x! <= 300.05 && y! >= 279.95 && y! <= 380.05, `${tau}: ${text}`).toBe(true);
      }
    }
  });

  test("are put back by Reset, and limits take nothing for an answer", async ({page}) => {
    await type_into(page, "req.max_ratio", "");
    await page.getByTestId("req.max_ratio").fill("");
    await page.keyboard.press("Enter");
    expect(await read_state(page, (workbench) => workbench.problem.requirements!.max_link_ratio)).toBeNull();
    await type_into(page, "req.max_ratio", "0.5", "Tab");
    await expect(page.getByTestId("req.row.max_link_ratio")).toContainText(
      "Link ratio at most must be a number not below 1.",
    );
    await page.getByTestId("req.reset").click();
    expect(await read_state(page, (workbench) => Object.keys(workbench.problem.requirements!).sort())).toEqual([
      "max_length",
      "min_transmission_angle_deg",
    ]);
    await page.getByTestId("req.no_defects").uncheck();
    await until_settled(page);
    expect(await read_state(page, (workbench) => workbench.problem.requirements!)).toMatchObject({no_defects: false});
    await expect(page.getByTestId("req.min_transmission")).toBeDisabled();
  });
});

test.describe("numbers", () => {
  test("are those of the program", async ({page}) => {
    const {linkages} = solve(example("tailgate"));
    for (const found of linkages.slice(0, 4)) {
      const tau: TauPair = [found.input.coordinate, found.output.coordinate];
      await pick(page, tau);
      const hand = await read_state(page, (workbench) => workbench.hand!);
      for (const link of ["ground", "input", "coupler", "output"] as const) {
        expect(hand.lengths![link] / found.lengths[link]).toBeCloseTo(1, 11);
        await expect(page.getByTestId(`num.${link}`)).toHaveText(`${found.lengths[link].toFixed(2)} mm`);
      }
      const angle = (value: number) => `${value.toFixed(1)}°`;
      await expect(page.getByTestId("num.min_task")).toHaveText(angle(found.min_transmission_angle_deg));
      await expect(page.getByTestId("num.ratio")).toHaveText(found.link_ratio.toFixed(2));
      await expect(page.getByTestId("num.sweep")).toHaveText(
        `${angle(found.driver_sweep_deg)} ${found.drive === "cw" ? "↻" : "↺"}`,
      );
      await expect(page.getByTestId("num.input_center")).toHaveText(
        found.input.center_point.map((v: number) => v.toFixed(1).replace("-", "−")).join(", "),
      );
      await expect(page.getByTestId("num.output_circle")).toHaveText(
        found.output.circle_point.map((v: number) => v.toFixed(1).replace("-", "−")).join(", "),
      );
      await expect(page.getByTestId("num.verdict")).toHaveText("✓ No defects, verified by simulation");
      await expect(page.getByTestId("num.verified")).toBeVisible();
      if (found.min_transmission_angle_full_turn_deg !== null)
        await expect(page.getByTestId("num.min_turn")).toHaveText(angle(found.min_transmission_angle_full_turn_deg));
      if (found.swapped.min_transmission_angle_deg !== null)
        await expect(page.getByTestId("num.swapped")).toContainText(
          `γ ${angle(found.swapped.min_transmission_angle_deg)}`,
        );
    }
  });

  test("say what fails, copy as a row, and are saved as DXF", async ({page, context}) => {
    await context.grantPermissions(["clipboard-read", "clipboard-write"]);
    await pick(page, [1.3125, 1.1125]);
    await expect(page.getByTestId("num.type")).toHaveText("Triple rocker, output longest");
    await expect(page.getByTestId("num.min_task")).toHaveText("73.5°");
    await page.getByTestId("num.copy_lengths").click();
    const row = (await page.evaluate(() => navigator.clipboard.readText())).split("\t").map(Number);
    [65.03, 211.05, 53.92, 255.9].forEach((length, i) => expect(row[i]).toBeCloseTo(length, 2));
    await page.getByTestId("num.copy.input_center").click();
    expect(
      (await page.evaluate(() => navigator.clipboard.readText()))
        .split("\t")
        .map(Number)
        .map((v) => v.toFixed(1)),
    ).toEqual(["179.0", "348.5"]);

    const [download] = await Promise.all([page.waitForEvent("download"), page.getByTestId("num.dxf").click()]);
    expect(download.suggestedFilename()).toMatch(/^tailgate-hinge.*\.dxf$/);
    expect(readFileSync(await download.path(), "utf8")).toContain("EOF");

    await type_into(page, "req.max_length", "250");
    await expect(page.getByTestId("toast.title")).toContainText(
      "no longer met the requirements; this is the best that does",
    );
    await expect(page.getByTestId("num.missed")).toHaveCount(0);
    await page.getByTestId("toast.state.keep_old").click();
    await until_settled(page);
    await expect(page.getByTestId("num.missed")).toHaveText("Not met: longest link (250 mm at most)");

    const defective = await read_state(page, (workbench) => {
      const {defects, type, input_tau, output_tau, samples} = workbench.map!;
      const cell = defects.findIndex((bits, i) => bits === 1 && type[i]! < 8);
      return [input_tau[Math.floor(cell / samples)], output_tau[cell % samples]] as [number, number];
    });
    await pick(page, defective);
    await expect(page.getByTestId("num.verdict")).toHaveText("✕ Order defect");
    await expect(page.getByTestId("num.reason")).toContainText(
      /Order defect: this linkage reaches the positions as [1-4](-[1-4]){3}\./,
    );
    await expect(page.getByTestId("num.min_task")).toHaveText("–");
    await expect(page.getByTestId("num.verified")).toHaveCount(0);
    await page.getByTestId("export.title").click();
    await expect(page.getByTestId("export.mind")).toContainText(
      /^Before you build it: Order defect: this linkage reaches the positions as /,
    );
  });
});

test.describe("pins", () => {
  test("are kept, named, shown, compared and taken away", async ({page}) => {
    const {linkages} = solve(example("tailgate"));
    const first: TauPair = [linkages[0].input.coordinate, linkages[0].output.coordinate];
    await pick(page, first);
    await page.getByTestId("pin.add").click();
    await pick(page, [1.3125, 1.1125]);
    await page.getByTestId("pin.add").click();
    await expect(page.getByTestId("pin.row.A")).toContainText("83.7°");
    await expect(page.getByTestId("pin.row.B")).toContainText("256");
    await page.getByTestId("pin.eye.A").click();
    expect(await read_state(page, (workbench) => workbench.pins.map((pin) => !!pin.shown))).toEqual([true, false]);
    await page.getByTestId("pin.menu.B").click();
    await page.getByTestId("pin.rename").click();
    await page.keyboard.type("A");
    await page.keyboard.press("Enter");
    await expect(page.getByText("There is a pin A already.")).toBeVisible();
    await page.getByTestId("pin.name").fill("Slim");
    await page.getByTestId("pin.note").fill("=clears the <b>cable</b>");
    await page.keyboard.press("Enter");
    await expect(page.getByTestId("pin.row.Slim")).toBeVisible();
    await expect(page.getByText("=clears the <b>cable</b>")).toBeVisible();
    await page.getByTestId("pin.pick.A").click();
    expect(await read_state(page, (workbench) => workbench.picked!.tau)).toEqual(first);

    await page.getByTestId("pin.compare").click();
    const dialog = page.getByTestId("pin.compare_dialog");
    await expect(dialog.getByRole("img")).toHaveCount(2);
    await expect(dialog.locator(".u-over")).toBeVisible();
    await expect(page.getByTestId("pin.value.min_transmission_angle_deg.A")).toHaveClass(/best/);
    await expect(page.getByTestId("pin.value.min_transmission_angle_deg.Slim")).toHaveText(/73\.5°\s*−10\.1°/);
    const order = () => dialog.getByTestId("pin.column").locator(".name").allInnerTexts();
    expect(await order()).toEqual(["A", "Slim"]);
    await page.getByTestId("pin.sort.ground").click();
    expect(await order()).toEqual(["Slim", "A"]); // 65 mm before 83 mm
    const links = () =>
      dialog.locator("path.link.input").evaluateAll((lines) => lines.map((line) => line.getAttribute("d")));
    const closed = await links();
    await page.getByTestId("pin.scrub").fill("2.5");
    expect((await links()).every((line, i) => line !== closed[i])).toBe(true); // one scrub moves both
    await expect_accessible(page, "[data-testid='pin.compare_dialog']");
    await keep_screenshot(page, "compare");
    const [download] = await Promise.all([page.waitForEvent("download"), page.getByTestId("pin.export_table").click()]);
    const table = readFileSync(await download.path(), "utf8")
      .split("\r\n")
      .map((line) => line.replace("\ufeff", "").split(","));
    expect(table[0]).toEqual(["Name", "Slim", "A"]);
    const longest = table.find((row) => row[0]!.startsWith("Longest link"))!;
    expect(Number(longest[2]) / linkages[0].lengths.input).toBeCloseTo(1, 9);
    expect(table.at(-2)![1]).toBe("'=clears the <b>cable</b>");
    await page.keyboard.press("Escape");
    await expect(dialog).toHaveCount(0);

    await page.getByTestId("pin.menu.Slim").click();
    await page.getByTestId("pin.delete").click();
    await expect(page.getByTestId("pin.row.Slim")).toHaveCount(0);
    await read_state(page, (workbench) => workbench.undo());
    await expect(page.getByTestId("pin.row.Slim")).toBeVisible();
  });

  test("remember the task in which they were pinned", async ({page}) => {
    await pick(page, [1.3125, 1.1125]);
    await page.getByTestId("pin.add").click();
    await type_into(page, "task.x.3", "-219.5");
    await expect(page.getByText("From an earlier task")).toBeVisible();
    await page.getByTestId("pin.bring_back.A").click();
    await until_settled(page);
    expect(await poses(page)).toEqual(example("tailgate").task.poses);
    expect(await read_state(page, (workbench) => workbench.hand!.tau)).toEqual([1.3125, 1.1125]);
    await expect(page.getByText("From an earlier task")).toHaveCount(0);
  });
});

test("the panels are accessible, light and dark; the status line switches snapping", async ({page}) => {
  await page.getByTestId("pin.add").click();
  for (const theme of ["light", "dark"]) {
    await page.evaluate((name) => ((globalThis as unknown as Hooked).__linkwright.preferences.theme = name), theme);
    await page.waitForFunction((name) => document.documentElement.dataset.theme === name, theme);
    for (const part of ["task.title", "req.title", "pin.title", "num.title"])
      await expect_accessible(page, `[data-testid='${part}']`);
    await expect_accessible(page, "footer");
  }
  await expect(page.getByTestId("status.tau")).toContainText("τ₁");
  await page.getByTestId("status.snap").click();
  await expect(page.getByTestId("status.snap")).toHaveText("snap off");
  expect(await page.evaluate(() => (globalThis as unknown as Hooked).__linkwright.preferences.snap)).toBe(false);
});
