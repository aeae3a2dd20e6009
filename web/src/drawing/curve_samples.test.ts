import {describe, expect, it} from "vitest";
import type {TaskAnswer} from "../contract/messages";
import {clip, curve_path, nearest, point_at, samples_of_sides, spot_of_tau, through_infinity} from "./curve_samples";
import type {Viewport} from "./viewport";

const view: Viewport = {x: 0, y: 0, scale: 1, width: 400, height: 400};

/** A hyperbola x y = 100² as centre points (one branch, twice through infinity), a circle of radius 100 as circle points. */
function task(count: number, flips: boolean): TaskAnswer {
  const tau = new Float64Array(count),
    center = new Float64Array(3 * count),
    circle = new Float64Array(3 * count);
  for (let i = 0; i < count; ++i) {
    const t = ((i + 0.5) / count) * Math.PI,
      flip = flips && i % 3 === 1 ? -1 : 1;
    tau[i] = i / count;
    // (w, x, y) = (sin t cos t, 100 cos² t, 100 sin² t): x = 100 cot t, y = 100 tan t
    center.set([flip * Math.sin(t) * Math.cos(t), flip * 100 * Math.cos(t) ** 2, flip * 100 * Math.sin(t) ** 2], 3 * i);
    circle.set([flip, flip * 100 * Math.cos(2 * t), flip * 100 * Math.sin(2 * t)], 3 * i);
  }
  return {
    characteristic_length: 100,
    curves: {kind: "one_branch", tau, center, circle, branch: new Uint8Array(count)},
    axes: {input: {quantity: "curve_coordinate", order: 0, branches: [{name: "odd", from: 0, to: 1}], blocks: []}},
    output_curves: null,
  } as unknown as TaskAnswer;
}

describe.each([false, true])("curve samples, signs flipped: %s", (flips) => {
  const samples = samples_of_sides(task(300, flips), [3, 5]).input!;

  it("break at infinity only", () => {
    const breaks = [...Array(300).keys()].filter((a) => through_infinity(samples, "center", a, (a + 1) % 300));
    expect(breaks).toEqual([149, 299]);
    expect([...Array(300).keys()].some((a) => through_infinity(samples, "circle", a, (a + 1) % 300))).toBe(false);
  });
  it("draw no line across the window there", () => {
    const path = curve_path(samples, "center", view);
    expect(path.match(/M/g)!.length).toBeGreaterThanOrEqual(2);
    expect(path).not.toMatch(/NaN|Infinity|e/);
    // x y > 0 everywhere: on the screen (y down, middle 200, 200) no vertex lies in the other two quadrants.
    for (const [, x, y] of path.matchAll(/[MLC ](-?[\d.]+) (-?[\d.]+)/g)) {
      expect((Number(x) - 200) * (200 - Number(y))).toBeGreaterThan(-500);
    }
  });
  it("draw only what is wanted", () => {
    expect(curve_path(samples, "circle", view, (a, b) => a < 10 && b <= 10).match(/L/g)).toHaveLength(10);
    expect(curve_path(samples, "circle", view, () => false)).toBe("");
  });
  it("bend long strokes, so that a circle stays round under the magnifier", () => {
    const near = {...view, scale: 40, x: 100, y: 0},
      path = curve_path(samples, "circle", near);
    expect(path).toMatch(/C/);
    for (const [, x, y] of path.matchAll(/[MC ](-?[\d.]+) (-?[\d.]+)(?=[CM]|$)/g)) {
      expect(Math.abs(Math.hypot((Number(x) - 200) / 40 + 100, (200 - Number(y)) / 40) - 100)).toBeLessThan(0.01);
    }
  });
  it("find the nearest place", () => {
    const spot = nearest(samples, "circle", view, [200 + 120, 200])!;
    expect(spot.distance).toBeCloseTo(20, 1);
    const [x, y] = point_at(samples, "circle", spot)!;
    expect(Math.hypot(x - 100, y)).toBeLessThan(0.1);
  });
  it("find the place of a coordinate", () => {
    for (const tau of [0, 0.1234, 0.5, 0.998, 1]) {
      const spot = spot_of_tau(samples, "circle", tau)!,
        angle = 2 * Math.PI * (tau + 0.5 / 300);
      const [x, y] = point_at(samples, "circle", spot)!;
      expect(Math.hypot(x - 100 * Math.cos(angle), y - 100 * Math.sin(angle))).toBeLessThan(0.02);
    }
    expect(spot_of_tau(samples, "circle", 1.5)).toBeNull();
  });
});

