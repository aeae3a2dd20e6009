import {describe, expect, it} from "vitest";
import {in_force, is_asked, unit_of, value_text} from "../../requirements/requirements";
import {first_example} from "../../gallery/gallery";
import {task_kinds, with_other_task, without_unmet} from "../../kinds/kind_dispatch";
import {
  contour_levels,
  domain,
  held_threshold,
  threshold,
  unit_for,
  value_text as colour_text,
} from "../../region/property";
import {typical_force} from "./criteria";
import {missed_limit} from "./read_outs";

const {problem} = first_example!,
  loads = {body: {mass: 20}, handle: {point: [0, 0] as const}},
  loaded = {...problem, loads};
const shown = (requirements: object) => ({
  problem: loaded,
  task: {requirements, characteristic_length: 300},
});

describe("forces", () => {
  it("span what the weights are", () => {
    expect(typical_force(loads)).toBeCloseTo(196.2);
    expect(typical_force({gravity: null, body: {mass: 20}})).toBe(100);
    expect(domain("hand_force", shown({}))).toEqual([0, 500]);
    expect(domain("max_open_force", shown({}))).toEqual([-250, 500]);
    expect(domain("hold_open", shown({}))).toEqual([-500, 500]);
    const [, pins] = domain("max_pin_force", shown({}));
    expect(pins).toBeGreaterThanOrEqual(588);
  });
  it("are told in newtons, torques in newton metres where the unit is known", () => {
    const units = {problem: loaded, unit: "mm"};
    expect(unit_for("hand_force", units)).toBe("N");
    expect(unit_for("max_torque", units)).toBe("N·m");
    expect(unit_for("max_torque", {...units, unit: "ell"})).toBe("N·ell");
    expect(colour_text("hand_force", -12.34, "N")).toBe("−12.3 N");
    expect(unit_of("max_pin_force", units)).toBe("N");
    expect(value_text("max_open_force", 60, units)).toBe("60 N");
  });
  it("have thresholds below zero, too", () => {
    expect(threshold("hold_open", {min_hold_open: -5})).toBe(-5);
    expect(held_threshold("hold_open", -12.4)).toBe(-12);
    expect(contour_levels("max_open_force", shown({max_open_force: -20}))).toContainEqual({level: -20, bold: true});
    expect(contour_levels("max_open_force", shown({})).map(({level}) => level)).toContain(0);
    expect([0, -5].map((min_hold_open) => is_asked({min_hold_open}, "min_hold_open"))).toEqual([true, true]);
    expect(is_asked({min_hold_open: null}, "min_hold_open")).toBe(false);
  });
  it("are missed by a case that counts", () => {
    const about = {
      requirements: in_force({problem: {...loaded, requirements: {max_open_force: 60}}, task: null}),
      unit: "mm",
    };
    expect(missed_limit("max_open_force", 61, {name: "room"}, about)).toBe("needs ≤ 60 N: 1 N too much");
    expect(missed_limit("max_open_force", 61, {name: "cold", for: ["hold_open"]}, about)).toBeNull();
    expect(missed_limit("max_open_force", 59, {name: "room"}, about)).toBeNull();
    expect(missed_limit("hold_open", 4, undefined, {...about, requirements: {min_hold_open: 5}})).toBe(
      "needs ≥ 5 N: 1 N short",
    );
  });
});

describe("what is asked of loads", () => {
  it("goes with them", () => {
    const asked = {
      ...loaded,
      requirements: {...problem.requirements, max_open_force: 60, max_pin_force: 900},
      options: {objective: "hand_force" as const},
    };
    expect(without_unmet(asked)).toEqual(asked);
    const without_hand = without_unmet({...asked, loads: {body: {mass: 20}, drive: "input"}});
    expect(without_hand.requirements).toEqual({...problem.requirements, max_pin_force: 900});
    expect(without_hand.options).toEqual({});
    const [others] = task_kinds.filter((kind) => kind.analysed && !kind.analysed.loads),
      other = with_other_task(asked, others!.beginnings[0]!.make().task);
    expect(other).not.toHaveProperty("loads");
    expect(other.requirements).not.toHaveProperty("max_pin_force");
  });
});
