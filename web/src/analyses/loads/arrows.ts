// Weights, given forces and that of the hand as arrows, where the linkage stands.
import type {Point} from "../../contract/messages";
import {usual_gravity, type LoadCase, type Loads} from "./block";
import {place_of, type Frames} from "./places";

export interface Arrow {
  kind: "weight" | "force" | "hand";
  /** What it acts on. */
  at: Point;
  /** N, in the fixed frame. */
  force: Point;
}
const turned = ([x, y]: Point, deg: number): Point => {
  const [c, s] = [Math.cos((deg * Math.PI) / 180), Math.sin((deg * Math.PI) / 180)];
  return [c * x - s * y, s * x + c * y];
};
const times = ([x, y]: Point, by: number): Point => [by * x, by * y];

/** m/s². A ground that rises to the right turns it clockwise. */
export function gravity_in({gravity}: Loads, {slope_deg = 0}: LoadCase): Point {
  if (gravity === null) return [0, 0];
  return turned([gravity?.acceleration ?? usual_gravity, 0], (gravity?.direction_deg ?? -90) - slope_deg);
}
/** Of the body and the further loads; those of the links, spread over them, are left out. */
export function weights_of(loads: Loads, of: LoadCase, frames: Frames): Arrow[] {
  const gravity = gravity_in(loads, of),
    acting = (loads.extra ?? []).filter(({always, name}) => always || of.extra?.includes(name));
  const weight = (at: Point | null, mass: number): Arrow[] =>
    at && mass > 0 ? [{kind: "weight", at, force: times(gravity, mass)}] : [];
  const {body} = loads;
  return [
    ...(body ? weight(place_of({on: "body", at: body.center ?? [0, 0]}, frames), body.mass) : []),
    ...acting.flatMap((extra): Arrow[] => {
      const at = place_of(extra, frames),
        frame = frames[extra.on];
      if (!at || !frame) return [];
      if ("mass" in extra) return weight(at, extra.mass);
      return [{kind: "force", at, force: extra.frame === "body" ? turned(extra.force, frame.theta_deg) : extra.force}];
    }),
  ].filter(({force: [x, y]}) => Math.hypot(x, y) > 0);
}
/** Which way a force of the hand points that is above nothing; `way`: how the handle moves while it opens. */
export function hand_direction(loads: Loads, of: LoadCase, way: Point): Point | null {
  const {direction = "tangential"} = loads.handle ?? {},
    along: Point = typeof direction === "object" ? turned([1, 0], direction.fixed_deg) : way,
    [x, y] = direction === "vertical" ? times(gravity_in(loads, of), -1) : along,
    length = Math.hypot(x, y);
  return length > 0 ? [x / length, y / length] : null;
}
