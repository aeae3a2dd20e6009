// What the engine says to the page: generated from its fields (docs/architecture.md), not written.
import type {Chain, Requirements} from "./problem";
import type {Dyad, FourBar, InsideWindows, JointRelaxation, LoadReport, Relaxation, SixBar, SphericalDyad, SphericalFourBar, StraightLineFourBar, Tolerance} from "./result";

export interface ToldAsText {
  notice: Notice;
  mistake: Mistake;
  task: TaskReply;
  census: Census;
  linkage: LinkageReply;
  best: BestReply;
  improve: ImprovedReply;
  verify: VerifiedReply;
  tolerance: ToleranceReply;
  loads: LoadsReply;
  stud_map: StudMapReply;
  yields: YieldsReply;
  front: FrontReply;
  fits: FitSearchReply;
  machine: MachinePlan;
  outlines: Outlines;
}
/** A sentence to be worded by the page: texts hold `<code>` with {placeholders} for `values`. `message` is the same sentence in English as the command line prints it, for codes that the texts do not know. */
export interface Notice {
  code: string;
  /** The numbers and words of the sentence. */
  values: Readonly<Record<string, number | string>>;
  message: string;
}
/** The caller's mistake, as the command line says it: worded like a notice, and where it is. */
export interface Mistake {
  code: string;
  place: string;
  /** The numbers and words of the sentence. */
  values: Readonly<Record<string, number | string>>;
  message: string;
}
export interface Asymptotes {
  center: readonly [readonly [number, number], readonly [number, number]] | null;
  circle: readonly [readonly [number, number], readonly [number, number]] | null;
}
/** The Burmester curves; where there are none, what the dyads of the input lie along. */
export interface CurveKinds {
  /** Of the circle points, or an axis quantity. */
  kind: string;
  center_kind: string | null;
  kappa: number | null;
  /** Of the two curves as (point, direction), where they have one. */
  asymptotes: Asymptotes | null;
}
export const axis_quantities = ["curve_coordinate","burmester_point","side_direction","side_length","output_scale","pair_output","nothing","link_direction","link_ray","point_ray","pole_height","pivot_height","frame_height","pivot_distance","output_arm","link_length","crank_length","point_arm","crank_range","center_x","center_y","circle_x","circle_y","center_on_line","circle_on_line","arm_reach","arm_difference","layer","fitted_curve","realisation"] as const;
export type AxisQuantity = (typeof axis_quantities)[number];
export interface Branch {
  name: string;
  from: number;
  to: number;
}
/** A stretch of a map axis in display order. `place` runs over [0, 1] along the whole axis; τ within a block is piecewise linear through the knots and unwrapped: it may leave the branch's own interval and is to be taken modulo the branch. */
export interface AxisBlock {
  /** Index into branches. */
  branch: number;
  /** A place. */
  from: number;
  /** Above from. */
  to: number;
  /** Place and τ, at least of the two ends: rising places, τ strictly monotone. */
  knots: readonly (readonly [number, number])[];
}
export interface Axis {
  quantity: AxisQuantity;
  /** Which of the display orders this is: given back in `explore.order`, it is forced (undo restores the map exactly). */
  order: number;
  /** By rising τ. Of a curve: odd, oval, nodal, line, circle, conic, line_at_infinity, point, center_line, fixed_circle. Of other axes: sheet_1, sheet_2, sheet_1_opposite, …, direction_1, …, direct, opposite, range; of straight lines the layers. */
  branches: readonly Branch[];
  /** So many linkages may stand at a place, beside the best of them, which is on the branch: τ of [k, k + 1) names linkage k, k ≥ 1. */
  layers?: number;
  /** What people read along it, (τ, value), at even steps of each branch; null where they read nothing. */
  ticks: readonly (readonly [number, number])[] | null;
  blocks: readonly AxisBlock[];
}
export interface Axes {
  input: Axis;
  output: Axis;
}
export const special_kinds = ["pole","node","center_at_infinity","circle_at_infinity","focus"] as const;
export type SpecialKind = (typeof special_kinds)[number];
/** A mark along the axes and on the curves. */
export interface Special {
  kind: SpecialKind;
  /** Of a pole, from 1. */
  positions?: readonly [number, number];
  /** Places on the map axis; empty for what is only drawn (a pole that is no circle point of its own, a focus). */
  tau: readonly number[];
  /** Where it lies on the drawing, fixed curve. */
  center: readonly [number, number] | null;
  circle: readonly [number, number] | null;
}
/** Input and output angle, degrees on the task's dials. */
export interface WantedFunction {
  pairs: readonly (readonly [number, number])[];
  /** The named function over its range of inputs; empty where only pairs are given. */
  curve: readonly (readonly [number, number])[];
}
export interface TaskReply {
  status: "solved" | "no_solution" | "degenerate";
  /** Null where it is solved. */
  reason: Notice | null;
  /** P-P-P-P */
  pattern: string;
  condition: number | null;
  characteristic_length: number;
  warnings: readonly Notice[];
  curves: CurveKinds;
  /** Both axes carry the same dyads: (u, v) and (v, u) are the same bars, driven from the other side. */
  symmetric: boolean;
  axes: Axes;
  specials: readonly Special[];
  /** Of tasks that generate one. */
  function: WantedFunction | null;
  /** As used, the defaults filled in (null: switched off). */
  requirements: Requirements;
}
export const requirement_keys = ["types","no_defects","min_transmission_angle_deg","max_link_ratio","max_length","min_length","ground_pivots_within","moving_pivots_within","min_link_angle_deg","max_link_angle_deg","fixed_axes_within","moving_axes_within","min_stroke","max_deviation","full_turn","max_path_error","max_near_error","max_tolerance_error","min_yield","max_open_force","max_close_force","min_hold_open","max_pin_force","max_torque","max_cylinder_force","max_self_rise_deg","min_self_close_deg","max_best_F1"] as const;
export type RequirementKey = (typeof requirement_keys)[number];
export interface MissedBox {
  requirement: RequirementKey;
  nearest: readonly [number, number];
  beyond: readonly [number, number];
}
export interface Census {
  /** Cells (pairs without the diagonal) of each linkage type; sliders count as degenerate and in nothing else. */
  types: readonly number[];
  pairs: number;
  order: number;
  branch: number;
  circuit: number;
  defect_free: number;
  meeting: number;
  /** Cells of each linkage type that meet everything. */
  meeting_types: readonly number[];
  /** Cells that fail only this one. */
  only: Readonly<Record<string, number>>;
  /** Cells left after this one and all before it. */
  left: Readonly<Record<string, number>>;
  /** Dearest first; only if none meets everything. */
  relax: readonly Relaxation[];
  /** The fewest requirements that leave something when they are dropped together; where relaxing one alone would, null. */
  relax_together: JointRelaxation | null;
  /** Boxes that the curve does not enter, its nearest point, and the way to it from the border; only if none meets everything. */
  missed_boxes: readonly MissedBox[];
  /** Linkages looked at inside the windows for hinges, between the cells of the map; only if none meets everything. */
  inside: InsideWindows;
}
export const linkage_types = ["crank_rocker","rocker_crank","double_crank","double_rocker","triple_rocker_ground","triple_rocker_input","triple_rocker_coupler","triple_rocker_output","change_point","degenerate","triple_rocker"] as const;
export type LinkageType = (typeof linkage_types)[number];
export interface Defects {
  order: boolean;
  branch: boolean;
  circuit: boolean;
}
export const drive_senses = ["ccw","cw","either"] as const;
export type DriveSense = (typeof drive_senses)[number];
export interface Driver {
  type: LinkageType;
  defects: Defects;
  drive: DriveSense | null;
  /** 0 where all positions are one pose; null with a defect. */
  driver_sweep_deg: number | null;
  /** Over the task; null with a defect. */
  min_transmission_angle_deg: number | null;
  /** Cranks; else null. */
  min_transmission_angle_full_turn_deg: number | null;
}
/** How the bodies and the point of a linkage move while its driver turns as it travels, by 1 rad/s. */
export interface Rates {
  /** Moving ones, as the engine calls them. */
  bodies: readonly string[];
  /** By row of the drive, null at dead points: to each body its angular velocity and acceleration (about a centre: of the coupler their magnitudes), then of the plane the point's velocity and acceleration, x and y. */
  rows: readonly (readonly number[] | null)[];
}
export interface LayerReply {
  tau: readonly [number, number];
  elbows: string;
  type: LinkageType;
  /** All requirements. */
  meets: boolean;
}
export interface Tick {
  position: number;
  /** Its row; -1 where the driver does not get there in this assembly. */
  state: number;
  reached: boolean;
}
export interface TravelLimits {
  low: "dead_point" | null;
  high: "dead_point" | null;
}
export interface Travel {
  /** Numbers to a state: state_columns, and what the kind has after them. */
  width: number;
  /** Driver angles from position 1. */
  dead_points_deg: readonly number[];
  /** One to each position. */
  ticks: readonly Tick[];
  /** First and last state are the same place. */
  full_turn: boolean;
  limits: TravelLimits;
  /** Rows of the first and the last position, -1 where a defect keeps them apart. */
  task: readonly [number, number];
}
export interface LinkageReply {
  tau: readonly [number, number];
  /** Bits of the requirements that it fails. */
  fails: number;
  /** Why there is none, or it does not do the task. */
  reason: Notice | null;
  /** The object of the result file. */
  record: FourBar | SixBar | SphericalFourBar | StraightLineFourBar | null;
  /** The grounded links where there is no linkage, if there are any; about a centre always, as the curves have them. */
  input?: Dyad | SphericalDyad;
  output?: Dyad | SphericalDyad;
  /** Where the driver stands when the freed pose is missed least. */
  miss_input_deg?: number;
  /** Of functions: input and output of the pairs at this place. */
  pairs_deg?: readonly (readonly [number, number])[];
  reaches_pairs?: boolean;
  /** Least of the four arcs and their supplements. */
  min_link_angle_deg?: number;
  /** Of six-bars: joints of bodies 0 (ground), 1 (driver), 2, 3 (guided), 4, 5. */
  bodies?: readonly (readonly number[])[];
  /** Of straight lines. */
  driven?: Driver;
  /** Of straight lines: the same bars driven from the other side. */
  swapped?: Driver;
  /** Where the middle of the strip lies beside the line. */
  strip_middle?: number;
  /** Of the path beside the line: way along it, deviation, ds/dφ (null: unbounded), driver angle. */
  profile?: readonly (readonly [number | null, number | null, number | null, number | null])[];
  /** Of a linkage that is the task. */
  rates?: Rates;
  /** Of paths: all linkages at this place of the map, where there may be several, in layers. */
  layers?: readonly LayerReply[];
  /** Null: a slider or zero link. */
  travel: Travel | null;
}
export interface RankedReply {
  tau: readonly [number, number];
  /** The object of the result file. */
  record: FourBar | SixBar | SphericalFourBar | StraightLineFourBar;
  /** Of what is to come near points or poses: what is least of it. */
  near_error?: number;
  /** Of its point, all round. */
  path?: readonly (readonly [number, number])[];
  min_link_angle_deg?: number;
  /** Of six-bars. */
  chain?: Chain;
  /** Of straight lines; null where the point does not go as far as the stroke. */
  deviation?: number | null;
  /** Of straight lines: how far the axes of its own map run, where that is not as usual. */
  window?: readonly [readonly [number, number], readonly [number, number]] | null;
}
export interface BestReply {
  linkages: readonly RankedReply[];
  /** Why the list is empty, and what was not known of the task before. */
  notices: readonly Notice[];
}
export interface ImprovedReply {
  tau: readonly [number, number];
  improved: boolean;
}
export interface VerifiedReply {
  /** Driven through by a method that the finder does not use. */
  verified: boolean;
  /** User's unit. */
  residual: number;
}
/** Errors of samples, a row of counts to each position over one scale: from 0, of lines from the right to the left. */
export interface Histograms {
  from: number;
  to: number;
  counts: readonly (readonly number[])[];
}
export interface ToleranceReply {
  tolerance: Tolerance;
  histograms: Histograms;
  /** Of the samples drawn: of a straight line its ends and the middle. */
  positions: number;
}
/** A value a station; null: there is none. */
export interface LoadCurve {
  name: string;
  driver_turn_deg: readonly (number | null)[];
  body_turn_deg: readonly (number | null)[];
  /** Share of the handle's way. */
  path: readonly (number | null)[];
  /** Of the task, from 1. */
  position: readonly (number | null)[];
  /** N. */
  open: readonly (number | null)[];
  close: readonly (number | null)[];
  /** N·m, of the driving crank. */
  torque: readonly (number | null)[];
  /** s from position 1, in motion. */
  time: readonly (number | null)[];
  /** N on the ground, in motion. */
  shaking: readonly (number | null)[];
  /** N, the largest of the four while opening. */
  pin: readonly (number | null)[];
}
export interface SpringCurve {
  name: string;
  /** Least and largest length; null: no gas spring. */
  stroke: readonly [number, number] | null;
  length: readonly number[];
}
export interface LoadsReply {
  loads: LoadReport;
  curves: readonly LoadCurve[];
  springs: readonly SpringCurve[];
}
export interface StudMapReply {
  columns: number;
  rows: number;
  /** N by rows from low y to high y; null: nothing can be built there. */
  force: readonly (number | null)[];
}
export interface YieldsReply {
  done: number;
  /** Cells that meet all else. */
  total: number;
}
export interface FrontReply {
  /** Row, column, first and second objective; the best by the first one first. */
  front: readonly (readonly [number, number, number, number])[];
}
export interface StartLink {
  center_point: readonly [number, number];
  circle_point: readonly [number, number];
}
export interface StartPose {
  x: number;
  y: number;
  theta_deg: number;
}
export interface FitStart {
  input: StartLink;
  output: StartLink;
  /** Of a path: that of the coupler. */
  point?: readonly [number, number];
  /** Past poses: of the body that it carries; without it that is in the first of them. */
  pose?: StartPose;
}
/** What a longer search shows beside the usual one. */
export interface FitSearchReply {
  /** Error of the best by the usual search; null: it found none. */
  usual_rms: number | null;
  /** The same by this one. */
  rms: number | null;
  starts: number;
  /** To how many different linkages they led. */
  minima: number;
  /** The best first: `options.fit.starts` of a problem. */
  linkages: readonly FitStart[];
}
/** User's unit. About a centre plates are pieces of spherical shells. */
export interface PlateSizes {
  width: number;
  thickness: number;
  /** Between layers, and between what moves past each other in one. */
  gap: number;
  /** Diameter. */
  pin: number;
  /** By how much a hole is wider than its pin. */
  clearance: number;
  /** Of the outermost sphere; 0: planar. */
  radius: number;
}
export interface PlateLayer {
  body: string;
  layer: number;
}
/** What runs into what, and at which driver angles. */
export interface PlateCrossing {
  body: string;
  /** What it runs into: the pin of a hinge, or another body's plate. */
  pin?: string;
  other?: string;
  from_deg: number;
  to_deg: number;
}
export interface MachinePart {
  name: string;
  /** That it moves with. */
  body: string;
  /** How many of its surface, in the list of all. */
  triangles: number;
}
/** A linkage as plates on pins. Bodies and hinges are called as in the files. */
export interface MachinePlan {
  sizes: PlateSizes;
  /** By body, from the ground, which lies in layer 0 (about a centre the innermost). */
  layers: readonly PlateLayer[];
  /** Free of collisions over the whole travel, or at least from the first position to the last. */
  over: "travel" | "task";
  crossings: readonly PlateCrossing[];
  /** The body that the task guides. */
  guided: string;
  /** The driver angle at which the parts lie as they are told. */
  at_deg: number;
  /** Plates by body, then pins by hinge. */
  parts: readonly MachinePart[];
}
/** A shape of a drawing as the outline of a body. */
export interface OutlineShape {
  /** Corners in the moving frame, brought to the task's size. */
  outline: readonly (readonly [number, number])[];
  /** Else a straight edge closes it. */
  closed: boolean;
  /** The edge of the sheet, or the border on it. */
  frame: boolean;
  /** As drawn, in the task's unit of length where both are known. */
  width: number;
  height: number;
}
/** The shapes of a drawing, closed ones first, frames last, the largest first. */
export interface Outlines {
  shapes: readonly OutlineShape[];
}
/** Of a state of a drive, whatever the kind of linkage: the driver's angle from position 1, in the sense of travel positive; the moving pivots of input and output; the pose of the moving frame; the angles of coupler and output from position 1; dψ/dφ, output by input, 0 at a dead point; output torque over input torque, |dφ/dψ|, 0 where unbounded. */
export const state_columns = ["input_deg", "ax", "ay", "bx", "by", "x", "y", "theta_deg", "transmission_angle_deg", "coupler_deg", "output_deg", "velocity_ratio", "mechanical_advantage"] as const;
export const state_width = state_columns.length;
export const defect_bits = { order: 1, branch: 2, circuit: 4 } as const;
/** What can be required, by kind and mechanism of the task: in this order are the bits of what a linkage or a cell fails (a degenerate cell has all set). */
export const requirement_keys_of = {
"motion four_bar": ["types", "no_defects", "min_transmission_angle_deg", "max_link_ratio", "max_length", "min_length", "ground_pivots_within", "moving_pivots_within", "max_tolerance_error", "min_yield", "max_open_force", "max_close_force", "min_hold_open", "max_pin_force", "max_torque", "max_cylinder_force", "max_self_rise_deg", "min_self_close_deg", "max_best_F1", "max_near_error"],
"function four_bar": ["types", "no_defects", "min_transmission_angle_deg", "max_link_ratio", "max_length", "min_length", "ground_pivots_within", "moving_pivots_within", "max_tolerance_error", "min_yield"],
"motion six_bar": ["types", "no_defects", "min_transmission_angle_deg", "max_link_ratio", "max_length", "min_length", "ground_pivots_within", "moving_pivots_within", "max_tolerance_error", "min_yield"],
"motion spherical_four_bar": ["types", "no_defects", "min_transmission_angle_deg", "min_link_angle_deg", "max_link_angle_deg", "fixed_axes_within", "moving_axes_within", "max_tolerance_error", "min_yield"],
"function spherical_four_bar": ["types", "no_defects", "min_transmission_angle_deg", "min_link_angle_deg", "max_link_angle_deg", "fixed_axes_within", "moving_axes_within", "max_tolerance_error", "min_yield"],
"straight_line four_bar": ["types", "min_transmission_angle_deg", "max_link_ratio", "max_length", "ground_pivots_within", "moving_pivots_within", "min_stroke", "max_deviation", "max_tolerance_error", "min_yield"],
"path four_bar": ["types", "no_defects", "min_transmission_angle_deg", "max_link_ratio", "max_length", "min_length", "ground_pivots_within", "moving_pivots_within", "full_turn", "max_tolerance_error", "min_yield", "max_open_force", "max_close_force", "min_hold_open", "max_pin_force", "max_torque", "max_cylinder_force", "max_self_rise_deg", "min_self_close_deg", "max_best_F1", "max_path_error"],
} as const satisfies Record<string, readonly RequirementKey[]>;
