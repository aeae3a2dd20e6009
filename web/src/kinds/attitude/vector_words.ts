// Vectors and angles for people.
import {most_of} from "../../state/ends";
import {fixed, significant} from "../../texts/numbers";

/** "(0.123456, …)"; what rounding left of a zero is one. */
export function vector_text(vector: readonly number[], digits = 6): string {
  return `(${vector.map((number) => clean(number, digits)).join(", ")})`;
}
export function clean(number: number, digits: number): string {
  return fixed(Math.abs(number) < 0.5 * 10 ** -digits ? 0 : number, digits);
}
/** Nothing where only round-off keeps it from lying at infinity. */
export function near_vector(vector: readonly number[] | null): readonly number[] | null {
  return vector && most_of(vector.map(Math.abs)) < 1e9 ? vector : null;
}
/** Lengths and rates, at a few significant digits beside the largest. */
export function quantities_text(vector: readonly number[], digits = 6): string {
  const most = most_of(vector.map(Math.abs));
  return `(${vector.map((number) => significant(Math.abs(number) < 1e-12 * most ? 0 : number, digits)).join(", ")})`;
}
/** Along which line the second axis of a sequence lies: at a right angle to the first, at rest, and the third, carried. */
export function second_axis_formula(sequence: string): string {
  const [first, , third] = sequence as unknown as [string, string, string],
    factors = [`*${first}₀*`, `*${third}*`];
  if (first === third) return `*N* "sin" t₂ = ${factors.join(" × ")}`;
  const cyclic = ["xyz", "yzx", "zxy"].includes(sequence);
  return `*e₂* "cos" t₂ = ${(cyclic ? factors.toReversed() : factors).join(" × ")}`;
}
const marks: Record<string, string> = {xyz: "α β γ", zyx: "θ β α", zxz: "ψ ϑ φ"};
/** What the three angles of a sequence are called in the books. */
export function angle_names(sequence: string): readonly [string, string, string] {
  return (marks[sequence] ?? "t₁ t₂ t₃").split(" ") as unknown as [string, string, string];
}
