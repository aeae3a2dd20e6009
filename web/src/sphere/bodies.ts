// Bodies that show an orientation, in their own frame, within a ball of radius 0.78: some simple ones, and triangles that
// come from a file.
import type {SolidBody} from "../state/problem";
import {craft_triangles} from "./craft";
import {length, plus, times, type Vec3} from "./vectors";

const size = 0.78;

function quad(a: Vec3, b: Vec3, c: Vec3, d: Vec3): Vec3[] {
  return [a, b, c, a, c, d];
}
/** Between two quadrangles whose corners go round the same way. */
function prism(bottom: readonly Vec3[], top: readonly Vec3[]): Vec3[] {
  const [a, b, c, d] = bottom as [Vec3, Vec3, Vec3, Vec3],
    [e, f, g, h] = top as [Vec3, Vec3, Vec3, Vec3];
  return [
    ...quad(d, c, b, a),
    ...quad(e, f, g, h),
    ...[0, 1, 2, 3].flatMap((k) => quad(bottom[k]!, bottom[(k + 1) % 4]!, top[(k + 1) % 4]!, top[k]!)),
  ];
}
/** Span along y, swept back a little, its leading edge towards x. */
function wing(): Vec3[] {
  const section = (y: number, front: number, back: number, half: number): Vec3[] => [
    [front, y, 0],
    [(2 * front + back) / 3, y, half],
    [back, y, 0],
    [(front + 2 * back) / 3, y, -half],
  ];
  return prism(section(0.04, 0.2, -0.2, 0.05), section(size, 0.02, -0.16, 0.015));
}
function box(): Vec3[] {
  const corner = (x: number, y: number, z: number): Vec3 => [x * 0.52, y * 0.34, z * 0.2];
  const level = (z: number) => [corner(-1, -1, z), corner(1, -1, z), corner(1, 1, z), corner(-1, 1, z)];
  return prism(level(-1), level(1));
}
/** Open along x, on a stem. */
function dish(): Vec3[] {
  const around = 20,
    rings = [0.001, 0.2, 0.36, 0.5],
    at = (radius: number, k: number): Vec3 => {
      const angle = (2 * Math.PI * k) / around;
      return [0.22 + 1.1 * radius ** 2, radius * Math.cos(angle), radius * Math.sin(angle)];
    };
  const bowl = rings
    .slice(1)
    .flatMap((radius, i) =>
      Array.from({length: around}, (_, k) =>
        quad(at(rings[i]!, k), at(rings[i]!, k + 1), at(radius, k + 1), at(radius, k)),
      ).flat(),
    );
  const square = (x: number, half: number): Vec3[] => [
    [x, -half, -half],
    [x, half, -half],
    [x, half, half],
    [x, -half, half],
  ];
  return [
    ...bowl,
    ...prism(square(-0.12, 0.05), square(0.24, 0.03)),
    ...prism(square(0.24, 0.012), square(0.62, 0.012)),
  ];
}
const simple: Record<string, readonly number[]> = {
  wing: wing().flat(),
  box: box().flat(),
  dish: dish().flat(),
  craft: craft_triangles.map((corner) => times(1.2, corner)).flat(),
};
const known = new Map<string, Float32Array>();

/** Coordinates of three corners to a triangle; nothing where axes alone show it. */
export function body_corners(body: SolidBody): readonly number[] | Float32Array | null {
  if (body.shape === "triad") return null;
  if (body.shape !== "own") return simple[body.shape] ?? null;
  const found = known.get(body.corners) ?? unpacked(body.corners);
  known.set(body.corners, found);
  return found;
}

const most = 32767;
export const most_triangles = 40_000; // a problem file stays below two megabytes

/** Moved to its middle and made to fit; nothing where there are no triangles, or too many. */
export function packed_body(name: string, coordinates: ArrayLike<number>): SolidBody | null {
  const count = coordinates.length / 9;
  if (!Number.isInteger(count) || count === 0 || count > most_triangles) return null;
  const corners: Vec3[] = [];
  for (let i = 0; i < coordinates.length; i += 3)
    corners.push([coordinates[i]!, coordinates[i + 1]!, coordinates[i + 2]!]);
  if (corners.some((corner) => !corner.every(Number.isFinite))) return null;
  const ends = [0, 1, 2].map((k) => {
    let low = Infinity,
      high = -Infinity;
    for (const corner of corners) [low, high] = [Math.min(low, corner[k]!), Math.max(high, corner[k]!)];
    return (low + high) / 2;
  }) as unknown as Vec3;
  const centered = corners.map((corner) => plus(corner, times(-1, ends)));
  let reach = 0;
  for (const corner of centered) reach = Math.max(reach, length(corner));
  if (reach === 0) return null;
  const numbers = Int16Array.from(centered.flat(), (value) => Math.round((value / reach) * most));
  return {shape: "own", name, corners: base64(new Uint8Array(numbers.buffer))};
}
function base64(bytes: Uint8Array): string {
  let text = "";
  for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192));
  return btoa(text);
}
function unpacked(text: string): Float32Array {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)),
    whole = bytes.length - (bytes.length % 18),
    numbers = new Int16Array(bytes.buffer.slice(0, whole));
  return Float32Array.from(numbers, (value) => (size * value) / most);
}
