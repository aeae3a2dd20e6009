// Direction and curvature of travel: the derivatives of a pose as a person thinks of them. They are by path length of
// the moving frame's origin, wherever it moves; other parameters are brought to it and keep their geometry.
import type {Pose} from "../state/task";

type Derivative = {x: number; y: number; theta: number};
const degree = Math.PI / 180;

export interface Travel {
  /** Way the origin goes, degrees. */
  direction_deg: number;
  /** Turn of the body per unit of path. */
  turn_deg: number;
}
export interface Bend {
  /** Signed curvature of the origin's path, left positive. */
  curvature: number;
  /** Growth of the turn, per unit of path squared. */
  turn_growth_deg: number;
}

const speed_of = (first: Derivative) => Math.hypot(first.x, first.y);

/** Null where the origin stands still: then the body only turns about it, and there is no direction to show. */
export function travel_of(pose: Pose): Travel | null {
  const first = pose.derivatives?.[0];
  if (!first || !(speed_of(first) > 0)) return null;
  return {direction_deg: Math.atan2(first.y, first.x) / degree, turn_deg: first.theta / speed_of(first) / degree};
}
export function bend_of(pose: Pose): Bend | null {
  const [first, second] = pose.derivatives ?? [];
  const speed = first ? speed_of(first) : 0;
  if (!second || !(speed > 0)) return null;
  const along = (first.x * second.x + first.y * second.y) / speed ** 2; // growth of speed over speed
  return {
    curvature: (first.x * second.y - first.y * second.x) / speed ** 3,
    turn_growth_deg: (second.theta - along * first.theta) / speed ** 2 / degree,
  };
}

export function with_travel(pose: Pose, change: Partial<Travel>): Pose {
  const bend = bend_of(pose);
  const {direction_deg, turn_deg} = {...(travel_of(pose) ?? {direction_deg: 0, turn_deg: 0}), ...change};
  const first = {x: Math.cos(direction_deg * degree), y: Math.sin(direction_deg * degree), theta: turn_deg * degree};
  const turned = {...pose, derivatives: [first]};
  return bend ? with_bend(turned, bend) : turned;
}
export function with_bend(pose: Pose, change: Partial<Bend>): Pose {
  const travel = travel_of(pose) ?? {direction_deg: 0, turn_deg: 0};
  const {curvature, turn_growth_deg} = {...(bend_of(pose) ?? {curvature: 0, turn_growth_deg: 0}), ...change};
  const c = Math.cos(travel.direction_deg * degree), s = Math.sin(travel.direction_deg * degree);
  const first = {x: c, y: s, theta: travel.turn_deg * degree};
  return {...pose, derivatives: [first, {x: -curvature * s, y: curvature * c, theta: turn_growth_deg * degree}]};
}
export function without_last_derivative(pose: Pose): Pose {
  const {derivatives = [], ...rest} = pose;
  return derivatives.length > 1 ? {...rest, derivatives: derivatives.slice(0, -1)} : rest;
}

/** A pose with one derivative more, as a smooth motion through its neighbours has it there. */
export function with_next_derivative(poses: readonly Pose[], index: number): Pose {
  const pose = poses[index], smooth = smooth_derivatives(poses, index);
  const count = (pose.derivatives?.length ?? 0) + 1;
  if (count === 1) return with_travel(pose, rounded_travel(travel_of({...pose, derivatives: [smooth[0]]})));
  const bend = bend_of({...pose, derivatives: smooth});
  return with_bend(pose, bend ? {curvature: rounded(bend.curvature), turn_growth_deg: rounded(bend.turn_growth_deg)} : {});
}
function rounded(value: number): number {
  return Number(value.toPrecision(3));
}
function rounded_travel(travel: Travel | null): Travel {
  return travel ? {direction_deg: Math.round(travel.direction_deg), turn_deg: rounded(travel.turn_deg)} : {direction_deg: 0, turn_deg: 0};
}

/** Of the parabola through the nearest three poses (chord lengths as parameter), of the chord of two. */
function smooth_derivatives(poses: readonly Pose[], index: number): [Derivative, Derivative] {
  const still = {x: 0, y: 0, theta: 0};
  const first = Math.min(Math.max(index - 1, 0), Math.max(poses.length - 3, 0));
  const near = unwound(poses.slice(first, first + 3)), at = index - first;
  if (near.length < 2) return [{x: 1, y: 0, theta: 0}, still];
  const chords = near.slice(1).map((p, i) => Math.hypot(p.x - near[i].x, p.y - near[i].y) || 1);
  const slopes = chords.map((chord, i) => divided(near[i + 1], near[i], chord));
  if (near.length === 2) return [slopes[0], still];
  const bend = divided(slopes[1], slopes[0], (chords[0] + chords[1]) / 2);
  const from = at === 0 ? -chords[0] / 2 : at === 1 ? chords[0] / 2 : chords[0] / 2 + chords[1];
  return [sum(slopes[0], bend, from), bend];
}
function unwound(poses: readonly Pose[]): Derivative[] {
  const list: Derivative[] = [];
  for (const {x, y, theta_deg} of poses) {
    const before = list.at(-1)?.theta ?? theta_deg * degree, theta = theta_deg * degree;
    list.push({x, y, theta: theta - 2 * Math.PI * Math.round((theta - before) / (2 * Math.PI))});
  }
  return list;
}
function divided(a: Derivative, b: Derivative, by: number): Derivative {
  return {x: (a.x - b.x) / by, y: (a.y - b.y) / by, theta: (a.theta - b.theta) / by};
}
function sum(a: Derivative, b: Derivative, times: number): Derivative {
  return {x: a.x + times * b.x, y: a.y + times * b.y, theta: a.theta + times * b.theta};
}
