// Direction and curvature of travel: the derivatives of a pose as a person thinks of them. They are by path length of
// the moving frame's origin, wherever it moves; other parameters are brought to it and keep their geometry.
import type {Pose} from "../state/task";
import type {TextKey} from "../texts/texts.svelte";
import {by_parameter, product, quotient, square_root} from "./derivatives";

type Derivative = {x: number; y: number; theta: number};
const degree = Math.PI / 180;
const still: Derivative = {x: 0, y: 0, theta: 0};

export interface Travel {
  /** Way the origin goes, degrees. */
  direction_deg: number;
  /** Turn of the body per unit of path. */
  turn_deg: number;
}
/** Of the second derivative; of a higher one what both are the growth of, per unit of path once or twice more. */
export interface Bend {
  /** Signed curvature of the origin's path, left positive. */
  curvature: number;
  /** Growth of the turn, per unit of path squared. */
  turn_growth_deg: number;
}
/** All derivatives: curvature of the origin's path and turn of the body (radians) with their growths. */
interface Course {
  direction: number;
  curvatures: readonly number[]; // one fewer
  turns: readonly number[];
}

/** Null where the origin stands still: then the body only turns about it, and there is no direction to show. */
function course_of({derivatives = []}: Pose): Course | null {
  const x = derivatives.map((d) => d.x),
    y = derivatives.map((d) => d.y),
    [first] = derivatives;
  if (!first || !(Math.hypot(first.x, first.y) > 0)) return null;
  const square = added(product(x, x), product(y, y)),
    speed = square_root(square);
  const turning = quotient(
    added(
      product(x, y.slice(1)),
      product(
        y.map((value) => -value),
        x.slice(1),
      ),
    ),
    square,
  );
  return {
    direction: Math.atan2(first.y, first.x),
    curvatures: by_parameter(turning, speed),
    turns: by_parameter(
      derivatives.map((d) => d.theta),
      speed,
    ),
  };
}
function with_course(pose: Pose, {direction, curvatures, turns}: Course): Pose {
  const x = [Math.cos(direction)],
    y = [Math.sin(direction)];
  for (const n of curvatures.keys()) {
    const back = product(curvatures, y)[n],
      aside = product(curvatures, x)[n];
    x.push(-back!);
    y.push(aside!);
  }
  return {...pose, derivatives: turns.map((theta, n) => ({x: x[n]!, y: y[n]!, theta}))};
}
function added(f: readonly number[], g: readonly number[]): number[] {
  return f.map((value, n) => value + g[n]!);
}

export function travel_of(pose: Pose): Travel | null {
  const course = course_of(pose);
  return course && {direction_deg: course.direction / degree, turn_deg: course.turns[0]! / degree};
}
/** Of the derivative of an order, from the second on. */
export function bend_of(pose: Pose, order = 2): Bend | null {
  const course = course_of(pose);
  if (!course || course.turns.length < order) return null;
  return {curvature: course.curvatures[order - 2]!, turn_growth_deg: course.turns[order - 1]! / degree};
}

const standing: Course = {direction: 0, curvatures: [], turns: [0]};
export function with_travel(pose: Pose, change: Partial<Travel>): Pose {
  const {direction, curvatures, turns} = course_of(pose) ?? standing;
  const {direction_deg = direction / degree, turn_deg = turns[0]! / degree} = change;
  return with_course(pose, {direction: direction_deg * degree, curvatures, turns: turns.with(0, turn_deg * degree)});
}
export function with_bend(pose: Pose, change: Partial<Bend>, order = 2): Pose {
  const course = course_of(pose) ?? standing,
    count = Math.max(order, course.turns.length);
  const filled = (list: readonly number[], length: number) => Array.from({length}, (_, n) => list[n] ?? 0);
  const curvatures = filled(course.curvatures, count - 1),
    turns = filled(course.turns, count);
  if (change.curvature !== undefined) curvatures[order - 2] = change.curvature;
  if (change.turn_growth_deg !== undefined) turns[order - 1] = change.turn_growth_deg * degree;
  return with_course(pose, {...course, curvatures, turns});
}
/** Without the derivative of an order, and so without those above it. */
export function without_derivative(pose: Pose, order: number): Pose {
  const {derivatives = [], ...rest} = pose;
  return order > 1 ? {...rest, derivatives: derivatives.slice(0, order - 1)} : rest;
}
/** What it is called to take the derivative of an order away. */
export function removal_text({derivatives = []}: Pose, order: number): TextKey {
  if (order < derivatives.length) return "task.remove_derivatives";
  return order === 1 ? "task.remove_tangent" : order === 2 ? "task.remove_curvature" : "task.remove_derivative";
}

/** A pose with one derivative more, as a smooth motion through its neighbours has it there. */
export function with_next_derivative(poses: readonly Pose[], index: number): Pose {
  const pose = poses[index]!,
    known = pose.derivatives ?? [],
    order = known.length + 1;
  const smooth = {...pose, derivatives: [...smooth_derivatives(poses, index), still, still]};
  if (order === 1) return with_travel(pose, rounded_travel(travel_of(smooth)));
  if (!travel_of(pose)) return {...pose, derivatives: [...known, still]};
  const bend = bend_of(smooth, order);
  return with_bend(
    pose,
    bend ? {curvature: rounded(bend.curvature), turn_growth_deg: rounded(bend.turn_growth_deg)} : {},
    order,
  );
}
function rounded(value: number): number {
  return Number(value.toPrecision(3));
}
function rounded_travel(travel: Travel | null): Travel {
  return travel
    ? {direction_deg: Math.round(travel.direction_deg), turn_deg: rounded(travel.turn_deg)}
    : {direction_deg: 0, turn_deg: 0};
}

/** Of the parabola through the nearest three poses (chord lengths as parameter), of the chord of two. */
function smooth_derivatives(poses: readonly Pose[], index: number): [Derivative, Derivative] {
  const first = Math.min(Math.max(index - 1, 0), Math.max(poses.length - 3, 0));
  const near = unwound(poses.slice(first, first + 3)),
    at = index - first;
  const [a, b, c] = near;
  if (!a || !b) return [{x: 1, y: 0, theta: 0}, still];
  const chord = (p: Derivative, q: Derivative) => Math.hypot(q.x - p.x, q.y - p.y) || 1;
  const first_chord = chord(a, b),
    slope = divided(b, a, first_chord);
  if (!c) return [slope, still];
  const second_chord = chord(b, c),
    bend = divided(divided(c, b, second_chord), slope, (first_chord + second_chord) / 2);
  const from = at === 0 ? -first_chord / 2 : at === 1 ? first_chord / 2 : first_chord / 2 + second_chord;
  return [sum(slope, bend, from), bend];
}
function unwound(poses: readonly Pose[]): Derivative[] {
  const list: Derivative[] = [];
  for (const {x, y, theta_deg} of poses) {
    const before = list.at(-1)?.theta ?? theta_deg * degree,
      theta = theta_deg * degree;
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
