import {describe, expect, it} from "vitest";
import {gap_px, make_scale, pixel_of, place_at} from "./scale";

const blocks = [
  {from: 0, to: 0.5},
  {from: 0.5, to: 1},
];

describe("scale", () => {
  it("lays the blocks over the whole edge with a gap between them", () => {
    const scale = make_scale(blocks, [0, 1], 404);
    expect(scale.pieces.map((p) => [p.start, p.end])).toEqual([
      [0, 200],
      [204, 404],
    ]);
    expect(pixel_of(scale, 0)).toBe(0);
    expect(pixel_of(scale, 0.25)).toBe(100);
    expect(pixel_of(scale, 0.5)).toBe(200 + gap_px);
    expect(pixel_of(scale, 1)).toBe(404);
  });
  it("goes both ways", () => {
    for (const window of [
      [0, 1],
      [0.3, 0.9],
      [0.1, 0.2],
      [0.49999, 0.50001],
    ] as const) {
      const scale = make_scale(blocks, window, 412);
      for (let i = 0; i <= 50; ++i) {
        const place = window[0] + ((window[1] - window[0]) * i) / 50;
        expect(place_at(scale, pixel_of(scale, place))).toBeCloseTo(place, 9);
      }
    }
  });
  it("takes the nearer edge in a gap and the ends outside", () => {
    const scale = make_scale(blocks, [0, 1], 404);
    expect(place_at(scale, 201)).toBeCloseTo(0.5, 6);
    expect(place_at(scale, 201)).toBeLessThan(0.5);
    expect(place_at(scale, 203)).toBe(0.5);
    expect(place_at(scale, -7)).toBe(0);
    expect(place_at(scale, 500)).toBe(1);
  });
  it("runs on beyond the window", () => {
    const scale = make_scale(blocks, [0.6, 0.8], 400);
    expect(scale.pieces).toHaveLength(1);
    expect(pixel_of(scale, 0.5)).toBeCloseTo(-200, 9);
    expect(pixel_of(scale, 0.9)).toBeCloseTo(600, 9);
  });
  it("stands without blocks", () => {
    const scale = make_scale([], [0, 1], 400);
    expect(pixel_of(scale, 0.5)).toBe(200);
  });
});
