import {describe, expect, it} from "vitest";
import {peak_and_most, shown_bins, shown_positions, steps_path} from "./histograms";

describe("histograms", () => {
  it("are of all positions, or of a few evenly where there are many", () => {
    expect(shown_positions(4)).toEqual([0, 1, 2, 3]);
    expect(shown_positions(21)).toEqual([0, 4, 8, 12, 16, 20]);
  });
  it("end with the last sample, or with the limit", () => {
    const histograms = {
      from: 0,
      to: 1,
      counts: [
        [5, 2, 0, 0],
        [1, 1, 1, 0],
      ],
    };
    expect(shown_bins(histograms, null)).toBe(3);
    expect(shown_bins(histograms, 6.5)).toBe(8);
  });
  it("are steps over their foot", () => {
    expect(steps_path([1, 2], 2, 10, 8)).toBe("M0 8L0 4H5L5 0H10V8Z");
  });
  it("are told by their peak and their end", () => {
    expect(peak_and_most([1, 3, 2, 0], 0, 4)).toEqual({peak: 1.5, most: 3});
  });
});
