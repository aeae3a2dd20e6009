// A spherical linkage in one state of its drive, and where its links lie: for drawing. The states are the engine's.
import type {Drive, Linkage} from "../../contract/messages";
import {joints_at, row_count, row_joints} from "../../state/drive";
import {
  any_normal,
  column,
  cross,
  dot,
  first_eye,
  identity,
  length,
  minus,
  plus,
  seen_from_outside,
  times,
  unit,
  type Rows,
  type Vec3,
} from "../../sphere/vectors";
import type {Converted} from "../../orientation/orientation";
import type {AxisName, LinkName, SphericalBars} from "./replies";

export const link_names = ["ground", "input", "coupler", "output"] as const satisfies readonly LinkName[];
export const axis_names = [
  "input_fixed",
  "input_moving",
  "output_moving",
  "output_fixed",
] as const satisfies readonly AxisName[];
/** Between which axes each link lies. */
export const link_ends: Record<LinkName, readonly [AxisName, AxisName]> = {
  ground: ["input_fixed", "output_fixed"],
  input: ["input_fixed", "input_moving"],
  coupler: ["input_moving", "output_moving"],
  output: ["output_fixed", "output_moving"],
};
/** Where it stands: the axes, and the coupler's turn since position 1. */
export interface Stand extends Record<AxisName, Vec3> {
  turn: Rows;
}

/** An axis can be shown at either end: all are, so that the fixed ones lie on the side that is seen at first. */
function sense_of({input_fixed, output_fixed}: SphericalBars): 1 | -1 {
  return dot(plus(input_fixed, output_fixed), first_eye) < 0 ? -1 : 1;
}
export function first_stand(bars: SphericalBars): Stand {
  const end = (axis: AxisName) => times(sense_of(bars), bars[axis]);
  return {
    input_fixed: end("input_fixed"),
    input_moving: end("input_moving"),
    output_moving: end("output_moving"),
    output_fixed: end("output_fixed"),
    turn: identity,
  };
}
/** From what the drive's table has after its states: moving axes, then a quaternion. */
function stand_of(bars: SphericalBars, numbers: readonly number[]): Stand {
  const [ax, ay, az, bx, by, bz, w, x, y, z] = numbers as [
    ...[number, number, number, number, number],
    ...[number, number, number, number, number],
  ];
  return {
    ...first_stand(bars),
    input_moving: times(sense_of(bars), unit([ax, ay, az])),
    output_moving: times(sense_of(bars), unit([bx, by, bz])),
    turn: rows_of_quaternion([w, x, y, z]),
  };
}
export function stand_at(bars: SphericalBars, drive: Drive, angle_deg: number): Stand {
  return stand_of(bars, joints_at(drive, angle_deg).flat());
}
export function stand_of_hinges(bars: SphericalBars, hinges: readonly (readonly number[])[]): Stand {
  return stand_of(bars, hinges.flat());
}
/** All states between two rows, every so many. */
export function stands({spherical, drive}: Linkage, [first, last]: readonly [number, number], every = 1): Stand[] {
  if (!spherical || !drive) return [];
  const rows: number[] = [];
  for (let row = first; row < last; row += every) rows.push(row);
  return [...rows, last].map((row) => stand_of(spherical, row_joints(drive, row).flat()));
}
export function all_rows(drive: Drive): readonly [number, number] {
  return [0, row_count(drive) - 1];
}

/** Of any length: between the rows of a table it is interpolated. */
export function rows_of_quaternion(q: readonly [number, number, number, number]): Rows {
  const size = Math.hypot(q[0], q[1], q[2], q[3]) || 1,
    [w, x, y, z] = q.map((value) => value / size) as [number, number, number, number];
  return [
    [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
    [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
    [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
  ];
}
/** One turn after another. */
export function after(second: Rows, first: Rows): Rows {
  const columns = [0, 1, 2].map((k) => seen_from_outside(second, column(first, k)));
  return [0, 1, 2].map((i) => columns.map((of) => of[i]!)) as unknown as Rows;
}
export function frame_of({matrix}: Pick<Converted, "matrix">): Rows {
  return matrix;
}

/** The frame of a great-circle arc: x to its beginning, z at a right angle to its plane; y leads to its end. */
export function arc_frame(from: Vec3, to: Vec3): Rows {
  const normal = cross(from, to),
    z = length(normal) > 1e-9 ? unit(normal) : any_normal(from),
    y = cross(z, from);
  return [0, 1, 2].map((i) => [from[i]!, y[i]!, z[i]!]) as unknown as Rows;
}
export function angle_between(a: Vec3, b: Vec3): number {
  return Math.atan2(length(cross(a, b)), dot(a, b));
}
export function link_angle(link: LinkName, stand: Stand): number {
  const [from, to] = link_ends[link];
  return angle_between(stand[from], stand[to]);
}
export function link_frame(link: LinkName, stand: Stand): Rows {
  const [from, to] = link_ends[link];
  return arc_frame(stand[from], stand[to]);
}
/** Points of a line on the ball, neighbours in the same sense: of each of two opposite points the one nearer to the last. */
export function aligned(points: readonly Vec3[]): Vec3[] {
  const line: Vec3[] = [];
  for (const point of points) {
    const last = line.at(-1);
    line.push(last && length(minus(last, point)) > length(minus(last, times(-1, point))) ? times(-1, point) : point);
  }
  return line;
}
