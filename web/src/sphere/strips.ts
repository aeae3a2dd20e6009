// Lines as strips of two triangles to a stretch, which the paint (paints.ts) gives their width. No instances: a processor
// that draws takes each of those for a drawing of its own.
import {BufferAttribute, BufferGeometry, DynamicDrawUsage} from "three";
import {length, minus, type Vec3} from "./vectors";

const corners = 4;

/** How many stretches there is room for where so many are wanted: there will be more. */
function room_for(stretches: number): number {
  return 2 ** Math.ceil(Math.log2(Math.max(stretches, 1)));
}
/** With room for so many stretches at least; `dashed` also knows how far along the line a corner lies. */
export function new_strip(stretches: number, dashed: boolean): BufferGeometry {
  const room = room_for(stretches),
    geometry = new BufferGeometry();
  const values = (size: number) =>
    new BufferAttribute(new Float32Array(corners * room * size), size).setUsage(DynamicDrawUsage);
  geometry.setAttribute("position", values(3));
  geometry.setAttribute("before", values(3));
  geometry.setAttribute("behind", values(3));
  const side = new Float32Array(corners * room).map((_, i) => (i % 2 ? 1 : -1));
  geometry.setAttribute("side", new BufferAttribute(side, 1));
  if (dashed) geometry.setAttribute("along", values(1));
  const index = new Uint32Array(6 * room);
  for (let k = 0; k < room; ++k)
    index.set(
      [0, 1, 2, 2, 1, 3].map((i) => corners * k + i),
      6 * k,
    );
  geometry.setIndex(new BufferAttribute(index, 1));
  return geometry;
}
export function has_room(strip: BufferGeometry, stretches: number): boolean {
  return strip.getAttribute("position").count >= corners * stretches;
}
/** A beginning and an end to each stretch; where one begins with the point at which the last one ends, they are joined
 *  without a gap: the points behind and before a corner say which way the line goes there. */
export function put_stretches(strip: BufferGeometry, ends: readonly Vec3[]): void {
  const values = (name: string) => strip.getAttribute(name) as BufferAttribute | undefined,
    [position, behind, before, along] = [values("position")!, values("behind")!, values("before")!, values("along")];
  const count = ends.length / 2,
    joined = (k: number) => k > 0 && k < count && ends[2 * k] === ends[2 * k - 1]; // to the one before it
  let far = 0;
  for (let k = 0; k < count; ++k) {
    const from = ends[2 * k]!,
      to = ends[2 * k + 1]!,
      last = joined(k) ? ends[2 * k - 2]! : from,
      next = joined(k + 1) ? ends[2 * k + 3]! : to,
      end = along ? far + length(minus(to, from)) : 0;
    for (let i = corners * k; i < corners * k + 2; ++i) {
      position.setXYZ(i, ...from);
      behind.setXYZ(i, ...last);
      before.setXYZ(i, ...to);
      along?.setX(i, far);
      position.setXYZ(i + 2, ...to);
      behind.setXYZ(i + 2, ...from);
      before.setXYZ(i + 2, ...next);
      along?.setX(i + 2, end);
    }
    far = end;
  }
  for (const changed of [position, behind, before, along]) if (changed) changed.needsUpdate = true;
  strip.setDrawRange(0, 3 * ends.length);
}
