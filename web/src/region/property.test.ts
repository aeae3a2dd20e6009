import {describe, expect, it} from "vitest";
import type {Requirements} from "../contract/messages";
import type {Tolerances} from "../analyses/tolerances/block";
import {new_problem} from "../kinds/motion/kind";
import {
  colorings_of,
  contour_levels,
  domain,
  held_threshold,
  painted_range,
  threshold,
  unit_for,
  value_text,
} from "./property";

const {task} = new_problem();
const shown = (requirements: Requirements, tolerances?: Tolerances) => ({
  problem: {task, tolerances},
  task: {requirements, characteristic_length: 100},
});

describe("property", () => {
  it("spans what the requirements allow and somewhat more", () => {
    expect(domain("link_ratio", shown({max_link_ratio: 8}))).toEqual([1, 10]);
    expect(domain("longest_link", shown({max_length: 400}))).toEqual([0, 500]);
    expect(domain("longest_link", shown({max_length: null}))).toEqual([0, 1250]);
    expect(domain("min_transmission_angle_deg", shown({}))).toEqual([0, 90]);
  });
  it("has good at the light end", () => {
    expect(painted_range("link_ratio", [1, 10])).toEqual({from: 10, to: 1});
    expect(painted_range("min_transmission_angle_deg", [0, 90])).toEqual({from: 0, to: 90});
  });
  it("moves a threshold in whole steps within what the engine takes", () => {
    expect(held_threshold("min_transmission_angle_deg", 91)).toBe(89);
    expect(held_threshold("link_ratio", 0.2)).toBe(1);
    expect(held_threshold("longest_link", 452.3)).toBe(450);
    expect(threshold("min_transmission_angle_deg", {no_defects: false})).toBeNull();
    expect(threshold("longest_link", {max_length: 5})).toBe(5);
  });
  it("draws the requirement among the contours, in bold", () => {
    const levels = contour_levels("min_transmission_angle_deg", shown({min_transmission_angle_deg: 33}));
    expect(levels.map((l) => l.level)).toEqual([30, 33, 45, 60, 75]);
    expect(levels.filter((l) => l.bold)).toEqual([{level: 33, bold: true}]);
  });
  it("spans errors in equal ratios, from what the tolerances themselves are", () => {
    expect(domain("tolerance_error", shown({}, {length: 0.5}))).toEqual([0.5, 500]);
    expect(domain("tolerance_error", shown({}, {length: {coupler: 0.1}, clearance: 0.03}))).toEqual([0.1, 100]);
    expect(painted_range("tolerance_error", [0.5, 200])).toEqual({from: 200, to: 0.5, logarithmic: true});
    const levels = contour_levels("tolerance_error", shown({max_tolerance_error: 3}, {length: 0.5}));
    expect(levels.map(({level}) => level)).toEqual([0.5, 1, 2, 3, 5, 10, 20, 50, 100, 200, 500]);
    expect(levels.filter(({bold}) => bold)).toEqual([{level: 3, bold: true}]);
  });
  it("is told of tolerances only where there are some, and a limit", () => {
    const of = (tolerances?: Tolerances) => colorings_of({...new_problem(), tolerances});
    expect(of()).not.toContain("tolerance_error");
    expect(of({length: 1})).toContain("tolerance_error");
    expect(of({length: 1})).not.toContain("yield");
    expect(of({length: 1, limit: {position: 2}}).slice(-2)).toEqual(["tolerance_error", "yield"]);
  });
  it("has units and per cent", () => {
    expect(
      value_text("tolerance_error", 0.6573, unit_for("tolerance_error", {problem: new_problem(), unit: "mm"})),
    ).toBe("0.657 mm");
    expect(value_text("tolerance_error", 0.6573, "°")).toBe("0.657°");
    expect(value_text("yield", 0.98351, "")).toBe("98.4\u00a0%");
    expect(value_text("yield", 0.99999, "")).toBe("99.9\u00a0%");
    expect(value_text("yield", 1, "")).toBe("100\u00a0%");
    expect(held_threshold("yield", 1.2)).toBe(1);
  });
});