describe("clip", () => {
  it("keeps what is inside", () => {
    expect(clip([-10, 5], [20, 5], [0, 0], [10, 10])).toEqual([
      [0, 5],
      [10, 5],
    ]);
    expect(clip([-10, 15], [20, 15], [0, 0], [10, 10])).toBeNull();
    expect(clip([1, 1], [2, 2], [0, 0], [10, 10])).toEqual([
      [1, 1],
      [2, 2],
    ]);
  });
});

describe("samples of other dyads", () => {
  const circle = (count: number, tau: (i: number) => number, branch: (i: number) => number) => ({
    tau: Float64Array.from({length: count}, (_, i) => tau(i)),
    branch: Uint8Array.from({length: count}, (_, i) => branch(i)),
    center: Float64Array.from(
      {length: 3 * count},
      (_, i) => [1, 50 * Math.cos(i / 3 / 10), 50 * Math.sin(i / 3 / 10)][i % 3]!,
    ),
    circle: Float64Array.from({length: 3 * count}, (_, i) => [1, 0, Math.floor(i / 3)][i % 3]!),
  });
  const axis = (quantity: string, count: number) => ({
    quantity,
    order: 0,
    blocks: [],
    ticks: null,
    branches: Array.from({length: count}, (_, i) => ({name: "sheet", from: i, to: i + 1})),
  });
  const answer = (quantity: string, count: number, curves: object, output: object | null) =>
    ({
      characteristic_length: 100,
      curves: {kind: quantity, ...curves},
      output_curves: output,
      axes: {input: axis(quantity, count), output: axis(quantity, count)},
    }) as unknown as TaskAnswer;

  it("are broken where there are none, and closed where they go all round", () => {
    const gapped = circle(
        200,
        (i) => (i < 60 ? i / 200 : 0.2 + i / 300),
        () => 0,
      ),
      full = circle(
        200,
        (i) => i / 200,
        () => 0,
      );
    const {input, output} = samples_of_sides(answer("side_direction", 1, gapped, full), [0, 0]);
    expect(input!.runs.map(({from, to, closed}) => [from, to, closed])).toEqual([
      [0, 60, false],
      [60, 200, false],
    ]);
    expect(output!.runs.map(({closed}) => closed)).toEqual([true]);
    expect([input!.sides, output!.sides]).toEqual([["input"], ["output"]]);
    expect(curve_path(input!, "center", view).match(/M/g)).toHaveLength(2);
    expect(spot_of_tau(input!, "center", 0.1)!.index).toBe(20);
    expect(spot_of_tau(input!, "center", 0.45)!.index).toBe(75);
    expect(spot_of_tau(input!, "center", 0.35)!.index).toBe(59); // in the gap: the end before it
  });
  it("may be single ones, each a place to go to", () => {
    const {input} = samples_of_sides(
      answer(
        "burmester_point",
        3,
        circle(
          3,
          (i) => i + 0.5,
          (i) => i,
        ),
        null,
      ),
      [0, 0],
    );
    expect(input!.discrete).toBe(true);
    expect(input!.runs).toHaveLength(3);
    const spot = nearest(input!, "circle", view, [205, 198])!;
    expect([spot.tau, spot.sides]).toEqual([2.5, ["input", "output"]]);
    expect(point_at(input!, "circle", spot)).toEqual([0, 2]);
  });
  it("are none where they depend on the other side", () => {
    const none = {
      tau: new Float64Array(),
      branch: new Uint8Array(),
      center: new Float64Array(),
      circle: new Float64Array(),
    };
    expect(
      samples_of_sides(
        answer(
          "side_direction",
          1,
          circle(
            9,
            (i) => i / 9,
            () => 0,
          ),
          none,
        ),
        [0, 0],
      ).output,
    ).toBeNull();
  });
});
