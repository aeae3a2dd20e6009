import {describe, expect, it} from "vitest";
import {find_pin, free_name} from "./pins";
import {new_problem} from "../kinds/motion/kind";
import type {Pin} from "./problem";
import {with_pose} from "../kinds/kind_dispatch";

const {task} = new_problem();
const named = (name: string) => ({name, tau: [0.5, 0.75], task}) as unknown as Pin;

describe("pins", () => {
  it("take the first free name", () => {
    expect(free_name([])).toBe("A");
    expect(free_name([named("A"), named("C")])).toBe("B");
    const alphabet = Array.from("ABCDEFGHIJKLMNOPQRSTUVWXYZ", named);
    expect(free_name(alphabet)).toBe("A1");
    expect(free_name([...alphabet, named("A1")])).toBe("B1");
  });
  it("are found by their linkage, in their own task", () => {
    const pins = [named("A")],
      other = with_pose(new_problem(), 0, {x: 1}).task;
    expect(find_pin(pins, new_problem().task, [0.5, 0.75 + 1e-9])?.name).toBe("A");
    expect(find_pin(pins, task, [0.5, 0.76])).toBeUndefined();
    expect(find_pin(pins, other, [0.5, 0.75])).toBeUndefined();
  });
});
