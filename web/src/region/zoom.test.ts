import {describe, expect, it} from "vitest";
import {whole} from "../contract/messages";
import {boxed, least_width, magnification, panned, showing, zoomed} from "./zoom";

describe("zoom", () => {
  it("keeps the place under the pointer", () => {
    const near = zoomed(whole, [0.3, 0.8], 0.25);
    expect((0.3 - near.input[0]) / (near.input[1] - near.input[0])).toBeCloseTo(0.3, 12);
    expect((0.8 - near.output[0]) / (near.output[1] - near.output[0])).toBeCloseTo(0.8, 12);
    expect(magnification(near)).toBeCloseTo(4, 9);
  });
  it("comes back to the whole map itself", () => {
    expect(zoomed(zoomed(whole, [0.3, 0.8], 0.5), [0.5, 0.5], 4)).toBe(whole);
    expect(boxed([0, 0], [1, 1])).toBe(whole);
  });
  it("stays inside the region and above its least width", () => {
    let window = zoomed(whole, [0.01, 0.99], 0.1);
    window = panned(window, -5, 5);
    expect(window.input[0]).toBe(0);
    expect(window.output[1]).toBeLessThanOrEqual(1);
    for (let i = 0; i < 60; ++i) window = zoomed(window, [0.02, 0.97], 0.5);
    expect(window.input[1] - window.input[0]).toBeGreaterThan(0.99 * least_width);
  });
  it("follows a place that leaves it", () => {
    const window = boxed([0.2, 0.2], [0.4, 0.4]);
    expect(showing(window, [0.3, 0.3])).toBe(window);
    const moved = showing(window, [0.45, 0.3]);
    expect(moved.input[1]).toBeGreaterThan(0.45);
    expect(moved.output).toEqual(window.output);
  });
});
