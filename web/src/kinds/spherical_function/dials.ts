// The scales of input and output on the sphere: circles about the fixed axes with a mark to each pair, where the link's
// arc crosses the circle there.
import type {Linkage, Side} from "../../contract/messages";
import type {Item, Label, SphereColor} from "../../sphere/item";
import {any_normal, arc, cross, dot, minus, plus, times, unit, type Vec3} from "../../sphere/vectors";
import type {DegreePair} from "../function/replies";

const most_radius_deg = 24,
  share = 0.42; // of the way between the axes
const radians = Math.PI / 180;
export const sides = ["input", "output"] as const;

export interface SphereDial {
  side: Side;
  axis: Vec3;
  /** At a right angle to the axis: where the scale's zero lies. */
  zero: Vec3;
  radius_deg: number;
  /** Degrees on the scale, by pair. */
  angles_deg: readonly number[];
}
/** (0, 0, 1) and the output's. */
export function fixed_axes(ground_angle_deg: number): Record<Side, Vec3> {
  const angle = ground_angle_deg * radians;
  return {input: [0, 0, 1], output: [Math.sin(angle), 0, Math.cos(angle)]};
}
function turned(axis: Vec3, from: Vec3, angle_deg: number): Vec3 {
  return arc(axis, from, angle_deg * radians).at(-1)!;
}
function aside_of(axis: Vec3, point: Vec3): Vec3 {
  const aside = minus(point, times(dot(point, axis), axis));
  return dot(aside, aside) > 1e-18 ? unit(aside) : any_normal(axis);
}
/** Where the scale's zero lies, so that the link in hand points to the first mark in position 1. */
function zero_of(side: Side, axes: Record<Side, Vec3>, hand: Linkage | null): Vec3 {
  const moving = hand?.spherical?.[`${side}_moving`],
    first = hand?.function?.pairs[0]?.[side === "input" ? 0 : 1];
  const axis = axes[side];
  if (moving && first !== undefined) return turned(axis, aside_of(axis, moving), -first);
  const other = aside_of(axis, axes[side === "input" ? "output" : "input"]);
  return side === "input" ? other : times(-1, other); // the arc between the axes, and its continuation
}
export function dials_of(ground_angle_deg: number, pairs: readonly DegreePair[], hand: Linkage | null): SphereDial[] {
  const axes = fixed_axes(ground_angle_deg),
    radius_deg = Math.min(share * Math.min(ground_angle_deg, 180 - ground_angle_deg), most_radius_deg);
  return sides.map((side) => ({
    side,
    axis: axes[side],
    zero: zero_of(side, axes, hand),
    radius_deg,
    angles_deg: pairs.map((pair) => pair[side === "input" ? 0 : 1]),
  }));
}
/** On the ball, at an angle of the scale; `out`: times the circle's radius. */
export function on_dial({axis, zero, radius_deg}: SphereDial, angle_deg: number, out = 1): Vec3 {
  const radius = out * radius_deg * radians;
  return plus(times(Math.cos(radius), axis), times(Math.sin(radius), turned(axis, zero, angle_deg)));
}
/** The angle of the scale, ±180, in whose direction a point lies. */
export function angle_on_dial({axis, zero}: SphereDial, point: Vec3): number {
  return Math.atan2(dot(cross(zero, point), axis), dot(zero, point)) / radians;
}

/** At both ends of each axis, which is a line; marks and numbers at its own end, with an arrow for the right hand. */
export function dials_picture(dials: readonly SphereDial[]): {items: Item[]; labels: Label[]} {
  const items: Item[] = [],
    labels: Label[] = [];
  for (const dial of dials) {
    const {side, axis, angles_deg} = dial,
      color: SphereColor = side,
      rim = arc(axis, on_dial(dial, 0), 2 * Math.PI);
    for (const sense of [1, -1])
      items.push({
        kind: "path",
        key: `dial ${side} ${sense}`,
        points: rim.map((point) => times(sense, point)),
        color,
        width: 1.4,
        opacity: sense > 0 ? 0.8 : 0.35,
        on_ball: true,
      });
    items.push({kind: "arrow", key: `shaft ${side}`, from: axis, to: times(1.28, axis), color, width: 4});
    angles_deg.forEach((angle, index) => {
      items.push({
        kind: "path",
        key: `mark ${side} ${index}`,
        points: [on_dial(dial, angle, 0.8), on_dial(dial, angle)],
        color,
        width: 2,
        on_ball: true,
      });
      labels.push({key: `mark ${side} ${index}`, at: on_dial(dial, angle, 1.12), text: String(index + 1), color});
    });
  }
  return {items, labels};
}
