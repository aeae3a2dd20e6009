// Requirements (walk-throughs 7, 8, 10).
import type {Page} from "@playwright/test";
import type {RequirementKey} from "../src/contract/messages";
import {planar_requirements} from "../src/tasks/planar";
import {
  example,
  expect,
  keep_screenshot,
  open_settled,
  read_state,
  solve,
  test,
  type_into,
  until_settled,
} from "./support";

test.beforeEach(({page}) => open_settled(page));

type Hooked = {__linkwright: {workbench: any; preferences: any}};

const meeting = (page: Page): Promise<number> => read_state(page, (workbench) => workbench.census!.meeting);
const grouped = (count: number) => String(count).replace(/\B(?=(\d{3})+$)/g, "\u202f");

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
    page.locator("[data-testid^='req.row.']").evaluateAll((rows) => rows.map((row) => row.getBoundingClientRect().top));
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
  const asked = (Object.keys(planar_requirements) as RequirementKey[]).slice(2);
  await page.getByTestId("req.types.double_crank").click();
  await type_into(page, "req.max_length", "300");
  await until_settled(page);
  let worth_something = 0;
  for (const key of ["types" as const, ...asked]) {
    const before = await meeting(page),
      only = await read_state(page, (workbench, asked_for) => workbench.census!.only[asked_for]!, key);
    const drop = page.getByTestId(`req.without.${key}`);
    await expect(drop).toHaveText(`+${grouped(only)} if dropped`);
    await drop.click();
    await until_settled(page);
    expect(await meeting(page), key).toBe(before + only);
    await read_state(page, (workbench) => workbench.undo());
    await until_settled(page);
    expect(await meeting(page)).toBe(before);
    if (only > 0) ++worth_something;
  }
  expect(worth_something).toBeGreaterThan(3);

  // "No defects" goes alone only where no transmission angle is asked for.
  await page.getByTestId("req.without.min_transmission_angle_deg").click();
  await until_settled(page);
  const before = await meeting(page),
    only = await read_state(page, (workbench) => workbench.census!.only.no_defects!);
  expect(only).toBeGreaterThan(0);
  await page.getByTestId("req.without.no_defects").click();
  await until_settled(page);
  expect(await meeting(page)).toBe(before + only);
});

test("the slider is live, one drag is one undo, Esc takes it back", async ({page}) => {
  const before = await read_state(page, (workbench) => JSON.stringify(workbench.problem));
  const slider = page.getByTestId("req.min_transmission"),
    box = (await slider.boundingBox())!;
  const at = (share: number) => [box.x + 8 + share * (box.width - 16), box.y + box.height / 2] as const;
  await page.mouse.move(...at(30 / 89));
  await page.mouse.down();
  const seen = new Set<number>(),
    asked = () => read_state(page, (workbench) => workbench.problem.requirements!.min_transmission_angle_deg);
  for (const share of [0.45, 0.6, 0.75]) {
    const last = await asked();
    await page.mouse.move(...at(share));
    await expect.poll(asked).not.toBe(last); // a slider hears of the pointer with the next frame
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

test("a drag that begins before the last one's end has been heard is a step of its own", async ({page}) => {
  const slider = page.getByTestId("req.min_transmission");
  await slider.evaluate((input: HTMLInputElement) => {
    const at = (angle: number) => {
      input.value = String(angle);
      input.dispatchEvent(new Event("input", {bubbles: true}));
    };
    for (const angles of [
      [40, 45],
      [50, 55, 60],
    ]) {
      input.dispatchEvent(new PointerEvent("pointerdown", {bubbles: true, button: 0}));
      angles.forEach(at);
      input.dispatchEvent(new PointerEvent("pointerup", {bubbles: true, button: 0}));
    }
  });
  await page.waitForFunction(() => !(globalThis as unknown as Hooked).__linkwright.workbench.gesture);
  const asked = () => read_state(page, (workbench) => workbench.problem.requirements!.min_transmission_angle_deg);
  expect(await asked()).toBe(60);
  await read_state(page, (workbench) => workbench.undo());
  expect(await asked()).toBe(45);
  await read_state(page, (workbench) => workbench.undo());
  expect([await asked(), await read_state(page, (workbench) => workbench.can_undo)]).toEqual([30, false]);
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

test("what a box made larger would leave fits its button, and what is wrong is tied to its field", async ({page}) => {
  await read_state(page, (workbench) =>
    workbench.edit((problem) => ({
      ...problem,
      requirements: {...problem.requirements, ground_pivots_within: {x: [-45, -44.5], y: [175, 175.5]}},
    })),
  );
  const hint = page.getByTestId("req.relax.ground_pivots_within");
  await expect(hint).toBeVisible();
  const box = (await hint.boundingBox())!,
    card = (await page.getByTestId("req.title").boundingBox())!;
  expect(box.x + box.width).toBeLessThanOrEqual(card.x + card.width);
  expect(await hint.evaluate((one) => one.scrollWidth - one.clientWidth)).toBeLessThanOrEqual(0);

  const field = page.getByTestId("req.max_ratio");
  await field.fill("0.5");
  await field.press("Enter");
  const described = await field.getAttribute("aria-describedby");
  await expect(page.locator(`#${described}`)).toContainText("not below 1");
});
