// As the problem file has it.
import type {Point} from "../../contract/messages";
import type {Task} from "../../state/task";

export const case_names = [
  "four_point_pivots",
  "four_point_cubic",
  "ball_point_on_side_link",
  "isosceles_trapezoid",
  "pole_at_fixed_pivot",
  "pole_at_fixed_pivot_ball_point_on_frame",
  "five_point",
  "five_point_inflection_pole",
  "five_point_side_link_on_frame",
  "six_point",
  "parallel_side_links",
  "mixed",
  "symmetric_lambda",
  "search",
] as const;
export type CaseName = (typeof case_names)[number];

export interface Line {
  point: Point;
  direction_deg: number;
}
/** Of the path with the line, a way s from its point. */
export interface Contact {
  s: number;
  multiplicity: number;
  side?: number;
}
/** Numbers that are given beside the line; which, the case says (cases.ts). */
export interface GivenNumbers {
  pole_distance?: number;
  point_ray_deg?: number;
  /** Null: infinite. */
  cubic_n?: number | null;
  half_frame?: number;
  output_arm?: number;
  input_offset?: number;
  output_offset?: number;
  coupler_angle_deg?: number;
  stroke?: number;
  /** Half the width of the strip that is wanted of a search. */
  deviation?: number;
  /** Null: left open. */
  crank_range_deg?: number | null;
}
export interface GivenPivots {
  ground_pivots?: {input: Point; output: Point};
  input_pivot?: Point;
}
/** A point of the coupler is to run along a line. */
export interface StraightLineTask extends Task, GivenNumbers, GivenPivots {
  kind: "straight_line";
  mechanism: "four_bar";
  case: CaseName;
  line: Line;
  contacts?: readonly Contact[];
}

export function is_straight_line(task: Task): task is StraightLineTask {
  return task.kind === "straight_line";
}
