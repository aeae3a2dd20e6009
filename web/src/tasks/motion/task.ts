// As the problem file has it.
import type {Point} from "../../engine/protocol";
import type {Pose, Task} from "../../state/task";

/** What three positions give beside the poses; lengths in the user's unit, instant centre in the fixed frame. */
export type Given =
  | {side_lengths: readonly [input: number, output: number]}
  | {side_length: number} // the input's; the output's is left open
  | {side_angle_deg: number; directed?: boolean; input_length?: number}
  | {instant_center: Point; at_infinity?: boolean};
export interface MotionTask extends Task {
  kind: "motion";
  mechanism: "four_bar";
  poses: readonly Pose[];
  given?: Given;
  freed_pose?: number; // from 1: of five positions, the one that need not be passed exactly
}

export function is_motion(task: Task): task is MotionTask {
  return task.kind === "motion" && task.mechanism === "four_bar";
}
