import {describe, expect, it} from "vitest";
import {
  common_length,
  is_exact,
  length_entries,
  length_tolerance,
  limit_of,
  read_tolerances,
  with_length,
} from "./block";

describe("tolerances", () => {
  it("are read as files have them", () => {
    const all = {
      length: {input: 0.1, coupler: 0.2, output: 0, ground_pivots: 0.05, point: 1},
      clearance: 0.02,
      driver_deg: 0.1,
      link_angle_deg: 0.2,
      distribution: "uniform",
      turning_length: 100,
      limit: {angle_deg: 1},
      cost: {exponent: 2},
      samples: 5000,
      seed: 7,
    };
    expect(read_tolerances(all)).toEqual(all);
    expect(read_tolerances({length: 0.5, limit: null, cost: null, turning_length: null})).toEqual({length: 0.5});
  });
  it("are read member by member", () => {
    const wrong = {length: -1, clearance: "x", distribution: "odd", limit: {position: NaN}, cost: 2, seed: null};
    expect(read_tolerances(wrong)).toEqual({});
    expect(read_tolerances({length: {input: 1, point: "far", other: 2}})).toEqual({length: {input: 1}});
    for (const none of [null, undefined, 3, [], "x"]) expect(read_tolerances(none)).toBeNull();
  });
  it("are one number, or each its own", () => {
    const one = {length: 0.5};
    const two = with_length(one, "coupler", 0.1);
    expect(two.length).toEqual({input: 0.5, coupler: 0.1, output: 0.5, ground_pivots: 0.5, point: 0.5});
    expect(common_length(two, length_entries)).toBeNull();
    expect(common_length(two, ["input", "output"])).toBe(0.5);
    expect(with_length(two, "coupler", 0.5)).toEqual(one);
    expect(length_tolerance({length: {input: 1}}, "output")).toBe(0);
  });
  it("are none where nothing varies", () => {
    expect(is_exact({length: 0, limit: {position: 1}})).toBe(true);
    expect(is_exact({length: {point: 0.1}})).toBe(false);
    expect(is_exact({driver_deg: 0.1})).toBe(false);
  });
  it("know their limit", () => {
    expect(limit_of({limit: {angle_deg: 2}})).toEqual({kind: "angle_deg", value: 2});
    expect(limit_of({length: 1})).toBeNull();
  });
});
