// As the problem file has it.
import type {Point, Side} from "../../contract/messages";
import type {Task} from "../../state/task";

/** By any parameter that rises along the task; `input`, radians of the crank: left out, the parameter is the crank's turn.
 *  Where no angles are given, a direction of travel. */
export interface PathRate {
  x: number;
  y: number;
  input?: number;
}
/** A place of the coupler's point, and the crank's angle there from any datum: at every point or at none. */
export interface PathPoint {
  x: number;
  y: number;
  input_deg?: number;
  derivatives?: readonly PathRate[];
}
/** Of one of the links, or of both. */
export type GroundPivots = Partial<Record<Side, Point>>;
export interface PathTask extends Task {
  kind: "path";
  mechanism: "four_bar";
  /** In the order in which they are passed. */
  points: readonly PathPoint[];
  /** In place of angles of the crank. */
  given?: {ground_pivots: GroundPivots};
}

export function is_path(task: Task): task is PathTask {
  return task.kind === "path" && task.mechanism === "four_bar";
}
export const place_of = ({x, y}: PathPoint): Point => [x, y];

/** What is given beside the points. */
export const path_forms = ["angles", "pivot", "pivots"] as const;
export type PathForm = (typeof path_forms)[number];
/** So many positions go with it. */
export const counts: Record<PathForm, readonly [fewest: number, most: number]> = {
  angles: [4, 5],
  pivot: [5, 5],
  pivots: [3, 3],
};

export function pivots_of({given}: PathTask): GroundPivots {
  return given?.ground_pivots ?? {};
}
/** The links whose ground pivots are given. */
export function given_sides(task: PathTask): Side[] {
  const pivots = pivots_of(task);
  return (["input", "output"] as const).filter((side) => pivots[side]);
}
export function form_of(task: PathTask): PathForm {
  return path_forms[given_sides(task).length]!;
}
