import {describe, expect, it} from "vitest";
import type {Point} from "../contract/messages";
import {circle_path, endless, polyline} from "./instant_paths";

const space = {project: ([x, y]: Point): Point => [400 + 10 * x, 300 - 10 * y]};
const seen = {width: 800, height: 600};
const vertices = (path: string) =>
  path
    .split(/[ML]/)
    .filter(Boolean)
    .map((pair) => pair.split(" ").map(Number) as [number, number]);

describe("paths of an instant", () => {
  it("draw a whole circle that is small", () => {
    const found = vertices(circle_path({center: [3, 2], radius: 5}, space, seen));
    for (const [x, y] of found) expect(Math.hypot(x - 430, y - 280)).toBeCloseTo(50, 0);
    expect(Math.hypot(found[0]![0] - found.at(-1)![0], found[0]![1] - found.at(-1)![1])).toBeLessThan(1);
  });
  it.each([30, 3900, 4100, 1e6])("keep the chords of a circle of %i px within a fifth of a pixel", (radius) => {
    const center: Point = [40, 30],
      found = vertices(circle_path({center, radius: radius / 10}, space, seen));
    for (const [i, [x, y]] of found.slice(1).entries()) {
      const [x0, y0] = found[i]!,
        half = Math.hypot(x - x0, y - y0) / 2;
      expect(radius - Math.sqrt(radius ** 2 - half ** 2)).toBeLessThan(0.2);
    }
  });
  it("draw of a huge circle the arc that is seen, smoothly", () => {
    const radius = 1e6,
      found = vertices(circle_path({center: [0, radius], radius}, space, seen));
    for (const [, y] of found) expect(Math.abs(y - 300)).toBeLessThan(1);
    expect(Math.min(...found.map(([x]) => x))).toBeLessThan(0);
    expect(Math.max(...found.map(([x]) => x))).toBeGreaterThan(seen.width);
  });
  it("draw lines from border to border, and none that is not seen", () => {
    expect(vertices(circle_path({line: {point: [0, 0], direction_deg: 90}}, space, seen)).map(([x]) => x)).toEqual([
      400, 400,
    ]);
    expect(endless([0, 1000], 0, space, seen)).toBe("");
  });
  it("draw curves vertex by vertex", () => {
    expect(
      polyline(
        [
          [0, 0],
          [1, 1],
        ],
        space,
      ),
    ).toBe("M400 300L410 290");
  });
});
