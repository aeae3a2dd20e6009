import {describe, expect, it} from "vitest";
import {share_of, value_at} from "./value_range";

describe("a range of values", () => {
  it("has equal shares for equal differences", () => {
    expect(share_of({from: 10, to: 20}, 12)).toBeCloseTo(0.2);
    expect(share_of({from: 20, to: 10}, 12)).toBeCloseTo(0.8);
    expect(value_at({from: 20, to: 10}, 0.8)).toBeCloseTo(12);
    expect(share_of({from: 3, to: 3}, 5)).toBe(0);
  });
  it("or for equal ratios", () => {
    const range = {from: 100, to: 1, logarithmic: true};
    expect(share_of(range, 10)).toBeCloseTo(0.5);
    expect(value_at(range, 0.5)).toBeCloseTo(10);
    for (const value of [0.3, 1, 7, 400]) expect(value_at(range, share_of(range, value))).toBeCloseTo(value);
  });
  it("puts what is not defined beyond the low end", () => {
    expect(share_of({from: 1, to: 100, logarithmic: true}, 0)).toBe(-Infinity);
    expect(share_of({from: 100, to: 1, logarithmic: true}, 0)).toBe(Infinity);
  });
});
