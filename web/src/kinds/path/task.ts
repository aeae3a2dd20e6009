// As the problem file has it.
import type {Point} from "../../contract/messages";
import type {Task} from "../../state/task";

/** By any parameter that rises along the task; `input`, radians of the crank: left out, the parameter is the crank's turn. */
export interface PathRate {
  x: number;
  y: number;
  input?: number;
}
/** A place of the coupler's point, and the crank's angle there from any datum. */
export interface PathPoint {
  x: number;
  y: number;
  input_deg: number;
  derivatives?: readonly PathRate[];
}
export interface PathTask extends Task {
  kind: "path";
  mechanism: "four_bar";
  /** In the order in which they are passed. */
  points: readonly PathPoint[];
}

export function is_path(task: Task): task is PathTask {
  return task.kind === "path" && task.mechanism === "four_bar";
}
export const place_of = ({x, y}: PathPoint): Point => [x, y];
