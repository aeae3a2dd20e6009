// Vectors of space for drawing: what lies on circles and balls. What a motion makes of them the engine says.
export type Vec3 = readonly [x: number, y: number, z: number];
/** A matrix by its rows; as a frame, its columns are the axes. */
export type Rows = readonly [Vec3, Vec3, Vec3];

export const identity: Rows = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/** From where one looks at first. */
export const first_eye: Vec3 = [1, 0.55, 0.5];

export function plus(a: Vec3, b: Vec3): Vec3 {
  return [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
}
export function minus(a: Vec3, b: Vec3): Vec3 {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}
export function times(k: number, a: Vec3): Vec3 {
  return [k * a[0], k * a[1], k * a[2]];
}
export function dot(a: Vec3, b: Vec3): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
export function cross(a: Vec3, b: Vec3): Vec3 {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}
export function length(a: Vec3): number {
  return Math.hypot(a[0], a[1], a[2]);
}
/** The vector at length 1; z for what has no direction. */
export function unit(a: Vec3): Vec3 {
  const size = length(a);
  return size > 0 ? times(1 / size, a) : [0, 0, 1];
}
/** Any unit vector at a right angle. */
export function any_normal(a: Vec3): Vec3 {
  const [x, y, z] = a.map(Math.abs) as unknown as Vec3;
  return unit(cross(a, x <= y && x <= z ? [1, 0, 0] : y <= z ? [0, 1, 0] : [0, 0, 1]));
}
export function column(frame: Rows, k: number): Vec3 {
  return [frame[0][k]!, frame[1][k]!, frame[2][k]!];
}
/** Coordinates in the frame to coordinates outside it. */
export function seen_from_outside(frame: Rows, a: Vec3): Vec3 {
  return [dot(frame[0], a), dot(frame[1], a), dot(frame[2], a)];
}

/** Points along the arc on which `from` runs about a unit axis through the origin, `angle` radians, at even steps of a
 *  few degrees. */
export function arc(axis: Vec3, from: Vec3, angle: number): Vec3[] {
  const along = times(dot(axis, from), axis),
    across = minus(from, along),
    aside = cross(axis, across);
  const steps = Math.max(2, Math.ceil(Math.abs(angle) / 0.07));
  return Array.from({length: steps + 1}, (_, k) => {
    const t = (angle * k) / steps;
    return plus(along, plus(times(Math.cos(t), across), times(Math.sin(t), aside)));
  });
}
/** A circle about the origin in the plane at a right angle to the axis. */
export function circle(axis: Vec3, radius = 1): Vec3[] {
  return arc(unit(axis), times(radius, any_normal(axis)), 2 * Math.PI);
}
/** The shorter great-circle arc between two unit vectors that are not opposite. */
export function great_circle(from: Vec3, to: Vec3): Vec3[] {
  const normal = cross(from, to);
  return arc(unit(normal), from, Math.atan2(length(normal), dot(from, to)));
}
