import {describe, expect, it} from "vitest";
import {sequences} from "../../orientation/orientation";
import {arc, cross, length, minus, times, type Vec3} from "../../sphere/vectors";
import {near_vector, second_axis_formula, vector_text} from "./vector_words";

describe("vectors in words", () => {
  it("are at infinity where only round-off keeps them from it", () => {
    expect(near_vector([1.2e16, 1.2e16, 0])).toBeNull();
    expect(near_vector(null)).toBeNull();
    expect(near_vector([0, 5e6, 1])).toEqual([0, 5e6, 1]);
  });
  it("have no minus before nothing", () => expect(vector_text([-1e-9, 0.5, -0.25], 2)).toBe("(0.00, 0.50, −0.25)"));
});

describe("the second axis", () => {
  const unit: Record<string, Vec3> = {x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1]},
    turned = (axis: Vec3, angle: number, of: Vec3): Vec3 => arc(axis, of, angle).at(-1)!;
  it.each(sequences)("of %s lies along the product of the first and the third, as the formula has it", (sequence) => {
    const [a, b, c] = [...sequence].map((letter) => unit[letter]!) as [Vec3, Vec3, Vec3],
      [t1, t2] = [0.7, 0.4],
      second = turned(a, t1, b),
      third = turned(a, t1, turned(b, t2, c)),
      formula = second_axis_formula(sequence);
    const first_comes_first = formula.indexOf("₀") < formula.indexOf("×"),
      product = first_comes_first ? cross(a, third) : cross(third, a),
      factor = formula.includes('"sin"') ? Math.sin(t2) : Math.cos(t2);
    expect(length(minus(product, times(factor, second)))).toBeLessThan(1e-12);
  });
});
