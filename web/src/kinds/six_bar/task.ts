// As the problem file has it.
import type {Point} from "../../contract/messages";
import type {Pose, Task} from "../../state/task";

/** Hinges of the chain that guides a six-bar's body, in position 1, fixed frame. */
export interface Chain {
  a: Point;
  b: Point;
  d: Point;
  /** By position: +1 where b lies to the left of the line from a to d, −1 to its right. */
  elbow?: readonly number[];
}
export interface SixBarTask extends Task {
  kind: "motion";
  mechanism: "six_bar";
  poses: readonly Pose[];
  chain?: Chain; // without one it is searched for, in options.box
  added: readonly [string, string]; // bodies joined: "0-2", "0-3"
}

export function is_six_bar(task: Task): task is SixBarTask {
  return task.kind === "motion" && task.mechanism === "six_bar";
}
