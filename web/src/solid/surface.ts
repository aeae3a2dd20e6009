// The surface of a part as it is lit: smooth where it is round, with edges where it has them.
import {BufferAttribute, BufferGeometry} from "three";
import type {Machine} from "../contract/messages";
import {most_of} from "../state/ends";

const crease = Math.cos((35 * Math.PI) / 180);

type Triangles = Pick<Machine, "vertices" | "triangles">;

/** Of the triangles `from` … `to`. Corners have a vertex each, for at an edge its faces are lit each in its own way. */
export function lit_surface({vertices, triangles}: Triangles, from: number, to: number): BufferGeometry {
  const corners = triangles.subarray(3 * from, 3 * to),
    position = new Float32Array(3 * corners.length);
  corners.forEach((vertex, corner) => {
    for (let axis = 0; axis < 3; ++axis) position[3 * corner + axis] = vertices[3 * vertex + axis]!;
  });
  return new BufferGeometry()
    .setAttribute("position", new BufferAttribute(position, 3))
    .setAttribute("normal", new BufferAttribute(normals_of(corners, faces_of(position)), 3));
}
/** Normals of triangles, as long as twice their areas. */
function faces_of(at: Float32Array): Float32Array {
  const faces = new Float32Array(at.length / 3);
  for (let face = 0; face < faces.length; face += 3) {
    const at_side = (corner: number, axis: number) => at[3 * (face + corner) + axis]! - at[3 * face + axis]!,
      ax = at_side(1, 0),
      ay = at_side(1, 1),
      az = at_side(1, 2),
      bx = at_side(2, 0),
      by = at_side(2, 1),
      bz = at_side(2, 2);
    faces[face] = ay * bz - az * by;
    faces[face + 1] = az * bx - ax * bz;
    faces[face + 2] = ax * by - ay * bx;
  }
  return faces;
}
/** At each corner the mean of those faces about its vertex that are no crease away from its own. */
function normals_of(corners: Uint32Array, faces: Float32Array): Float32Array {
  const {first, about} = faces_about(corners),
    normals = new Float32Array(3 * corners.length);
  for (let corner = 0; corner < corners.length; ++corner) {
    const own = corner - (corner % 3),
      vertex = corners[corner]!;
    let x = 0,
      y = 0,
      z = 0;
    for (let k = first[vertex]!; k < first[vertex + 1]!; ++k) {
      const face = about[k]!;
      if (!is_smooth(faces, own, face)) continue;
      x += faces[face]!;
      y += faces[face + 1]!;
      z += faces[face + 2]!;
    }
    const length = Math.sqrt(x * x + y * y + z * z) || 1;
    normals[3 * corner] = x / length;
    normals[3 * corner + 1] = y / length;
    normals[3 * corner + 2] = z / length;
  }
  return normals;
}
/** The faces about each vertex, one after the other: those of a vertex from `first` of it on. */
function faces_about(corners: Uint32Array): {first: Uint32Array; about: Uint32Array} {
  const first = new Uint32Array(most_of(corners) + 2),
    about = new Uint32Array(corners.length);
  for (const vertex of corners) ++first[vertex]!;
  for (let vertex = 1; vertex < first.length; ++vertex) first[vertex]! += first[vertex - 1]!;
  corners.forEach((vertex, corner) => (about[--first[vertex]!] = corner - (corner % 3)));
  return {first, about};
}
function is_smooth(faces: Float32Array, a: number, b: number): boolean {
  if (a === b) return true;
  const along = dot(faces, a, b);
  return along > 0 && along * along >= crease * crease * dot(faces, a, a) * dot(faces, b, b);
}
function dot(of: Float32Array, a: number, b: number): number {
  return of[a]! * of[b]! + of[a + 1]! * of[b + 1]! + of[a + 2]! * of[b + 2]!;
}
