// What a linkage is asked to do, as the problem file has it, as far as it is the same for all kinds of tasks.
import type {Box, Point} from "../contract/messages";
import {least_of, most_of} from "./ends";

export interface Pose {
  x: number;
  y: number;
  theta_deg: number;
  derivatives?: {x: number; y: number; theta: number}[];
  /** Passed as near as a linkage can, in its turn, instead of exactly: of a four-bar's motion. */
  near?: boolean;
  tolerance?: {position?: number; angle_deg?: number};
  weight?: number;
}
export type Interval = readonly [low: number, high: number];
/** What every task has; the rest is its kind's own (kinds/<kind>/task.ts), which reads and writes it. */
export interface Task {
  readonly kind: string;
  readonly mechanism: string;
  /** Of a guided body: they are drawn and dragged and have a table, whatever the kind. */
  readonly poses?: readonly Pose[];
  /** From 1: the one of them that need not be passed exactly. */
  readonly freed_pose?: number;
}

/** The body's prescribed poses; none where angles are prescribed. */
export function poses_of(task: Task): readonly Pose[] {
  return task.poses ?? [];
}
/** Those that are passed exactly: moving pivots lie as in the first of them. */
export function served_poses(task: Task): readonly Pose[] {
  const poses = poses_of(task),
    freed = task.freed_pose;
  return freed === undefined ? poses : poses.filter((_, i) => i + 1 !== freed);
}
/** From 1: the position in which moving pivots are told, the first that is passed exactly. */
export function told_position(task: Task): number {
  return task.freed_pose === 1 ? 2 : 1;
}
/** Positions of poses, those infinitely close together counted each. */
export function position_count(poses: readonly {derivatives?: readonly unknown[]}[]): number {
  return poses.reduce((sum, pose) => sum + 1 + (pose.derivatives?.length ?? 0), 0);
}
const most_written = 8;
/** "PP-P-P": positions, those infinitely close together written without a stroke; "P-P-…-P" of more than any task takes. */
export function pattern_of(poses: readonly {derivatives?: readonly unknown[]}[]): string {
  const written = poses.map((pose) => "P".repeat(1 + (pose.derivatives?.length ?? 0)));
  return (written.length > most_written ? [...written.slice(0, 2), "…", written.at(-1)] : written).join("-");
}

/** Equal in value, in whatever order the keys come. */
export function same_value(a: unknown, b: unknown): boolean {
  if (a === b) return true;
  if (typeof a !== "object" || typeof b !== "object" || a === null || b === null) return false;
  if (Array.isArray(a) && Array.isArray(b))
    return a.length === b.length && a.every((item, i) => same_value(item, b[i]));
  const keys = new Set([...Object.keys(a), ...Object.keys(b)]);
  return (
    Array.isArray(a) === Array.isArray(b) && [...keys].every((key) => same_value(a[key as never], b[key as never]))
  );
}
export function same_task(a: Task, b: Task): boolean {
  return same_value(a, b);
}

/** The box around points. */
export function box_of(points: readonly Point[]): Box {
  const xs = points.map((p) => p[0]),
    ys = points.map((p) => p[1]);
  return {x: [least_of(xs), most_of(xs)], y: [least_of(ys), most_of(ys)]};
}
export function diagonal_of(points: readonly Point[]): number {
  if (points.length === 0) return 0;
  const {x, y} = box_of(points);
  return Math.hypot(x[1] - x[0], y[1] - y[0]);
}
