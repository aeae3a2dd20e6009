// The dials about the ground pivots: a mark to each pair, in the direction that the link has there.
import type {Point, Side} from "../../contract/messages";
import type {DegreePair} from "./replies";
import type {Surface} from "../../drawing/surface";
import {ground_pivots_of} from "./kind";
import {function_of, pairs_in_hand} from "./pairs";

export interface Mark {
  pair: number;
  side: Side;
  angle_deg: number; // on the dial
  at: Point; // screen
}
export interface AngleScale {
  side: Side;
  center: Point; // screen
  radius: number; // pixels
  zero_deg: number; // direction of the dial's zero
  marks: Mark[];
}
const most_radius = 58,
  least_radius = 26,
  share = 0.42; // of the way between the pivots
const sides = ["input", "output"] as const;

/** While a mark is dragged its dial keeps still. */
const held_zeros = new WeakMap<Surface, Record<Side, number>>();
export function hold_angle_scales(surface: Surface): void {
  held_zeros.set(surface, {input: zero_of(surface, "input"), output: zero_of(surface, "output")});
}
export function release_angle_scales(surface: Surface): void {
  held_zeros.delete(surface);
}

function zero_of({workbench}: Surface, side: Side): number {
  const {hand} = workbench,
    link = hand?.[side],
    first = hand?.function?.pairs[0]?.[side === "input" ? 0 : 1];
  if (!link?.center || !link.circle || first === undefined) return 0;
  return (Math.atan2(link.circle[1] - link.center[1], link.circle[0] - link.center[0]) * 180) / Math.PI - first;
}
export function on_angle_scale(center: Point, radius: number, direction_deg: number): Point {
  const angle = (direction_deg * Math.PI) / 180;
  return [center[0] + radius * Math.cos(angle), center[1] - radius * Math.sin(angle)];
}
export function angle_scales_of(surface: Surface): AngleScale[] {
  const {workbench, space} = surface,
    pivots = ground_pivots_of(function_of(workbench.problem)),
    pairs = pairs_in_hand(workbench);
  const at = {input: space.project(pivots.input), output: space.project(pivots.output)};
  const apart = Math.hypot(at.input[0] - at.output[0], at.input[1] - at.output[1]);
  const radius = Math.min(Math.max(share * apart, least_radius), most_radius);
  return sides.map((side) => {
    const zero_deg = held_zeros.get(surface)?.[side] ?? zero_of(surface, side),
      center = at[side];
    const mark = (pair: DegreePair, index: number): Mark => {
      const angle_deg = pair[side === "input" ? 0 : 1];
      return {pair: index, side, angle_deg, at: on_angle_scale(center, radius, zero_deg + angle_deg)};
    };
    return {side, center, radius, zero_deg, marks: pairs.map(mark)};
  });
}
