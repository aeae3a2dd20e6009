import {describe, expect, it} from "vitest";
import type {Linkage} from "../contract/messages";
import {first_example} from "../gallery/gallery";
import {shortcoming} from "./shortcoming";

const {problem} = first_example,
  workbench = {problem: {...problem, requirements: {max_link_ratio: 8}}, task: null, unit: "mm"};
const linkage = {
  type: "double_crank",
  defects: {order: false, branch: false, circuit: false},
  reason: null,
  fails: 0,
} as unknown as Linkage;
const of = (change: Partial<Linkage>, verified: boolean | null = true) =>
  shortcoming({...linkage, ...change}, problem.task, verified === null ? null : {verified, residual: 0}, workbench);

describe("what to mind of a linkage that is taken away", () => {
  it("is nothing where it does what was asked", () => {
    expect(of({})).toBeNull();
    expect(of({}, null)).toBeNull();
  });
  it("is its defect, and what it misses", () => {
    const defects = {order: false, branch: true, circuit: true},
      reason = {code: "circuit_defect", values: {from: 1, to: 2}, message: ""};
    expect(of({defects, reason, fails: 2 | 8})).toBe(
      "Before you build it: Circuit defect: positions 1 and 2 lie on different circuits; reassembly needed. Not met: link ratio (8 at most)",
    );
    expect(of({fails: 8})).toBe("Before you build it: Not met: link ratio (8 at most)");
  });
  it("is that driving disagrees", () => {
    expect(of({}, false)).toContain("disagrees");
  });
});
