// Where a grounded link stands on its axis of the map, as people read it.
import type {Axes, Axis, AxisQuantity, Side, TauPair} from "../contract/messages";
import {on_branches, on_line} from "../engine/axis";
import {is_angle} from "../region/axis_marks";
import {degrees_text, fixed, significant} from "../texts/numbers";
import {t} from "../texts/texts.svelte";

const lower: Record<Side, string> = {input: "₁", output: "₂"};

/** "τ₁ 1.1311 · τ₂ 0.4207", of each axis with a choice. */
export function places_text(axes: Axes, tau: TauPair, digits = 4): string {
  return (["input", "output"] as const)
    .map((side, k) => place_text(axes[side], side, tau[k]!, digits))
    .filter((text) => text !== "")
    .join(" · ");
}
/** "τ₁ 1.1311", "β₂ 47.2°", "point 2"; nothing where the axis leaves nothing to choose or another number says it. */
export function place_text(axis: Axis, side: Side, tau: number, digits = 4): string {
  switch (axis.quantity) {
    case "curve_coordinate":
      return `τ${lower[side]} ${fixed(tau, digits)}`;
    case "burmester_point":
      return t("axis.point", {n: Math.floor(tau) + 1});
    case "layer":
      return t("axis.linkage", {n: Math.floor(tau) + 1});
    case "fitted_curve":
      return t(axis.branches[0]?.name === "linkage" ? "axis.linkage" : "axis.path", {n: Math.floor(tau) + 1});
    case "realisation":
      return t("axis.realisation", {n: Math.floor(tau) + 1});
    case "side_direction":
      return `β${lower[side]} ${degrees_text(value_at(axis, tau, (a, b, share) => a + share * (b - a)))}`;
    case "pair_output":
      return `ψ ${degrees_text(value_at(axis, tau, (a, b, share) => a + share * (b - a)))}`;
    case "nothing":
      return "";
    case "output_scale":
      return `×${significant(
        value_at(axis, tau, (a, b, share) => a * (b / a) ** share),
        3,
      )}`;
    case "side_length":
      return ""; // another number says it
    case "center_x":
    case "center_y":
    case "circle_x":
    case "circle_y":
    case "center_on_line":
    case "circle_on_line":
      return number_place_text(axis, side, on_line(axis, tau));
    default:
      return number_place_text(
        axis,
        side,
        value_at(axis, on_branches(axis, tau), (a, b, share) => a + share * (b - a)),
      );
  }
}
const symbols: Partial<Record<AxisQuantity, string>> = {
  link_direction: "θ",
  link_ray: "ψ",
  point_ray: "ψC",
  pole_height: "hP",
  pivot_height: "hB₀",
  frame_height: "h",
  pivot_distance: "r₀A",
  output_arm: "rB",
  link_length: "ρ",
  crank_length: "r",
  point_arm: "p",
  crank_range: "β",
  center_x: "x",
  center_y: "y",
  circle_x: "x",
  circle_y: "y",
  center_on_line: "s",
  circle_on_line: "s",
  arm_reach: "u",
  arm_difference: "v",
};
/** Of straight lines, given pivots and paths. */
function number_place_text(axis: Axis, side: Side, value: number): string {
  const symbol = symbols[axis.quantity] ?? "",
    of = axis.quantity.startsWith("link_") || axis.quantity.endsWith("_on_line") ? lower[side] : "";
  return `${symbol}${of} ${is_angle(axis.quantity) ? degrees_text(value) : significant(value, 4)}`;
}
/** Between the engine's ticks, and beyond the last of a branch. */
function value_at(
  {ticks, branches}: Axis,
  tau: number,
  between: (a: number, b: number, share: number) => number,
): number {
  const branch = branches.findLast(({from}) => tau >= from) ?? branches[0];
  const own = (ticks ?? []).filter(([at]) => at >= branch!.from && at < branch!.to);
  const found = own.findIndex(([at]) => at > tau),
    after = found < 0 ? own.length - 1 : Math.max(found, 1);
  const from = own[after - 1],
    to = own[after];
  return from && to ? between(from[1], to[1], (tau - from[0]) / (to[0] - from[0])) : 0;
}
