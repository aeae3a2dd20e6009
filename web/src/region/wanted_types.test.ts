import {describe, expect, it} from "vitest";
import {new_problem} from "../kinds/motion/kind";
import {is_wanted, legend_types, only, toggled} from "./wanted_types";

describe("wanted types", () => {
  const all = new_problem();
  it("takes one out and back", () => {
    const without = toggled(all, "double_crank");
    expect(without.requirements!.types).toHaveLength(8);
    expect(is_wanted(without, "double_crank")).toBe(false);
    expect(is_wanted(without, "crank_rocker")).toBe(true);
    expect(toggled(without, "double_crank").requirements!.types).toBeUndefined();
  });
  it("shows what linkages of the task can be", () => {
    expect(legend_types(all.task)).toContain("triple_rocker_ground");
    expect(legend_types(all.task)).not.toContain("triple_rocker");
    expect(legend_types(all.task)).not.toContain("degenerate");
  });
  it("asks for one only, and for all again", () => {
    const one = only(all, "double_rocker");
    expect(one.requirements!.types).toEqual(["double_rocker"]);
    expect(only(one, "double_rocker").requirements!.types).toBeUndefined();
  });
  it("never asks for what the engine refuses", () => {
    let problem = all;
    for (const type of legend_types(all.task)) problem = toggled(problem, type);
    expect(problem.requirements!.types).toBeUndefined();
    expect(toggled(all, "crank_rocker").requirements!.types).not.toContain("degenerate");
  });
});
