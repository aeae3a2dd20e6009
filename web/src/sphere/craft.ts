// A body whose attitude is seen at a glance: nose along x, wings along ±y, fin along z. Three corners to a triangle.
import type {Vec3} from "./vectors";

const nose: Vec3 = [0.62, 0, 0],
  tail: Vec3 = [-0.42, 0, 0.02],
  keel: Vec3 = [-0.3, 0, -0.07],
  spine: Vec3 = [-0.26, 0, 0.1],
  fin: Vec3 = [-0.5, 0, 0.34];
const mirrored = ([x, y, z]: Vec3): Vec3 => [x, -y, z];
const left: Vec3 = [-0.34, 0.5, 0],
  root: Vec3 = [0.2, 0.05, 0];

const half: Vec3[][] = [
  [nose, root, spine],
  [nose, keel, root],
  [root, left, spine],
  [root, keel, left],
  [left, tail, spine],
  [left, keel, tail],
];
export const craft_triangles: readonly Vec3[] = [
  ...half.flat(),
  ...half.flatMap(([a, b, c]) => [mirrored(a!), mirrored(c!), mirrored(b!)]),
  ...[spine, fin, tail],
];
