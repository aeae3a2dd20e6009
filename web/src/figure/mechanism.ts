// How linkages are put together: what a kind of task tells of its linkages so that they can be placed and drawn.
import type {Drive, Linkage, Pivot, Point, Side} from "../contract/messages";
import {joints_at, row_count, row_joints, row_pose, row_state, state_at, type State} from "../state/drive";
import {least_of, most_of} from "../state/ends";
import {placed, type Pin} from "../state/problem";
import type {Body, End, Ends, Figure, Place, Role, Trace} from "./figure";

/** A linkage in one state of its motion. */
export interface Configuration {
  /** Of the guided body's frame. */
  pose: Place;
  /** By how much the coupler has turned since position 1. */
  turned_deg: number;
  ends: Ends;
  /** All pivots that are not at infinity. */
  joints: readonly Point[];
}
/** A frame on the body that carries something along, in position 1 and now. */
export interface Carrier {
  first: Place;
  now: Place;
}
/** A length or a place that one needs to build a linkage. */
export interface Dimension {
  name: string;
  value: number | Pivot | null; // null: at infinity
  /** In degrees. */
  is_angle?: true;
  role?: "input" | "output" | "body";
}
/** A moving link of a linkage as it is made: which of the joints it has, by their places in ToleranceAnswer.drawn. */
export interface SampledLink {
  role: Role;
  joints: readonly number[];
}
/** What the engine's bodies and pins (the hinges' names) are called. */
export interface PlateWords {
  body(name: string): string;
  pin(name: string): string;
}

export interface Mechanism {
  /** Where the drive has got to; `hinges`: what the drive's table has after its states. */
  driven(linkage: Linkage, state: State, hinges: readonly Point[]): Configuration;
  /** Without a drive: at the position nearest to the stage (of `poses`, which it passes exactly). */
  still(linkage: Linkage, poses: readonly Place[], stage: number): Configuration;
  /** `outline`: of the guided body, in its coordinates; none where nothing is guided. */
  figure(linkage: Linkage, now: Configuration, outline?: readonly Point[]): Figure;
  /** Its moving links in each of the positions. */
  visits(linkage: Linkage, poses: readonly Place[]): Body[][];
  /** Where a moving pivot of a grounded link gets to in the positions, as far as the task alone tells. */
  pivot_visits(circle: Point, poses: readonly Place[]): Point[];
  /** What carries the end of a grounded link along: its curve lies there, drawn as in position 1. Null: it is at rest. */
  carrier(linkage: Linkage, side: Side, end: End, now: Configuration, first: Place | undefined): Carrier | null;
  /** All pivots in position 1. */
  pivots(linkage: Linkage): Point[];
  /** As the list of the best tells a linkage: by its pivots. Nothing where they are those of something else. */
  sketch(pivots: readonly Pivot[]): Figure;
  /** A joint by the three numbers that the curves have of it, where these are not homogeneous coordinates of a point. */
  end_of?(...numbers: readonly [number, number, number]): Pivot;
  /** What a pin shows without asking the engine. */
  ghost(pivots: Pin["pivots"], poses: readonly Place[], stage: number): Figure;
  dimensions(linkage: Linkage): Dimension[];
  /** Of a linkage that is no four-bar; its joints are then those of its configurations. */
  sampled_links?(linkage: Linkage): readonly SampledLink[];
  /** One loop of four links with all pivots in the plane moves the body: what one instant of it tells can be shown. */
  has_instant?: true;
  /** What the body guides is its origin: its path is shown though there is no outline. */
  guides_a_point?: true;
  plate_words: PlateWords;
}

/** A joint of the plane; nothing where it is one of something else. */
export function in_plane(pivot: Pivot | null | undefined): Point | null {
  return pivot?.length === 2 ? pivot : null;
}
export function at_angle(mechanism: Mechanism, linkage: Linkage, drive: Drive, angle_deg: number): Configuration {
  return mechanism.driven(linkage, state_at(drive, angle_deg), joints_at(drive, angle_deg));
}
export function at_row(mechanism: Mechanism, linkage: Linkage, drive: Drive, row: number): Configuration {
  return mechanism.driven(linkage, row_state(drive, row), row_joints(drive, row));
}
/** Rows of the drive's table at which it is in a position of the task. */
export function reached_rows({drive}: Linkage): number[] {
  return (drive?.ticks ?? []).flatMap(({reached, state}) => (reached ? [state] : []));
}
/** Rows from the first position to the last; null where a defect keeps them apart. */
export function task_rows({task}: Drive): readonly [first: number, last: number] | null {
  return task[0] < 0 || task[1] < 0 ? null : [least_of(task), most_of(task)];
}

/** The way of a point of the guided body. */
export function path_of(
  drive: Drive,
  point: Point,
  [first, last]: readonly [number, number] = [0, row_count(drive) - 1],
): Point[] {
  return Array.from({length: last - first + 1}, (_, i) => placed(point, row_pose(drive, first + i)));
}
/** The ways of the guided body's origin, if there is a body, and of chosen points of it. */
export function traces_of({drive}: Pick<Linkage, "drive">, has_body: boolean, chosen: readonly Point[]): Trace[] {
  if (!drive) return [];
  const origin: Point = [0, 0],
    rows = task_rows(drive),
    trace = (name: string, role: Trace["role"], points: Point[]): Trace => ({name, role, points});
  return [
    ...(has_body ? [trace("whole_path", "whole_path", path_of(drive, origin))] : []),
    ...(has_body && rows ? [trace("path", "path", path_of(drive, origin, rows))] : []),
    ...chosen.map((point, i) => trace(`traced_${i + 1}`, "traced", path_of(drive, point))),
  ];
}
