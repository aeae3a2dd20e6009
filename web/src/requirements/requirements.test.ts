import {describe, expect, it} from "vitest";
import type {Box, Linkage, TaskAnswer} from "../contract/messages";
import type {Problem} from "../state/problem";
import {new_problem} from "../kinds/motion/kind";
import {
  all_dropped,
  box_around,
  dropped,
  failing,
  in_force,
  is_asked,
  is_needed,
  missed_box_text,
  relaxation_text,
  relaxed,
  together_text,
  unmet_text,
  value_text,
} from "./requirements";

const linkage = (fails: number, defects = {order: false, branch: false, circuit: false}, type = "crank_rocker") =>
  ({fails, defects, type}) as Linkage;

const {task} = new_problem();

describe("requirements", () => {
  it("takes the engine's defaults where the file is silent", () => {
    const task = {requirements: {no_defects: true, max_link_ratio: 20, max_length: 3711}} as TaskAnswer;
    const problem = {requirements: {max_length: null, max_link_ratio: undefined}} as Problem;
    expect(in_force({problem, task})).toEqual({no_defects: true, max_link_ratio: 20, max_length: null});
  });
  it("knows what is asked", () => {
    expect(is_asked({}, "no_defects")).toBe(true);
    expect(is_asked({types: []}, "types")).toBe(false);
    expect(is_asked({min_transmission_angle_deg: 0}, "min_transmission_angle_deg")).toBe(false);
    expect(is_asked({max_length: null}, "max_length")).toBe(false);
    expect(is_asked({max_length: 5}, "max_length")).toBe(true);
  });
  it("drops and relaxes", () => {
    expect(dropped("max_length")).toEqual({max_length: null});
    expect(dropped("no_defects")).toEqual({no_defects: false, min_transmission_angle_deg: undefined});
    expect(is_needed({min_transmission_angle_deg: 30}, "no_defects")).toBe(true);
    expect(is_needed({}, "no_defects")).toBe(false);
    expect(relaxed("min_transmission_angle_deg", 24.000000000000004)).toEqual({min_transmission_angle_deg: 24});
    expect(relaxed("ground_pivots_within", null)).toEqual({ground_pivots_within: null});
  });
  it("words values", () => {
    const units = (unit: string) => ({problem: new_problem(), unit});
    expect(value_text("min_transmission_angle_deg", 24.000000000000004, units("mm"))).toBe("24°");
    expect(value_text("min_transmission_angle_deg", 24.5, units("mm"))).toBe("24.5°");
    expect(value_text("max_length", 460, units("mm"))).toBe("460 mm");
    expect(value_text("max_length", 460, units(""))).toBe("460");
    expect(value_text("max_link_ratio", 8.25, units("mm"))).toBe("8.25");
    expect(value_text("max_tolerance_error", 0.0015, units("mm"))).toBe("0.0015 mm");
    expect(value_text("min_yield", 0.95, units("mm"))).toBe("95\u00a0%");
  });
  it("names what fails", () => {
    expect(failing(linkage(0b0010100), task)).toEqual(["min_transmission_angle_deg", "max_length"]);
    expect(failing(linkage(0b0000110, {order: true, branch: false, circuit: false}), task)).toEqual([]);
    expect(failing(linkage(0b10000110, {order: false, branch: true, circuit: true}), task)).toEqual([
      "moving_pivots_within",
    ]);
    expect(failing(linkage(0xff, undefined, "degenerate"), task)).toEqual([]);
  });
  it("says what is not met and what to relax", () => {
    const problem = {task, requirements: {min_transmission_angle_deg: 89, max_length: 400}} as Problem,
      asked = {problem, task: null, unit: "mm"};
    expect(unmet_text(linkage(0), asked)).toBeNull();
    expect(unmet_text(linkage(0b1010100), asked)).toBe(
      "Not met: transmission angle (89° at least), longest link (400 mm at most), box for fixed pivots",
    );
    const relaxation = {requirement: "min_transmission_angle_deg", value: 83, only_this: 0, leaves: 34} as const;
    expect(relaxation_text(relaxation, true, "83°")).toBe(
      "The transmission angle is the most restrictive; 83° leaves 34.",
    );
    expect(relaxation_text({...relaxation, value: null}, false, "")).toBe(
      "Without the transmission angle, 34 are left.",
    );
  });
  it("names the requirements that only together leave something, and drops them all", () => {
    const requirements = ["no_defects", "max_length", "ground_pivots_within"] as const;
    expect(together_text({requirements: [...requirements], leaves: 1234})).toBe(
      "No linkage looked at fails a single requirement alone: without no-defects requirement, longest link and box for fixed pivots together, 1\u202f234 are left.",
    );
    expect(all_dropped(requirements)).toEqual({
      no_defects: false,
      min_transmission_angle_deg: undefined,
      max_length: null,
      ground_pivots_within: null,
    });
  });
  it("leads to the nearest box that would do", () => {
    const box = {x: [70, 430], y: [210, 410]} as Box;
    expect(relaxed("ground_pivots_within", box)).toEqual({ground_pivots_within: box});
    expect(value_text("ground_pivots_within", box, {problem: new_problem(), unit: "mm"})).toBe(
      "x 70 … 430, y 210 … 410",
    );
    expect(missed_box_text({requirement: "ground_pivots_within", nearest: [250, 210], beyond: [0, -60]}, "mm")).toBe(
      "The centre-point curve does not enter the box for fixed pivots; nearest is (250, 210), 60 mm further down.",
    );
    expect(missed_box_text({requirement: "moving_pivots_within", nearest: [-5, 3.25], beyond: [7, 2]}, "")).toBe(
      "The circle-point curve does not enter the box for moving pivots; nearest is (−5, 3.25), 7 further right, 2 further up.",
    );
  });
  it("begins with a box around what there is", () => {
    expect(
      box_around([
        [100, 0],
        [200, 50],
      ]),
    ).toEqual({x: [0, 300], y: [-30, 80]});
    expect(box_around([[5, 5]]).x[0]).toBeLessThan(5);
  });
});
