import {describe, expect, it} from "vitest";
import {map_sizes} from "./layout";

describe("layout", () => {
  it("is a square that leaves room for the numbers", () => {
    expect(map_sizes("wide", 532, 900, false, false, false).map).toBeGreaterThanOrEqual(410);
    expect(map_sizes("wide", 532, 1400, false, false, false).map).toBe(532 - 34 - 24);
    expect(map_sizes("laptop", 424, 768, false, false, false).map).toBeLessThanOrEqual(366);
    expect(map_sizes("laptop", 424, 768, false, false, false).map).toBeGreaterThan(300);
    expect(map_sizes("phone", 390, 844, false, false, false).map).toBeLessThanOrEqual(390 - 38);
    expect(map_sizes("phone", 390, 844, false, false, false).map).toBeGreaterThan(300);
    expect(map_sizes("phone", 320, 568, false, false, false).map).toBeLessThanOrEqual(568 - 430 - 28); // the drive keeps its place
  });
  it("leaves room for numbers on its axes", () => {
    expect(map_sizes("wide", 532, 1400, false, true, false)).toMatchObject({map: 532 - 42 - 24, strip: 42, foot: 42});
  });
  it("is nothing where its column is hidden, never less", () => {
    expect(map_sizes("wide", 0, 900, false, false, false).map).toBe(0);
  });
  it("gives the ridges their strip", () => {
    expect(map_sizes("wide", 532, 1400, true, false, false).map).toBe(532 - 34 - 24 - 18);
  });
});
