// The surface of a part as it is lit: smooth where it is round, with edges where it has them.
import {BufferAttribute, BufferGeometry} from "three";
import type {Machine} from "../contract/messages";

const crease = Math.cos((35 * Math.PI) / 180);

type Triangles = Pick<Machine, "vertices" | "triangles">;

/** Of the triangles `from` … `to`. Corners have a vertex each, for at an edge its faces are lit each in its own way. */
export function lit_surface({vertices, triangles}: Triangles, from: number, to: number): BufferGeometry {
  const corners = triangles.subarray(3 * from, 3 * to),
    position = new Float32Array(3 * corners.length);
  corners.forEach((vertex, corner) => position.set(vertices.subarray(3 * vertex, 3 * vertex + 3), 3 * corner));
  return new BufferGeometry()
    .setAttribute("position", new BufferAttribute(position, 3))
    .setAttribute("normal", new BufferAttribute(normals_of(corners, faces_of(position)), 3));
}
/** Normals of triangles, as long as twice their areas. */
function faces_of(at: Float32Array): Float32Array {
  const faces = new Float32Array(at.length / 3);
  for (let face = 0; face < faces.length; face += 3) {
    const side = (corner: number, axis: number) => at[3 * (face + corner) + axis]! - at[3 * face + axis]!,
      across = (a: number, b: number) => side(1, a) * side(2, b) - side(1, b) * side(2, a);
    faces.set([across(1, 2), across(2, 0), across(0, 1)], face);
  }
  return faces;
}
/** At each corner the mean of those faces about its vertex that are no crease away from its own. */
function normals_of(corners: Uint32Array, faces: Float32Array): Float32Array {
  const about = faces_about(corners),
    normals = new Float32Array(3 * corners.length);
  corners.forEach((vertex, corner) => {
    const own = 3 * Math.floor(corner / 3),
      sum = [0, 0, 0];
    for (const face of about.get(vertex)!)
      if (is_smooth(faces, own, face)) for (const axis of [0, 1, 2]) sum[axis]! += faces[face + axis]!;
    const length = Math.hypot(...sum) || 1;
    for (const axis of [0, 1, 2]) normals[3 * corner + axis] = sum[axis]! / length;
  });
  return normals;
}
function faces_about(corners: Uint32Array): Map<number, number[]> {
  const about = new Map<number, number[]>();
  corners.forEach((vertex, corner) => {
    const face = 3 * Math.floor(corner / 3),
      known = about.get(vertex);
    if (known) known.push(face);
    else about.set(vertex, [face]);
  });
  return about;
}
function is_smooth(faces: Float32Array, a: number, b: number): boolean {
  const dot = (i: number, k: number) =>
    faces[i]! * faces[k]! + faces[i + 1]! * faces[k + 1]! + faces[i + 2]! * faces[k + 2]!;
  return dot(a, b) >= crease * Math.sqrt(dot(a, a) * dot(b, b));
}
