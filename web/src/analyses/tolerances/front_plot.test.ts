import {describe, expect, it} from "vitest";
import {ways_on, type Front} from "./front.svelte";
import {angle_ticks, error_ticks, field_of, front_path, nearest_point, place_of} from "./front_plot";

const point = (angle_deg: number, error: number) => ({tau: [angle_deg, error] as const, angle_deg, error});
const front: Front = {
  text: "",
  window: {input: [0, 1], output: [0, 1]},
  points: [point(80, 2), point(60, 1), point(40, 0.5)],
  cells: Float64Array.from([80, 2, 60, 1, 40, 0.5, 40, 3, 50, 2.5]) as unknown as Float32Array,
};
const field = field_of(front, [], 300, 200);

describe("the plane of the two objectives", () => {
  it("has better angles to the right and larger errors above", () => {
    const [best, , least] = front.points.map((one) => place_of(field, one));
    expect(best![0]).toBeGreaterThan(least![0]);
    expect(best![1]).toBeLessThan(least![1]);
    for (const [x, y] of [best!, least!]) expect(x > 0 && x < 300 && y > 0 && y < 200).toBe(true);
  });
  it("shows a linkage that lies off all others", () => {
    const [x, y] = place_of(field_of(front, [point(10, 40)], 300, 200), point(10, 40));
    expect(x).toBeGreaterThan(40);
    expect(y).toBeGreaterThan(5);
  });
  it("finds the point that is meant", () => {
    const [x, y] = place_of(field, front.points[1]!);
    expect(nearest_point(field, front.points, [x + 5, y - 5])).toBe(1);
    expect(nearest_point(field, [], [x, y])).toBe(-1);
  });
  it("draws the front as steps", () =>
    expect(front_path(field, front.points)).toMatch(/^M[\d.]+ [\d.]+(V[\d.]+H[\d.]+){2}$/));
  it("has round numbers at its axes", () => {
    expect(error_ticks([0.4, 6])).toEqual([0.5, 1, 2, 5]);
    expect(error_ticks([1.1, 2.1])).toEqual([1.2, 1.5, 2]);
    expect(angle_ticks([28, 84])).toEqual([30, 40, 50, 60, 70, 80]);
  });
});

describe("ways on from a linkage", () => {
  it("lead to the least error at its angle, and to half of it", () => {
    const {least, half} = ways_on(front, {angle_deg: 58, error: 2.2});
    expect([least?.error, half?.angle_deg]).toEqual([1, 60]);
  });
  it("are none where the linkage is on the front, or half the error nowhere", () => {
    expect(ways_on(front, {angle_deg: 60, error: 1}).least).toBeNull();
    expect(ways_on(front, {angle_deg: 60, error: 1}).half?.angle_deg).toBe(40);
    expect(ways_on(front, {angle_deg: 40, error: 0.9}).half).toBeNull();
  });
});
