import {describe, expect, it} from "vitest";
import {body_corners, most_triangles, packed_body} from "./bodies";

const triangle = [10, 0, 0, 0, 20, 0, 0, 0, 40];
describe("bodies", () => {
  it("lie within the ball, three corners to a triangle", () => {
    for (const shape of ["wing", "dish", "box", "craft"] as const) {
      const corners = body_corners({shape})!;
      expect(corners.length % 9).toBe(0);
      for (let i = 0; i < corners.length; i += 3)
        expect(Math.hypot(corners[i]!, corners[i + 1]!, corners[i + 2]!)).toBeLessThan(0.9);
    }
    expect(body_corners({shape: "triad"})).toBeNull();
  });
  it("from files keep their shape, in the middle of the ball", () => {
    const body = packed_body("gear", triangle)!,
      [ax, , , , by] = [...body_corners(body)!];
    const reach = Math.hypot(5, 10, 20);
    expect(ax).toBeCloseTo((0.78 * 5) / reach, 3);
    expect(by).toBeCloseTo((0.78 * 10) / reach, 3);
    expect(body_corners(body)).toBe(body_corners({...body}));
  });
  it("from files are refused where they are none, or too many", () => {
    expect(packed_body("none", [])).toBeNull();
    expect(packed_body("point", [1, 1, 1, 1, 1, 1, 1, 1, 1])).toBeNull();
    expect(packed_body("nan", [...triangle.slice(1), NaN])).toBeNull();
    expect(packed_body("large", new Float32Array(9 * (most_triangles + 1)))).toBeNull();
  });
});
