import {describe, expect, it} from "vitest";
import {bounds, fitted, grid_step, panned, to_screen, to_user, zoomed, type Viewport} from "./viewport";

const view: Viewport = {x: 10, y: 20, scale: 2, width: 400, height: 300};

describe("viewport", () => {
  it("turns y round and back", () => {
    expect(to_screen(view, [10, 20])).toEqual([200, 150]);
    expect(to_screen(view, [11, 21])).toEqual([202, 148]);
    expect(to_user(view, [202, 148])).toEqual([11, 21]);
  });
  it("zooms about the pointer and pans with it", () => {
    const at = [33, 250] as const,
      under = to_user(view, at);
    const near = to_user(zoomed(view, 3.7, at), at);
    expect(near[0]).toBeCloseTo(under[0], 10);
    expect(near[1]).toBeCloseTo(under[1], 10);
    expect(to_user(panned(view, 40, -8), [73, 242])[0]).toBeCloseTo(under[0], 10);
  });
  it("fits a box into margins", () => {
    const fit = fitted({x: [0, 100], y: [0, 10]}, 500, 400, {left: 50, right: 50, top: 100, bottom: 0});
    expect(fit.scale).toBe(4);
    expect(to_screen(fit, [0, 5])).toEqual([50, 250]);
    expect(
      Number.isFinite(fitted({x: [3, 3], y: [4, 4]}, 500, 400, {left: 0, right: 0, top: 0, bottom: 0}).scale),
    ).toBe(true);
  });
  it("finds bounds of what is finite", () => {
    expect(
      bounds([
        [1, 2],
        [NaN, 0],
        [-1, 5],
      ]),
    ).toEqual({x: [-1, 1], y: [2, 5]});
    expect(bounds([])).toBeNull();
  });
  it("has round grid steps of at least 8 px", () => {
    for (const scale of [0.013, 0.7, 1, 7.3, 4e4]) {
      const px = grid_step({...view, scale}) * scale;
      expect(px).toBeGreaterThanOrEqual(8 - 1e-9);
      expect(px).toBeLessThanOrEqual(20.01);
    }
  });
});
