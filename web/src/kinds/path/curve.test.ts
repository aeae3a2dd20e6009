import fc from "fast-check";
import {describe, expect, it} from "vitest";
import type {Point} from "../../contract/messages";
import {comes_back, drawn, drawn_points, evenly_spaced, joined, length_of, resampled, smoothed} from "./curve";

const circle = (count: number, radius = 1): Point[] =>
  Array.from({length: count}, (_, i) => {
    const angle = (2 * Math.PI * i) / count;
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  });
const distance = (a: Point, b: Point) => Math.hypot(a[0] - b[0], a[1] - b[1]);
/** From a point to a polyline, by its edges. */
function off(point: Point, line: readonly Point[], closed: boolean): number {
  const ends = closed ? [...line, line[0]!] : line;
  return Math.min(
    ...ends.slice(1).map(([x, y], i) => {
      const [u, v] = ends[i]!,
        [dx, dy] = [x - u, y - v],
        share = ((point[0] - u) * dx + (point[1] - v) * dy) / (dx * dx + dy * dy || 1),
        held = Math.min(Math.max(share, 0), 1);
      return distance(point, [u + held * dx, v + held * dy]);
    }),
  );
}
/** A bean, as a hand draws it: a dent, a tremble, and an end that misses the beginning. */
function by_hand(count: number, tremble: number, gap: number): Point[] {
  let seed = 7;
  const random = () => ((seed = (seed * 16807) % 2147483647) / 2147483647 - 0.5) * 2 * tremble;
  return Array.from({length: count}, (_, i) => {
    const angle = (2 * Math.PI * (1 - gap) * i) / (count - 1),
      r = 100 * (1 - 0.35 * Math.exp(-((angle - Math.PI / 2) ** 2) / 0.3));
    return [1.5 * r * Math.cos(angle) + random(), r * Math.sin(angle) + random()];
  });
}

describe("places along a polyline", () => {
  const places = fc.array(fc.tuple(fc.integer({min: -50, max: 50}), fc.integer({min: -50, max: 50})), {
    minLength: 3,
    maxLength: 40,
  });
  it("lie on it, as many as asked for, the ends of an open one among them", () => {
    fc.assert(
      fc.property(places, fc.boolean(), fc.integer({min: 3, max: 40}), (line, closed, count) => {
        fc.pre(length_of(line) > 0);
        for (const along of [evenly_spaced(line, closed, count), resampled(line, closed, count)]) {
          expect(along).toHaveLength(count);
          for (const point of along) expect(off(point, line, closed)).toBeLessThan(1e-9);
          if (!closed) expect(distance(along.at(-1)!, line.at(-1)!)).toBeLessThan(1e-9);
          expect(along[0]).toEqual(line[0]);
        }
      }),
    );
  });
  it("are at equal steps of the way", () => {
    const fine = circle(1000),
      steps = evenly_spaced(fine, true, 12).map((point, i, all) => distance(point, all[(i + 1) % 12]!));
    for (const step of steps) expect(step).toBeCloseTo(2 * Math.sin(Math.PI / 12), 4);
  });
  it("are closer together where it bends", () => {
    const ellipse = circle(400).map(([x, y]): Point => [10 * x, y]);
    const at_tips = (points: readonly Point[]) => points.filter(([x]) => Math.abs(x) > 9).length;
    expect(at_tips(resampled(ellipse, true))).toBeGreaterThan(
      1.5 * at_tips(evenly_spaced(ellipse, true, drawn_points)),
    );
  });
  it("are those of a straight line, too", () => {
    const xs = resampled([[0, 0], [10, 0]], false, 6).map(([x]) => x); // prettier-ignore
    expect(xs.map((x) => Number(x.toFixed(12)))).toEqual([0, 2, 4, 6, 8, 10]);
  });
});

describe("smoothing", () => {
  it("takes a tremble away and does not shrink", () => {
    const smooth = circle(96, 100),
      shaken = smooth.map(([x, y], i): Point => [x * (1 + 0.02 * (-1) ** i), y * (1 + 0.02 * (-1) ** i)]);
    const radii = smoothed(shaken, true, 6).map(([x, y]) => Math.hypot(x, y));
    expect(Math.max(...radii) - Math.min(...radii)).toBeLessThan(0.2);
    expect(radii.reduce((sum, r) => sum + r, 0) / radii.length).toBeCloseTo(100, 0);
  });
  it("keeps the ends of an open curve, and straight lines", () => {
    const line = Array.from({length: 9}, (_, i): Point => [i, 2 * i]);
    smoothed(line, false, 5).forEach((point, i) => expect(distance(point, line[i]!)).toBeLessThan(1e-12));
    const bent: Point[] = [[0, 0], [1, 3], [2, -3], [3, 0]]; // prettier-ignore
    expect([smoothed(bent, false, 3)[0], smoothed(bent, false, 3)[3]]).toEqual([bent[0], bent[3]]);
  });
});

describe("a stroke", () => {
  it("is closed where its end comes back to its beginning", () => {
    expect(comes_back(by_hand(200, 0, 0))).toBe(true);
    expect(comes_back(by_hand(200, 0, 0.06))).toBe(true);
    expect(comes_back(by_hand(200, 0, 0.4))).toBe(false);
    expect(comes_back([])).toBe(false);
    expect(comes_back(Array.from({length: 50}, (_, i): Point => [i, 0]))).toBe(false);
  });
  it("is led on to its beginning, cut where it has run past, bent where it lies beside", () => {
    const past = [...circle(100), ...circle(100).slice(0, 6)],
      cut = joined(past);
    expect(cut).toHaveLength(100);
    cut.forEach((point, i) => expect(distance(point, past[i]!)).toBeLessThan(0.1));
    const spiral = circle(101).map(([x, y], i): Point => [x * (1 + i / 1000), y * (1 + i / 1000)]),
      bent = joined(spiral.slice(0, 100));
    const radius = ([x, y]: Point) => Math.hypot(x, y);
    expect(Math.abs(radius(bent[0]!) - radius(bent.at(-1)!))).toBeLessThan(0.05); // 0.1 before
    bent.forEach((point, i) => expect(distance(point, spiral[i]!)).toBeLessThan(0.06));
  });
  it("becomes a few points along it, near what was meant", () => {
    const {points, closed} = drawn(by_hand(300, 1.5, 0.03)),
      meant = by_hand(300, 0, 0);
    expect([points.length, closed]).toEqual([drawn_points, true]);
    for (const point of points) expect(off(point, meant, true)).toBeLessThan(6);
    const open = drawn(by_hand(300, 0, 0.5));
    expect([open.points.length, open.closed]).toEqual([drawn_points, false]);
  });
  it("may be a dot, or stand still", () => {
    expect(drawn([[1, 1]]).points.length).toBeLessThanOrEqual(1);
    expect(drawn([[1, 1], [1, 1]]).points.length).toBeLessThanOrEqual(1); // prettier-ignore
  });
});
