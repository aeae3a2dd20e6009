// Requirements (walk-throughs 7, 8, 10).
import {beforeEach, expect, test} from "vitest";
import {
  click,
  field,
  get,
  is_there,
  open_settled,
  press,
  text,
  type_into,
  until,
  until_settled,
  value_of,
  workbench,
} from "../../tests/page/support";
import {example, solve} from "../../tests/program";
import type {RequirementKey} from "../contract/messages";
import {planar_requirements} from "../kinds/planar";

const meeting = () => workbench.census!.meeting;
const grouped = (count: number) => String(count).replace(/\B(?=(\d{3})+$)/g, "\u202f");
const asked = () => workbench.problem.requirements!.min_transmission_angle_deg;

beforeEach(open_settled);

test("none left: the sentence names a value, and the value keeps its promise", async () => {
  await type_into("req.min_transmission.number", "89");
  await until_settled();
  expect(meeting()).toBe(0);
  expect(text("req.none_left")).toContain("The transmission angle is the most restrictive");
  const problem = example("tailgate");
  problem.requirements.min_transmission_angle_deg = 89;
  const {relax} = solve(problem);
  const [promise] = workbench.census!.relax;
  expect(promise!.requirement).toBe("min_transmission_angle_deg");
  expect(relax[0].leaves).toBe(promise!.leaves);
  const button = "req.relax.min_transmission_angle_deg";
  expect(text(button)).toBe(`${promise!.value}° would leave ${grouped(promise!.leaves).replace("\u202f", " ")}`);
  await click(button);
  await until_settled();
  expect(promise!.leaves).toBeGreaterThan(0);
  expect(meeting()).toBe(promise!.leaves);
  expect(is_there("req.none_left")).toBe(false);
});

test("each is worth exactly what it says", async () => {
  const keys = Object.keys(planar_requirements) as RequirementKey[];
  await click("req.types.double_crank");
  await type_into("req.max_length", "300");
  await until_settled();
  let worth_something = 0;
  for (const key of ["types" as const, ...keys.slice(2)]) {
    const before = meeting(),
      only = workbench.census!.only[key]!;
    expect(get(`req.without.${key}`).textContent!.trim()).toBe(`+${grouped(only)} if dropped`);
    await click(`req.without.${key}`);
    await until_settled();
    expect(meeting(), key).toBe(before + only);
    await press("Control+z");
    await until_settled();
    expect(meeting()).toBe(before);
    if (only > 0) ++worth_something;
  }
  expect(worth_something).toBeGreaterThan(3);

  // "No defects" goes alone only where no transmission angle is asked for.
  await click("req.without.min_transmission_angle_deg");
  await until_settled();
  const before = meeting(),
    only = workbench.census!.only.no_defects!;
  expect(only).toBeGreaterThan(0);
  await click("req.without.no_defects");
  await until_settled();
  expect(meeting()).toBe(before + only);
});

test("a drag of the slider that begins before the last one's end has been heard is a step of its own", async () => {
  const slider = field("req.min_transmission");
  for (const angles of [
    [40, 45],
    [50, 55, 60],
  ]) {
    slider.dispatchEvent(new PointerEvent("pointerdown", {bubbles: true, button: 0}));
    for (const angle of angles) {
      slider.value = String(angle);
      slider.dispatchEvent(new Event("input", {bubbles: true}));
    }
    slider.dispatchEvent(new PointerEvent("pointerup", {bubbles: true, button: 0}));
  }
  await until(() => !workbench.gesture);
  expect(asked()).toBe(60);
  workbench.undo();
  expect(asked()).toBe(45);
  workbench.undo();
  expect([asked(), workbench.can_undo]).toEqual([30, false]);
});

test("every cell in full colour has its ground pivots in the box", async () => {
  await click("req.ground_box.draw");
  expect(workbench.mode).toBe("ground_box");
  await click("req.ground_box.draw");
  for (const [side, typed] of [
    ["x0", "100"],
    ["x1", "300"],
    ["y0", "280"],
    ["y1", "380"],
  ] as const)
    await type_into(`req.ground_box.${side}`, typed, "Tab");
  await until_settled();
  const {fails, input_tau, output_tau, columns} = workbench.map!,
    cells = [...fails.keys()].filter((cell) => fails[cell] === 0),
    some = Array.from({length: 50}, (_, k) => cells[Math.floor((k / 50) * cells.length)]!);
  for (const cell of some) {
    const tau = [input_tau[Math.floor(cell / columns)]!, output_tau[cell % columns]!] as const;
    workbench.hover([...tau]);
    await until(() => workbench.hand?.tau.join() === tau.join());
    for (const side of ["input", "output"]) {
      const [x, y] = text(`num.${side}_center`).replaceAll("−", "-").split(", ").map(Number);
      expect(x! >= 99.95 && x! <= 300.05 && y! >= 279.95 && y! <= 380.05, `${tau}: ${x}, ${y}`).toBe(true);
    }
  }
});

test("are put back by Reset, and limits take nothing for an answer", async () => {
  await type_into("req.max_ratio", "");
  expect(workbench.problem.requirements!.max_link_ratio).toBeNull();
  await type_into("req.max_ratio", "0.5", "Tab");
  expect(text("req.row.max_link_ratio")).toContain("Link ratio at most must be a number not below 1.");
  const described = get("req.max_ratio").getAttribute("aria-describedby")!;
  expect(document.getElementById(described)!.textContent).toContain("not below 1");
  await click("req.reset");
  expect(Object.keys(workbench.problem.requirements!).sort()).toEqual(["max_length", "min_transmission_angle_deg"]);
  await click("req.no_defects");
  await until_settled();
  expect(workbench.problem.requirements!).toMatchObject({no_defects: false});
  expect(field("req.min_transmission").disabled).toBe(true);
});

test("what was typed stays until it is valid or taken back, and no end of a range moves by itself", async () => {
  const box = () => workbench.problem.requirements!.ground_pivots_within!.x,
    sentence = () => get("req.row.ground_pivots_within").querySelector(".fault")?.textContent ?? null;
  await type_into("req.ground_box.x0", "500", "Tab");
  expect(value_of("req.ground_box.x0")).toBe("500");
  expect(get("req.ground_box.x0").getAttribute("aria-invalid")).toBe("true");
  expect(sentence()).toContain("“from” is above “to”");
  expect(box()).toEqual([70, 430]);
  await type_into("req.ground_box.x1", "600");
  expect(sentence()).toBeNull();
  expect(box()).toEqual([500, 600]);
  await click("edit.undo");
  expect(box()).toEqual([70, 430]);
  expect(value_of("req.ground_box.x0")).toBe("70");
  await type_into("req.ground_box.x1", "60");
  expect(sentence()).not.toBeNull();
  await press("Escape");
  expect(value_of("req.ground_box.x1")).toBe("430");
  expect(sentence()).toBeNull();
});
