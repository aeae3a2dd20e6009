import {describe, expect, it} from "vitest";
import type {Linkage, Point} from "../../contract/messages";
import {four_bar} from "../../figure/four_bar";
import {count_of, four_bar_links, nominal_of, points_with, sample_paths, type Samples} from "./samples";

const square: Point[] = [
  [0, 0],
  [0, 10],
  [10, 10],
  [10, 0],
  [5, 10],
];
const shifted = (dx: number) => square.flatMap(([x, y]) => [x + dx, y]);
const samples: Samples = {drawn: Float64Array.from([...shifted(0.1), ...shifted(-0.1)]), positions: 1, points: 5};
const project = ([x, y]: Point): Point => [x, -y];

describe("sampled linkages", () => {
  it("are counted, with as many points as their links have and the body's origin", () => {
    expect(points_with(four_bar_links)).toBe(5);
    expect(count_of(samples)).toBe(2);
  });
  it("have their middle where the drive does not tell how the linkage is meant", () => {
    const [first] = nominal_of(samples, four_bar, {drive: null} as Linkage);
    expect(first!.map(([x, y]) => [Number(x.toFixed(9)), y])).toEqual(square);
  });
  it("are drawn as large as they are, or with their deviations enlarged", () => {
    const input = (times: number) =>
      sample_paths(samples, [square], four_bar_links, times, project).find(({role}) => role === "input")!.d;
    expect(input(1)).toBe("M0.1 0L0.1 -10M-0.1 0L-0.1 -10");
    expect(input(100)).toBe("M10 0L10 -10M-10 0L-10 -10");
  });
  it("200 in four positions take a few milliseconds", {retry: 2}, () => {
    const many: Samples = {
      drawn: Float64Array.from(Array.from({length: 200 * 4}, (_, i) => shifted(i / 800)).flat()),
      positions: 4,
      points: 5,
    };
    const nominal = Array.from({length: 4}, () => square);
    sample_paths(many, nominal, four_bar_links, 1, project);
    const start = performance.now();
    for (let i = 0; i < 5; ++i) sample_paths(many, nominal, four_bar_links, 1, project);
    expect((performance.now() - start) / 5).toBeLessThan(25); // 5 on a machine that does nothing else
  });
});
