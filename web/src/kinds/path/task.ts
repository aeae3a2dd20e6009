// As the problem file has it.
import type {Point, Side} from "../../contract/messages";
import {position_count, type Task} from "../../state/task";

/** By any parameter that rises along the task. `input`, radians of the crank: left out, the parameter is the crank's turn.
 *  `theta`, of the coupler: where its angle is given. Where no angle is, a direction of travel. */
export interface PathRate {
  x: number;
  y: number;
  input?: number;
  theta?: number;
}
/** A place of the coupler's point, and the angle there of the crank or of the coupler, from any datum. */
export interface PathPoint {
  x: number;
  y: number;
  input_deg?: number;
  theta_deg?: number;
  derivatives?: readonly PathRate[];
  /** Of paths that pass near: how far off in place of the task's, and how much its squared distance counts. */
  tolerance?: number;
  weight?: number;
}
/** Of one of the links, or of both. */
export type GroundPivots = Partial<Record<Side, Point>>;
export interface PathTask extends Task {
  kind: "path";
  mechanism: "four_bar";
  /** In the order in which they are passed. */
  points: readonly PathPoint[];
  given?: {ground_pivots: GroundPivots};
  /** The path passes near the points, and goes on from the last to the first. */
  closed?: boolean;
  /** The path passes near the points: how far off those may be that have none of their own. */
  tolerance?: number;
  /** The path passes near the points: between them it is free, or keeps to the polygon through them. */
  between?: "free" | "polyline";
  /** The path passes near the points: what the map runs over, the curves unless it is told. */
  map?: "curves" | "pivots";
}

export function is_path(task: Task): task is PathTask {
  return task.kind === "path" && task.mechanism === "four_bar";
}
export const place_of = ({x, y}: PathPoint): Point => [x, y];

// ---- angles -----------------------------------------------------------------------------------------------------------

/** Whose angles they are, by what the file calls them: of the crank, or of the coupler. */
export type AngleKey = "input_deg" | "theta_deg";
export const angle_signs = {input_deg: "φ", theta_deg: "θ"} as const;

export function angle_of({input_deg, theta_deg}: PathPoint): number | null {
  return input_deg ?? theta_deg ?? null;
}
/** Whose angle a point has; null: none. */
export function own_key({input_deg, theta_deg}: PathPoint): AngleKey | null {
  if (theta_deg !== undefined) return "theta_deg";
  return input_deg === undefined ? null : "input_deg";
}
/** Whose angles the task has; null: none. */
export function angle_key({points}: Pick<PathTask, "points">): AngleKey | null {
  if (points.some(({theta_deg}) => theta_deg !== undefined)) return "theta_deg";
  return points.some(({input_deg}) => input_deg !== undefined) ? "input_deg" : null;
}
/** Positions with an angle, and without, derivatives counted. */
export function angle_counts({points}: Pick<PathTask, "points">): {angled: number; plain: number} {
  const counts = {angled: 0, plain: 0};
  for (const point of points)
    counts[angle_of(point) === null ? "plain" : "angled"] += 1 + (point.derivatives?.length ?? 0);
  return counts;
}

// ---- forms ------------------------------------------------------------------------------------------------------------

/** What is given beside the points: angles at all or some of them, or ground pivots; or the path is to be near them only. */
export const path_forms = ["angles", "some", "pivot", "pivots", "near"] as const;
export type PathForm = (typeof path_forms)[number];

export function pivots_of({given}: PathTask): GroundPivots {
  return given?.ground_pivots ?? {};
}
/** The links whose ground pivots are given. */
export function given_sides(task: PathTask): Side[] {
  const pivots = pivots_of(task);
  return (["input", "output"] as const).filter((side) => pivots[side]);
}
/** As the engine tells it: one of these is given, or more points than a four-bar passes and nothing else. */
export function is_near(task: PathTask): boolean {
  if (asks_for_near(task)) return true;
  return given_sides(task).length === 0 && angle_key(task) === null && position_count(task.points) > most_exact;
}
/** It is near however many points there are. */
export function asks_for_near({closed, tolerance, between, map, points}: PathTask): boolean {
  return (
    closed === true ||
    tolerance !== undefined ||
    between !== undefined ||
    map !== undefined ||
    points.some((point) => point.tolerance !== undefined || point.weight !== undefined)
  );
}
const most_exact = 5;
/** A task without points is to have angles at all that will come. */
export function form_of(task: PathTask): PathForm {
  if (is_near(task)) return "near";
  const pivots = given_sides(task).length;
  if (pivots) return pivots === 1 ? "pivot" : "pivots";
  return task.points.every(({input_deg}) => input_deg !== undefined) ? "angles" : "some";
}
