// What the engine says of linkages with a point that runs straight (engine/adapter.ts).
import type {LinkageType, Point} from "../../contract/messages";
import type {Interval} from "../../state/task";
import type {StraightLineTask} from "./task";

declare module "../../contract/messages" {
  interface Properties {
    stroke_over_longest: number;
    usable_stroke: number;
    usable_strip: number;
    deviation: number; // over the stroke asked for, or what is usable
    velocity_nonuniformity: number;
    contact_coefficient: number;
  }
  interface Ranked {
    straight_line?: OwnMap; // of a search
  }
  interface Linkage {
    straight_line?: StraightLine | null; // of such tasks only; null: there is none
  }
}

/** Where a linkage of a search is found: the task of its case, and how far its axes run where that is not as usual. */
export interface OwnMap {
  task: StraightLineTask;
  window: [Interval, Interval] | null;
}
export type PathEnd = "deviation" | "turn" | "travel" | "unfinished";
/** Along the line, s = 0 where the linkage lies. */
export interface Usable {
  length: number;
  from_s: number;
  to_s: number;
  ends: [PathEnd, PathEnd];
}
export interface Stroke {
  s_from: number;
  s_to: number;
  max_deviation: number;
  parallel_line_deviation: number;
  best_line_deviation: number;
  min_transmission_angle_deg: number;
  /** Null: the input turns back on the way. */
  velocity_nonuniformity: number | null;
  crank_range_deg: number | null;
}
/** As it lies with its point on the line. */
export interface Cognate {
  pivots: Record<"input_fixed" | "input_moving" | "output_moving" | "output_fixed" | "point", Point>;
  lengths: Record<"ground" | "input" | "coupler" | "output" | "point_to_input" | "point_to_output", number>;
  type: LinkageType;
  min_transmission_angle_deg: number;
  over_usable: Stroke;
}
export interface StraightLine {
  case: string;
  layer: number;
  layer_name: string;
  /** On the map, as people read it. */
  place: [number, number];
  /** The coupler's point as the linkage lies. */
  point: Point;
  point_to_input: number;
  point_to_output: number;
  longest: number; // links and arms of the point
  contact_points: number;
  deviation_series: Record<string, number>; // e by the powers of s
  /** Half the width of the strip, and where its middle lies beside the line. */
  deviation: number;
  strip_middle: number;
  usable: Usable;
  usable_strip: Usable;
  stroke_over_longest: number;
  over_usable: Stroke;
  stroke: Stroke | null;
  /** The two other linkages whose point traces the same path; none where it is a circle. */
  cognates: Cognate[];
  /** Of the path beside the line: way along it, deviation, ds/dφ (null: unbounded), driver angle. */
  profile: (readonly [s: number, e: number, velocity: number | null, input_deg: number])[];
}
