// What a linkage is asked to do, as the problem file has it: a form to each kind of task (tasks/ has what they bring).
import type {Box, Chain, Point} from "../engine/protocol";
import {least_of, most_of} from "./ends";

export interface Pose {
  x: number;
  y: number;
  theta_deg: number;
  derivatives?: {x: number; y: number; theta: number}[];
}
/** What three positions give beside the poses; lengths in the user's unit, instant centre in the fixed frame. */
export type Given =
  | {side_lengths: readonly [input: number, output: number]}
  | {side_length: number} // the input's; the output's is left open
  | {side_angle_deg: number; directed?: boolean; input_length?: number}
  | {instant_center: Point; at_infinity?: boolean};
export interface MotionTask {
  kind: "motion";
  mechanism: "four_bar";
  poses: readonly Pose[];
  given?: Given;
  freed_pose?: number; // from 1: of five positions, the one that need not be passed exactly
}

export interface AnglePair {
  input_deg: number;
  output_deg: number;
  derivatives?: {input: number; output: number}[];
}
export type Range = readonly [low: number, high: number];
/** What the pairs are taken from: an expression in x, or a table. */
export interface NamedFunction {
  expression?: string;
  table?: readonly Point[];
  interpolation?: "monotone_cubic" | "linear";
  x?: Range;
  y?: Range;
  input_range_deg: Range;
  output_range_deg: Range;
  points?: number;
  spacing?: "chebyshev" | "even" | readonly number[];
}
/** A number that is left open for a map of two parameters; pairs count from 1. */
export interface FreeNumber {
  number: "output_scale" | "pair_output";
  pair?: number;
  range?: Range;
}
export interface FunctionTask {
  kind: "function";
  mechanism: "four_bar";
  pairs?: readonly AnglePair[]; // these or the function
  function?: NamedFunction;
  ground_pivots?: {input: Point; output: Point};
  free?: FreeNumber;
}

export interface SixBarTask {
  kind: "motion";
  mechanism: "six_bar";
  poses: readonly Pose[];
  chain?: Chain; // without one it is searched for, in options.box
  added: readonly [string, string]; // bodies joined: "0-2", "0-3"
}

export type Task = MotionTask | FunctionTask | SixBarTask;

/** The body's prescribed poses; none where angles are prescribed. */
export function poses_of(task: Task): readonly Pose[] {
  return "poses" in task ? task.poses : [];
}
/** Those that are passed exactly: moving pivots lie as in the first of them. */
export function served_poses(task: Task): readonly Pose[] {
  const poses = poses_of(task),
    freed = "freed_pose" in task ? task.freed_pose : undefined;
  return freed === undefined ? poses : poses.filter((_, i) => i + 1 !== freed);
}
/** From 1: the position in which moving pivots are told, the first that is passed exactly. */
export function told_position(task: Task): number {
  return "freed_pose" in task && task.freed_pose === 1 ? 2 : 1;
}
/** Positions of poses, those infinitely close together counted each. */
export function position_count(poses: readonly {derivatives?: readonly unknown[]}[]): number {
  return poses.reduce((sum, pose) => sum + 1 + (pose.derivatives?.length ?? 0), 0);
}
/** "PP-P-P": positions, those infinitely close together written without a stroke. */
export function pattern_of(poses: readonly {derivatives?: readonly unknown[]}[]): string {
  return poses.map((pose) => "P".repeat(1 + (pose.derivatives?.length ?? 0))).join("-");
}

/** What is given beside the poses belongs to three positions, a freed pose to five. */
export function with_task_poses(task: Task, poses: readonly Pose[]): Task {
  if (!("poses" in task)) return task;
  const changed = {...task, poses};
  if (changed.mechanism === "four_bar") {
    const count = position_count(poses);
    if (count !== 3) delete changed.given;
    if (count !== 5 || poses[(changed.freed_pose ?? 1) - 1]?.derivatives?.length) delete changed.freed_pose;
  }
  return changed;
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
