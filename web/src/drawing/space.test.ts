import {describe, expect, it} from "vitest";
import {no_keys} from "./snapping";
import {Plane} from "./space";

const view = {x: 100, y: 50, scale: 2, width: 400, height: 300};
const plane = new Plane(view, true);

describe("the plane", () => {
  it("shows its middle in the middle, y up, and finds back", () => {
    expect(plane.project([100, 50])).toEqual([200, 150]);
    expect(plane.project([110, 60])).toEqual([220, 130]);
    expect(plane.unproject([220, 130])).toEqual([110, 60]);
    expect(plane.shows([110, 60])).toBe(true);
    expect(plane.shows([301, 50])).toBe(false);
    expect(plane.shows([299, 50], 12)).toBe(false);
  });
  it("snaps to its steps and lines up with others, unless the user wants neither", () => {
    expect(plane.step).toBe(5);
    expect(plane.snapped([0, 0], [12.4, 17.6], no_keys)).toEqual({point: [10, 20], guides: []});
    expect(plane.snapped([0, 0], [12.4, 17.6], no_keys, [[13, 100]])).toEqual({
      point: [13, 20],
      guides: [{axis: "x", value: 13}],
    });
    expect(new Plane(view, false).snapped([0, 0], [12.4, 17.6], no_keys).point).toEqual([12.4, 17.6]);
  });
  it("rules lines a round number of units apart", () => {
    expect(plane.grid_path().match(/V/g)).toHaveLength(11); // 0, 20, … 200
    expect(plane.guide_path({axis: "x", value: 110})).toBe("M220 0V300");
    expect(plane.guide_path({axis: "y", value: 60})).toBe("M0 130H400");
  });
});
