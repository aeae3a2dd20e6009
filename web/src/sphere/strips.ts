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
  geometry.setAttribute("other", values(4));
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
/** A beginning and an end to each stretch. */
export function put_stretches(strip: BufferGeometry, ends: readonly Vec3[]): void {
  const position = strip.getAttribute("position") as BufferAttribute,
    other = strip.getAttribute("other") as BufferAttribute,
    along = strip.getAttribute("along") as BufferAttribute | undefined;
  let far = 0;
  for (let k = 0; 2 * k < ends.length; ++k) {
    const from = ends[2 * k]!,
      to = ends[2 * k + 1]!,
      next = along ? far + length(minus(to, from)) : 0;
    for (let i = 0; i < corners; ++i) {
      const [here, there] = i < 2 ? [from, to] : [to, from],
        side = (i % 2 ? 1 : -1) * (i < 2 ? 1 : 2);
      position.setXYZ(corners * k + i, here[0], here[1], here[2]);
      other.setXYZW(corners * k + i, there[0], there[1], there[2], side);
      along?.setX(corners * k + i, i < 2 ? far : next);
    }
    far = next;
  }
  for (const values of [position, other, along]) if (values) values.needsUpdate = true;
  strip.setDrawRange(0, 3 * ends.length);
}
