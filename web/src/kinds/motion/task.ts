// As the problem file has it.
import type {Point, Side} from "../../contract/messages";
import {with_options, type Problem} from "../../state/problem";
import {position_count, type Pose, type Task} from "../../state/task";

export type PivotKind = "ground" | "moving";
export interface Line {
  point: Point;
  direction_deg: number;
}
/** One pivot of each link, or of one of them. */
export type SinglePivots = Partial<Record<`${Side}_${PivotKind}_pivot`, Point>>;
/** On which both links have their ground pivots, their moving ones, or both. */
export type PivotLines = Partial<Record<`${PivotKind}_pivot_on`, Line>>;

/** What three positions give beside the poses; lengths in the user's unit, instant centre and pivots in the fixed frame,
 *  moving ones as they lie in position 1. */
export type Given =
  | {side_lengths: readonly [input: number, output: number]}
  | {side_length: number} // the input's; the output's is left open
  | {side_angle_deg: number; directed?: boolean; input_length?: number}
  | {instant_center: Point; at_infinity?: boolean}
  | {ground_pivots: Record<Side, Point>}
  | {moving_pivots: Record<Side, Point>}
  | SinglePivots
  | PivotLines;
/** Of four positions: a line on which a link has a pivot. */
export interface PivotOnLine {
  which: Side;
  pivot: PivotKind;
  line: Line;
}
export interface MotionTask extends Task {
  kind: "motion";
  mechanism: "four_bar";
  poses: readonly Pose[];
  given?: Given;
  pivot_on?: readonly PivotOnLine[];
  freed_pose?: number; // from 1: of five positions, the one that need not be passed exactly
  turning_length?: number; // of near poses: by it a turn weighs as a length
}

export function has_near({poses}: MotionTask): boolean {
  return poses.some(({near}) => near);
}
export function exact_poses({poses}: Pick<MotionTask, "poses">): readonly Pose[] {
  return poses.filter(({near}) => !near);
}
/** Too few are exact for a map of all linkages that pass them: as the engine's MotionTask::is_fitted(). */
export function is_fitted(task: MotionTask): boolean {
  return has_near(task) && position_count(exact_poses(task)) < (task.given ? 3 : 4);
}

/** How linkages are fitted is said only where they are. */
export function fitting_options(problem: Problem): Problem {
  const {task, options} = problem;
  return options?.fit && is_motion(task) && !is_fitted(task) ? with_options(problem, {fit: undefined}) : problem;
}

export function is_motion(task: Task): task is MotionTask {
  return task.kind === "motion" && task.mechanism === "four_bar";
}
