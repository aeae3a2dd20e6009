import {describe, expect, it} from "vitest";
import type {Axis, AxisQuantity} from "../contract/messages";
import {place_text} from "./place";

const axis = (quantity: AxisQuantity, value: (share: number) => number): Axis => ({
  quantity,
  order: 0,
  blocks: [],
  branches: [
    {name: "a", from: 0, to: 1},
    {name: "b", from: 1, to: 2},
  ],
  ticks: [0, 1].flatMap((branch) => Array.from({length: 12}, (_, i) => [branch + i / 12, value(i / 12)] as const)),
});

describe("a place on the map", () => {
  it("is read as what the axis carries", () => {
    expect(
      place_text(
        axis("curve_coordinate", (x) => x),
        "output",
        1.25,
      ),
    ).toBe("τ₂ 1.2500");
    expect(
      place_text(
        axis("burmester_point", (x) => x),
        "input",
        1.5,
      ),
    ).toBe("point 2");
    expect(
      place_text(
        axis("layer", (x) => x),
        "output",
        1.5,
      ),
    ).toBe("linkage 2");
    expect(
      place_text(
        axis("nothing", (x) => x),
        "output",
        0.5,
      ),
    ).toBe("");
  });
  it("lies between the ticks as the quantity goes, up to the end of its branch", () => {
    const directions = axis("side_direction", (share) => 360 * share),
      scales = axis("output_scale", (share) => 0.5 * 4 ** share);
    expect([0, 0.1, 0.5, 0.99, 1.25].map((tau) => place_text(directions, "input", tau))).toEqual([
      "β₁ 0.0°",
      "β₁ 36.0°",
      "β₁ 180.0°",
      "β₁ 356.4°",
      "β₁ 90.0°",
    ]);
    const rays = axis("link_ray", (share) => 180 * share - 90),
      lengths = axis("pole_height", (share) => 400 * share);
    expect(place_text(rays, "output", 0.5)).toBe("ψ₂ 0.0°");
    expect(place_text(lengths, "input", 0.25)).toBe("hP 100");
    expect([0, 0.54, 0.98].map((tau) => place_text(scales, "output", tau))).toEqual(["×0.5", "×1.06", "×1.95"]);
  });
});
