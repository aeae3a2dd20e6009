import {describe, expect, it} from "vitest";
import {verdict_of} from "./verdict";

const none = {order: false, branch: false, circuit: false},
  driven = (verified: boolean) => ({verified, residual: 0});

describe("the verdict on a linkage", () => {
  it("never has a defect and a drive that confirms it beside each other", () => {
    for (const verified of [null, driven(true), driven(false)]) {
      expect(verdict_of({type: "double_rocker", defects: {...none, branch: true}}, verified)).toEqual({
        good: false,
        text: "defect.branch",
        driven: false,
      });
    }
  });
  it("is good until driving says otherwise, and says whether it was driven", () => {
    expect(verdict_of({type: "crank_rocker", defects: none}, null)).toEqual({
      good: true,
      text: "defect.none",
      driven: false,
    });
    expect(verdict_of({type: "crank_rocker", defects: none}, driven(true))).toEqual({
      good: true,
      text: "defect.none",
      driven: true,
    });
    expect(verdict_of({type: "crank_rocker", defects: none}, driven(false))).toEqual({
      good: false,
      text: "num.disputed",
      driven: false,
    });
  });
  it("is none of a slider", () => {
    expect(verdict_of({type: "degenerate", defects: none}, driven(true))).toBeNull();
  });
});
