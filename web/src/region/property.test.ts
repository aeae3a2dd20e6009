import {describe, expect, it} from "vitest";
import {contour_levels, domain, held_threshold, painted_range, threshold} from "./property";

describe("property", () => {
  it("spans what the requirements allow and somewhat more", () => {
    expect(domain("link_ratio", {max_link_ratio: 8}, 100)).toEqual([1, 10]);
    expect(domain("longest_link", {max_length: 400}, 100)).toEqual([0, 500]);
    expect(domain("longest_link", {max_length: null}, 100)).toEqual([0, 1250]);
    expect(domain("min_transmission_angle_deg", {}, 100)).toEqual([0, 90]);
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
    const levels = contour_levels("min_transmission_angle_deg", {min_transmission_angle_deg: 33}, 1);
    expect(levels.map((l) => l.level)).toEqual([30, 33, 45, 60, 75]);
    expect(levels.filter((l) => l.bold)).toEqual([{level: 33, bold: true}]);
  });
});
