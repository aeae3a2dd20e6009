import {describe, expect, it} from "vitest";
import {contours, straightest, type Field} from "./contours";

function field(n: number, value: (row: number, column: number) => number, change: Partial<Field> = {}): Field {
  const values = Float32Array.from({length: n * n}, (_, i) => value(Math.floor(i / n), i % n));
  return {
    rows: n,
    columns: n,
    value: values,
    counts: () => true,
    row_breaks: new Set(),
    column_breaks: new Set(),
    stride: 1,
    ...change,
  };
}

describe("contours", () => {
  it("draws a circle as one closed line", () => {
    const [contour] = contours(
      field(101, (r, c) => Math.hypot(r - 50, c - 50)),
      [30],
    );
    expect(contour!.lines).toHaveLength(1);
    const line = contour!.lines[0];
    for (let i = 0; i < line!.length; i += 2) expect(Math.hypot(line![i]! - 50, line![i + 1]! - 50)).toBeCloseTo(30, 1);
    expect(line![0]).toBe(line![line!.length - 2]);
  });
  it("is exact for a plane, also with a stride", () => {
    for (const stride of [1, 2, 5]) {
      const [contour] = contours(
        field(61, (_, c) => c, {stride}),
        [20.5],
      );
      expect(contour!.lines).toHaveLength(1);
      for (let i = 0; i < contour!.lines[0]!.length; i += 2) expect(contour!.lines[0]![i]).toBeCloseTo(20.5, 5);
    }
  });
  it("stops at blocks and at cells that do not count", () => {
    const broken = contours(
      field(61, (_, c) => c, {row_breaks: new Set([30])}),
      [20.5],
    )[0];
    expect(broken!.lines).toHaveLength(2);
    const holed = contours(
      field(61, (_, c) => c, {counts: (i) => Math.floor(i / 61) !== 10}),
      [20.5],
    )[0];
    expect(holed!.lines).toHaveLength(2);
  });
  it("keeps saddles apart and finds nothing where there is nothing", () => {
    const saddle = contours(
      field(41, (r, c) => (r - 20.5) * (c - 20.5)),
      [4],
    )[0];
    expect(saddle!.lines).toHaveLength(2);
    expect(
      contours(
        field(41, () => 1),
        [4],
      )[0]!.lines,
    ).toHaveLength(0);
  });
  it("labels a line where it is straightest", () => {
    const corner = [0, 0, 2, 5, 4, 0, 10, 0, 20, 0, 30, 0];
    const label = straightest(corner, 15)!;
    expect(label.y).toBe(0);
    expect(Math.abs(label.angle)).toBeCloseTo(0, 9);
    expect(straightest([0, 0, 1, 0], 15)).toBeNull();
  });
});
