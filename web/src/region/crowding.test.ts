import {describe, expect, it} from "vitest";
import type {Curves} from "../contract/messages";
import {crowded_share, is_crowded} from "./crowding";

function line(tau: number[], x: number[]): Curves {
  const points = Float64Array.from(x.flatMap((v) => [1, v, 0]));
  return {
    tau: Float64Array.from(tau),
    center: points,
    circle: points,
    branch: new Uint8Array(tau.length),
  } as unknown as Curves;
}
const steps = Array.from({length: 101}, (_, i) => i / 100);

describe("crowding", () => {
  it("finds none where length goes with τ", () => {
    expect(crowded_share(line(steps, steps), [-1, -1], [2, 1])).toBeCloseTo(0.3, 1);
    expect(is_crowded(line(steps, steps), [-1, -1], [2, 1])).toBe(false);
  });
  it("finds a strip that holds much of the curve", () => {
    const jump = steps.map((s, i) => (i > 50 ? 10 + s : s));
    expect(is_crowded(line(steps, jump), [-1, -1], [20, 1])).toBe(true);
  });
  it("does not count what is out of sight", () => {
    const jump = steps.map((s, i) => (i > 50 ? 10 + s : s));
    expect(is_crowded(line(steps, jump), [-1, -1], [2, 1])).toBe(false);
  });
});
