// Three rings about the axes of a frame: a drag along one turns the frame about its axis. Which ring is under the
// pointer, and what angle a drag means.
import {arc, column, cross, dot, minus, plus, times, unit, type Rows, type Vec3} from "./vectors";
import type {Spot, View} from "./view";

export const ring_radius = 1;

/** Points around a ring, every three degrees. */
export function ring(frame: Rows, axis: number, radius = ring_radius): Vec3[] {
  return arc(column(frame, axis), times(radius, column(frame, (axis + 1) % 3)), 2 * Math.PI);
}
/** Where a ring has its knob: between the two other axes, on the side of the eye. */
export function knob(frame: Rows, axis: number, towards_eye: Vec3, radius = ring_radius): Vec3 {
  const a = column(frame, (axis + 1) % 3),
    b = column(frame, (axis + 2) % 3);
  const candidates = [plus(a, b), minus(a, b), minus(b, a), times(-1, plus(a, b))];
  const nearest = candidates.reduce((best, other) => (dot(other, towards_eye) > dot(best, towards_eye) ? other : best));
  return times(radius, unit(nearest));
}
/** The ring under the pointer within so many pixels, the part before the middle first; nothing where there is none. */
export function ring_at(
  view: View,
  frame: Rows,
  spot: Spot,
  within: number,
  radius = ring_radius,
): {axis: number; at: Vec3} | null {
  let found: {axis: number; at: Vec3} | null = null,
    least = Infinity;
  for (const axis of [0, 1, 2]) {
    for (const at of ring(frame, axis, radius)) {
      const seen = view.spot(at),
        away = Math.hypot(seen.x - spot.x, seen.y - spot.y),
        behind = dot(at, view.towards_eye) < -0.05 ? within / 2 : 0;
      if (away <= within && away + behind < least) [found, least] = [{axis, at}, away + behind];
    }
  }
  return found;
}

const edge_on = 0.3;

/** What a drag of a ring means: the angle (radians) by which the point that was taken hold of follows the pointer. */
export class RingDrag {
  private readonly axis: Vec3;
  private last = 0;
  private readonly flat: boolean;

  constructor(
    private readonly view: View,
    frame: Rows,
    axis: number,
    private readonly grabbed: Vec3,
    private readonly pressed: Spot,
  ) {
    this.axis = column(frame, axis);
    this.flat = Math.abs(dot(this.axis, view.towards_eye)) < edge_on;
  }
  angle_at(spot: Spot): number {
    return this.flat ? this.along(spot) : this.around(spot);
  }
  /** The ring is seen from its edge: along its tangent. */
  private along(spot: Spot): number {
    const tangent = cross(this.axis, this.grabbed),
      step = 0.01,
      a = this.view.spot(this.grabbed),
      b = this.view.spot(plus(this.grabbed, times(step, tangent)));
    const per_radian = {x: (b.x - a.x) / step, y: (b.y - a.y) / step},
      size = per_radian.x ** 2 + per_radian.y ** 2;
    if (size === 0) return 0;
    return ((spot.x - this.pressed.x) * per_radian.x + (spot.y - this.pressed.y) * per_radian.y) / size;
  }
  /** In the plane of the ring, whole turns counted. */
  private around(spot: Spot): number {
    const to = this.in_plane(spot),
      start = this.in_plane(this.pressed);
    if (!to || !start) return this.last;
    const raw = Math.atan2(dot(this.axis, cross(start, to)), dot(start, to)),
      turns = Math.round((this.last - raw) / (2 * Math.PI));
    return (this.last = raw + 2 * Math.PI * turns);
  }
  private in_plane(spot: Spot): Vec3 | null {
    const {from, along} = this.view.ray(spot),
      slope = dot(along, this.axis);
    if (Math.abs(slope) < 1e-6) return null;
    return plus(from, times(-dot(from, this.axis) / slope, along));
  }
}
