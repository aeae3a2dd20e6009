import {describe, expect, it} from "vitest";
import {reading_of, with_end, type Ends} from "./range";

const rising = {rising: true, optional: false};

describe("a range that is typed", () => {
  it("is taken when it is complete, and its ends never change places", () => {
    let ends: Ends = [0, 60];
    ends = with_end(ends, 0, 100);
    expect(reading_of(ends, rising)).toEqual({fault: "falling"});
    expect(ends).toEqual([100, 60]);
    ends = with_end(ends, 1, 160);
    expect(reading_of(ends, rising)).toEqual({range: [100, 160]});
  });
  it("needs both ends, or neither where it may be left out", () => {
    expect(reading_of([null, 5], rising)).toEqual({fault: "half"});
    expect(reading_of([null, 5], {...rising, optional: true})).toEqual({fault: "half"});
    expect(reading_of([null, null], {...rising, optional: true})).toEqual({range: null});
    expect(reading_of([null, null], rising)).toEqual({fault: "half"});
  });
  it("has an extent, and may fall where its rule says so", () => {
    expect(reading_of([5, 5], rising)).toEqual({fault: "no_extent"});
    expect(reading_of([90, 0], {rising: false, optional: false})).toEqual({range: [90, 0]});
  });
});
