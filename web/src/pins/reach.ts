// How far a linkage reaches, for small pictures.
import type {Linkage, Point} from "../engine/protocol";
import {row_count, row_joints, row_state} from "../state/drive";
import {least_of, most_of} from "../state/ends";

const every = 4; // rows

/** Its pivots between the first position and the last. */
export function reach_of({drive, input, output, six_bar}: Linkage): Point[] {
  if (!drive || !input.center || !output.center) return [];
  const {task} = drive,
    [first, last] =
      task[0] < 0 || task[1] < 0 ? [0, six_bar ? row_count(drive) - 1 : 0] : [least_of(task), most_of(task)];
  const points: Point[] = six_bar ? [] : [input.center, output.center];
  for (let row = first; row <= last; row += every) {
    const {ax, ay, bx, by} = row_state(drive, row);
    points.push(...(six_bar ? row_joints(drive, row) : [[ax, ay] as Point, [bx, by] as Point]));
  }
  return points;
}
export function room_around(points: readonly Point[]): {x: number; y: number; width: number; height: number} {
  const xs = points.map((p) => p[0]),
    ys = points.map((p) => p[1]);
  const x = least_of(xs),
    y = least_of(ys),
    size = Math.max(most_of(xs) - x, most_of(ys) - y, 1e-9),
    room = 0.06 * size;
  return {x: x - room, y: y - room, width: most_of(xs) - x + 2 * room, height: most_of(ys) - y + 2 * room};
}
