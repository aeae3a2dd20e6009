// Linkages in small pictures: as they stand, and how much room they take.
import type {Linkage, Point} from "../contract/messages";
import type {Figure} from "../figure/figure";
import {at_angle, at_row, task_rows, type Mechanism} from "../figure/mechanism";
import {angle_at_stage, row_count} from "../state/drive";
import {least_of, most_of} from "../state/ends";

const every = 4; // rows

/** Where its drive stands at a stage; nothing without a drive. */
export function figure_at_stage(
  mechanism: Mechanism,
  linkage: Linkage,
  outline: readonly Point[],
  stage: number,
): Figure | null {
  const {drive} = linkage;
  if (!drive) return null;
  return mechanism.figure(linkage, at_angle(mechanism, linkage, drive, angle_at_stage(drive, stage)), outline);
}
/** Its pivots between the first position and the last, or wherever it can be driven. */
export function reach_of(mechanism: Mechanism, linkage: Linkage): Point[] {
  const {drive} = linkage;
  if (!drive) return [];
  const [first, last] = task_rows(drive) ?? [0, row_count(drive) - 1],
    points: Point[] = [];
  for (let row = first; row <= last; row += every) points.push(...at_row(mechanism, linkage, drive, row).joints);
  return points;
}
export interface Room {
  x: number;
  y: number;
  width: number;
  height: number;
}
export function room_around(points: readonly Point[]): Room {
  const xs = points.map((p) => p[0]),
    ys = points.map((p) => p[1]);
  const x = least_of(xs),
    y = least_of(ys),
    size = Math.max(most_of(xs) - x, most_of(ys) - y, 1e-9),
    room = 0.06 * size;
  return {x: x - room, y: y - room, width: most_of(xs) - x + 2 * room, height: most_of(ys) - y + 2 * room};
}
