// What result files hold: generated from the fields of the engine (docs/architecture.md), not written.
import type {Box, Chain, Orientation, Pose, Problem, StraightLineTask} from "./problem";

export interface ResultFile {
  /** Version of the file format. */
  linkwright: 1;
  /** Echo of the problem with the defaults that were used. */
  problem: Problem;
  status: "solved" | "no_solution" | "degenerate";
  reason: string;
  /** Of straight lines empty. */
  pattern: string;
  /** Of the pose conditions; null where it is infinite. */
  condition: number | null;
  characteristic_length: number;
  /** What to know before trusting or using the answer, in words with the way out. Among the codes: ill_conditioned; parallel_poses; near_common_pole (a hinge does the task but for a miss that is told); side_links_left_out (rounding keeps them from holding their lengths); linkages_left_out (driving did not confirm them); stretch_between_samples (the map does not show it, arc_length does). */
  warnings: readonly Notice[];
  /** Of the grounded links; of function tasks, of the couplers in position 1: circle points on the input link, centre points on the output link; of paths, of the cranks as dyads of a body that turns with them and whose origin is at the points. Null where the grounded links form no curve: three positions with lengths or an angle, five positions. */
  curve: Curve | AxisCurve | null;
  /** Five positions: all real ones; of paths the cranks, as in "curve"; three orientations with given axes: the two; otherwise none. */
  dyads: readonly BurmesterPoint[] | readonly SphericalDyadPoint[];
  /** Paths: at which points the angle of the crank is given. */
  timing?: string;
  /** Paths of five positions: all cranks that there are. */
  cranks?: readonly Crank[];
  /** Null where six-bars are searched for without a chain, and of straight lines where no number is left open. */
  region: Region | null;
  pareto?: Pareto;
  search?: Search;
  /** Best first; with "at" in the options what is at that place of the region and nothing else. */
  linkages: readonly FourBar[] | readonly SixBar[] | readonly SphericalFourBar[] | readonly StraightLineFourBar[];
  /** Five positions: every two dyads as a four-bar with the better driver, whatever its defects; five precision points, or a path that leaves but a few: every linkage; otherwise none. Best first. */
  pairs: readonly FourBar[] | readonly SphericalFourBar[];
  /** Five positions that no linkage passes as required: what freeing one of them comes to, nearest first. */
  freed: readonly WayOut[] | readonly SphericalWayOut[];
  /** Requirements whose relaxation alone would leave linkages, dearest first; values as in the problem file. */
  relax: readonly Relaxation[];
  /** Where relaxing one requirement alone would leave nothing: the fewest that leave linkages when they are dropped together. */
  relax_together?: JointRelaxation;
}
export interface Notice {
  code: string;
  message: string;
}
export const cubic_kinds = ["one_branch","two_branches","nodal","line_and_circle","line_and_point","line_at_infinity_and_conic","line_at_infinity_and_lines","line","every_point"] as const;
export type CubicKind = (typeof cubic_kinds)[number];
export interface Branch {
  name: string;
  from: number;
  to: number;
}
export interface CurveSamples {
  coordinate: readonly number[];
  center_homogeneous: readonly (readonly [number, number, number])[];
  circle_homogeneous: readonly (readonly [number, number, number])[];
}
export interface Curve {
  /** Of the circle-point curve. */
  kind: CubicKind;
  /** Of the centre-point curve. */
  center_kind: CubicKind;
  kappa: number | null;
  branches: readonly Branch[];
  samples: CurveSamples;
}
export interface AxisCurveSamples {
  coordinate: readonly number[];
  moving_axis: readonly (readonly [number, number, number])[];
  fixed_axis: readonly (readonly [number, number, number])[];
}
/** Of spherical tasks: the cone of moving axes and, axis by axis, the cone of fixed axes. */
export interface AxisCurve {
  kind: "one_component" | "two_components" | "nodal" | "great_circle_and_cone" | "great_circles" | "every_axis";
  branches: readonly Branch[];
  samples: AxisCurveSamples;
}
/** Fixed frame, circle points in position 1, or in position 2 where "freed_pose" is 1; null: at infinity. */
export interface BurmesterPoint {
  center_point: readonly [number, number] | null;
  circle_point: readonly [number, number] | null;
  coordinate: number;
  center_homogeneous: readonly [number, number, number];
  circle_homogeneous: readonly [number, number, number];
  residual: number;
  /** 2 and more: so many solutions have run together. */
  multiplicity: number;
  /** By how much a relative change of the conditions moves the points. */
  condition: number;
}
/** A grounded link of a spherical linkage, its moving axis in position 1. */
export interface SphericalDyadPoint {
  moving_axis: readonly [number, number, number];
  fixed_axis: readonly [number, number, number];
  angle_deg: number;
  coordinate: number | null;
  residual: number;
  /** 2 and more: so many solutions have run together. */
  multiplicity: number;
  /** By how much a relative change of the conditions moves the axes. */
  condition: number;
}
/** Fixed frame, position 1; null: at infinity. */
export interface Crank {
  center_point: readonly [number, number] | null;
  moving_pivot: readonly [number, number] | null;
  crank_length: number | null;
  /** From its moving pivot to the point. */
  point_arm: number | null;
}
export interface MapAxis {
  name: string;
  quantity: string;
  /** Of the values; tau where the coordinate itself is read. */
  unit: string;
  branches: readonly Branch[];
  /** What is read at the samples: directions, lengths, factors, angles; null where a window reaches beyond the axis. */
  values?: readonly (number | null)[];
}
export interface RegionCounts {
  crank_rocker: number;
  rocker_crank: number;
  double_crank: number;
  double_rocker: number;
  triple_rocker_ground?: number;
  triple_rocker_input?: number;
  triple_rocker_coupler?: number;
  triple_rocker_output?: number;
  change_point: number;
  degenerate: number;
  triple_rocker?: number;
  order: number;
  branch: number;
  circuit: number;
  defect_free: number;
  pairs: number;
}
export interface InsideWindows {
  /** Linkages with all hinges inside. */
  looked_at: number;
  meeting_requirements: number;
  /** No linkage has all its hinges inside: the stretches of the curves inside the windows were computed, and on one axis there is none. */
  proved_empty: boolean;
}
export interface Region {
  /** Rows; of each layer. */
  samples: number;
  /** How many linkages a place may have; 1 where left out. Arrays are then [layer][input][output]. */
  layers?: number;
  input_coordinate: readonly number[];
  output_coordinate: readonly number[];
  /** Of the rows and of the columns. */
  axes: readonly [MapAxis, MapAxis];
  /** Of the types that linkages of the task can be. Ordered pairs without the diagonal; sliders count as degenerate and in nothing else. */
  counts: RegionCounts;
  meeting_requirements: number;
  /** Where windows are required of hinges: what was looked at inside them, more closely than the map's cells show it. */
  inside_windows?: InsideWindows;
  /** u8 by type, row-major [input][output]. */
  type?: string;
  /** u8: 1 order, 2 branch, 4 circuit. */
  defects?: string;
  /** Of straight lines, u8: 0 none, 1 a four-bar, 2 a slider. */
  valid?: string;
  /** Little-endian f32; 0 where not defined. */
  properties?: Readonly<Record<string, string>>;
}
export interface FrontPlace {
  layer?: number;
  at: readonly [number, number];
  values: readonly [number, number];
}
/** Of the map's linkages those that no other beats in both objectives, the best by the first one first. */
export interface Pareto {
  objectives: readonly [string, string];
  front: readonly FrontPlace[];
}
/** Six-bars without a given chain: how the search went. */
export interface Search {
  /** The same seed finds the same six-bars. */
  seed: number;
  /** Chains that were to be tried. */
  effort: number;
  /** All pivots in the box; most do not reach all poses. */
  chains_drawn: number;
  /** That reach all poses. */
  chains_tried: number;
  /** Of those chains, all pivots in the box. */
  six_bars: number;
  /** Of those, that could be better than the chain's best so far. */
  driven: number;
  /** Of the ones driven. */
  defect_free: number;
  /** Stopped early: the linkages are the best so far, not refined. */
  interrupted: boolean;
}
/** Fixed frame, circle points in position 1, or in position 2 where "freed_pose" is 1; null: at infinity. */
export interface Dyad {
  center_point: readonly [number, number] | null;
  circle_point: readonly [number, number] | null;
  coordinate: number;
  center_homogeneous: readonly [number, number, number];
  circle_homogeneous: readonly [number, number, number];
  residual: number;
}
export interface FourBarLengths {
  ground: number;
  input: number;
  coupler: number;
  output: number;
  /** Paths: from the point to the input's moving pivot. */
  point_to_input?: number;
  /** Paths: from the point to the output's moving pivot. */
  point_to_output?: number;
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
export interface ErrorCurve {
  input_deg: readonly number[];
  wanted_output_deg: readonly number[];
  /** Generated less wanted output; null where the drive does not get there. */
  error_deg: readonly (number | null)[];
}
/** How far from the freed position; combined: root of distance² + (characteristic length of all positions × angle)². */
export interface Miss {
  /** Of the moving frame's origin. */
  distance: number;
  angle_deg: number;
  combined: number;
}
export interface CognateLink {
  center_point: readonly [number, number] | null;
  circle_point: readonly [number, number] | null;
}
/** The other four-bar with the same path and timing; fixed frame, position 1. null: at infinity. */
export interface TimedCognate {
  input: CognateLink;
  output: CognateLink;
  /** Its crank over this one. */
  size_ratio: number;
}
/** Of the points from the path, user's unit. */
export interface PathError {
  /** Weighted. */
  sum_of_squares: number;
  /** Root of the weighted mean of the squares. */
  rms: number;
  max: number;
  /** At which point, from 1. */
  max_at: number;
  rms_over_diagonal: number;
  /** Largest distance of the path between the points from the polygon through them. */
  excursion: number;
  /** Length of the path over that of the polygon. */
  path_length_ratio: number;
}
export interface NearestToPoint {
  /** From 1. */
  point: number;
  /** Turn of the input from position 1. */
  input_deg: number;
  /** Of the path, fixed frame. */
  place: readonly [number, number] | null;
  distance: number;
}
export interface Realisation {
  input: CognateLink;
  output: CognateLink;
}
export interface PathFit {
  /** Distances are those at the angles of the crank that are given. */
  timed: boolean;
  error: PathError;
  /** At all points that have one. */
  within_tolerance: boolean;
  /** Points that are farther off than their tolerance, from 1. */
  outside: readonly number[];
  /** Its longest link is as long as is allowed: longer ones may come nearer. */
  at_length_limit: boolean;
  /** Where the linkage is nearest to each point, or its crank at the angle given there. */
  at: readonly NearestToPoint[];
  /** The four-bars that trace the same path (Roberts' theorem), this one first; at angles of the crank those whose cranks turn alike. Fixed frame, position 1, the point the same in each. */
  realisations: readonly Realisation[];
}
/** Of the body from the near poses, user's unit; of a pose √(distance² + (turning length × angle)²). */
export interface PoseFitError {
  /** Weighted. */
  sum_of_squares: number;
  /** Root of the weighted mean of the squares. */
  rms: number;
  position_rms: number;
  position_max: number;
  angle_rms_deg: number;
  angle_max_deg: number;
  /** At which pose, from 1. */
  max_at: number;
  /** Largest error at the exact poses. */
  exact_residual: number;
}
export interface NearestToPose {
  /** From 1. */
  pose: number;
  near: boolean;
  /** Turn of the input from position 1. */
  input_deg: number;
  /** Of the moving frame's origin, fixed frame. */
  place: readonly [number, number] | null;
  theta_deg: number;
  distance: number;
  angle_deg: number;
}
export interface NearPoses {
  error: PoseFitError;
  /** At all near poses that have one. */
  within_tolerance: boolean;
  /** Poses at which it is farther off than their tolerance, from 1. */
  outside: readonly number[];
  /** Driving meets all poses in their order, and no dead point on the way. */
  in_order: boolean;
  /** Its longest link is as long as is allowed: longer ones may come nearer. */
  at_length_limit: boolean;
  /** Where the linkage is nearest to each pose, in their order. */
  at: readonly NearestToPose[];
}
export const requirement_keys = ["types","no_defects","min_transmission_angle_deg","max_link_ratio","max_length","min_length","ground_pivots_within","moving_pivots_within","min_link_angle_deg","max_link_angle_deg","fixed_axes_within","moving_axes_within","min_stroke","max_deviation","full_turn","max_path_error","max_near_error","max_tolerance_error","min_yield","max_open_force","max_close_force","min_hold_open","max_pin_force","max_torque","max_cylinder_force","max_self_rise_deg","min_self_close_deg","max_best_F1"] as const;
export type RequirementKey = (typeof requirement_keys)[number];
export interface Sensitivity {
  parameter: string;
  tolerance?: number;
  tolerance_deg?: number;
  share: number;
  per_position: readonly number[];
}
export interface AllocatedTolerance {
  parameter: string;
  tolerance?: number;
  tolerance_deg?: number;
}
/** What tolerances do to the linkage. */
export interface Tolerance {
  /** Of the errors. */
  unit: "length" | "degrees";
  /** To first order: root mean square over the positions; of a straight line the largest 3σ over the stroke. */
  error: number;
  error_sampled: number;
  /** Straight lines: the line laid anew in each linkage made. */
  error_realigned?: number;
  error_realigned_sampled?: number;
  /** The sampled error is the one that counts. */
  beyond_first_order: boolean;
  worst_case: number;
  /** Of the largest error over the positions, sampled. */
  mean_plus_3_sigma: number;
  mean_plus_3_sigma_realigned?: number;
  signal_to_noise_db: number | null;
  /** Share of the samples that assemble and keep the limit in all positions; null without a limit. */
  yield: number | null;
  /** In which the true yield lies with 95 %. */
  yield_interval: readonly [number, number] | null;
  /** Share of the samples. */
  not_assembled: number;
  samples: number;
  seed: number;
  /** Largest share of the variance first. */
  sensitivities: readonly Sensitivity[];
  /** The tolerances of least cost that keep the error; null where no cost is given, and of straight lines. */
  allocation: readonly AllocatedTolerance[] | null;
}
/** A place of the travel, seen from position 1. */
export interface LoadPlace {
  driver_turn_deg: number;
  body_turn_deg: number;
  /** Share of the handle's way; null without a handle. */
  path: number | null;
}
export interface Equilibrium {
  at: LoadPlace;
  stable: boolean;
  /** Of the driver, N·m per radian. */
  stiffness: number;
}
export interface RestBand {
  from: LoadPlace;
  to: LoadPlace;
}
export interface ForcePeak {
  max: number;
  at: LoadPlace;
}
export interface PinPeaks {
  input_ground: ForcePeak | null;
  input_coupler: ForcePeak | null;
  output_coupler: ForcePeak | null;
  output_ground: ForcePeak | null;
}
export interface SpringUse {
  name: string;
  length: readonly [number, number];
  /** Of gas springs: beyond the largest compression used. */
  stroke_left: number | null;
  /** Where it is first too short or too long; null: nowhere. */
  bottoms_at: LoadPlace | null;
  /** Least change of length by the handle's way. */
  least_lever: number | null;
}
export interface LoadCaseReport {
  name: string;
  /** N, over the travel; negative: no hand is needed. Null without a handle. */
  max_open_force: number | null;
  max_close_force: number | null;
  hold_open: number | null;
  close_start: number | null;
  hump: number | null;
  pop_up: number | null;
  /** From here on it opens by itself; null: it does not. */
  self_rise: LoadPlace | null;
  /** From here down it closes by itself; null: it does not. */
  self_close: LoadPlace | null;
  equilibria: readonly Equilibrium[];
  /** Where friction holds it. */
  rests: readonly RestBand[];
  pins: PinPeaks;
  /** Largest force of the moving links on the ground, in motion. */
  shaking?: ForcePeak;
  /** Of the driving crank, N·m; null: another drive. */
  max_torque: number | null;
  cylinder_force: number | null;
  springs: readonly SpringUse[];
  /** No effort moves it somewhere: friction holds it, or hand or drive act across its way. */
  locks: boolean;
}
export interface WorstOfCases {
  value: number;
  case: string;
}
export interface WorstReadOuts {
  max_open_force?: WorstOfCases;
  max_close_force?: WorstOfCases;
  hand_force?: WorstOfCases;
  hold_open?: WorstOfCases;
  close_start?: WorstOfCases;
  hump?: WorstOfCases;
  pop_up?: WorstOfCases;
  self_rise?: WorstOfCases;
  self_close?: WorstOfCases;
  max_pin_force?: WorstOfCases;
  max_torque?: WorstOfCases;
  cylinder_force?: WorstOfCases;
}
/** The forces in the linkage from position 1 to the last one. */
export interface LoadReport {
  cases: readonly LoadCaseReport[];
  /** Of the cases that count; self_rise and self_close as absolute turns of the body from position 1, degrees. */
  worst: WorstReadOuts;
  /** Of the spring that leaves it free, N: all the rest is told of it. */
  best_F1?: number;
  /** No strength does what is asked of it: there is no worst, and the cases are those of the forces that are given. */
  why_no_F1?: Notice;
}
export interface Swapped {
  type: LinkageType;
  defects: Defects;
  /** Over the task; null with a defect. */
  min_transmission_angle_deg: number | null;
}
export interface FourBar {
  mechanism: "four_bar";
  input: Dyad;
  output: Dyad;
  lengths: FourBarLengths;
  link_ratio: number;
  type: LinkageType;
  defects: Defects;
  drive: DriveSense | null;
  /** 0 where all positions are one pose; null with a defect. */
  driver_sweep_deg: number | null;
  /** Over the task; null with a defect. */
  min_transmission_angle_deg: number | null;
  /** Cranks; else null. */
  min_transmission_angle_full_turn_deg: number | null;
  /** Worst relative change of a grounded link's length over the poses. */
  residual: number;
  /** Tasks with derivatives: largest |Zᵀ M C| of their conditions as orthonormal rows, unit Z and C in the working frame; of a function, of the coupler as the output link sees it. */
  residual_derivatives?: number;
  /** Functions: largest error of the output at the pairs that are reached. */
  precision_error_deg?: number;
  /** Functions: generated less wanted output at each pair; null where the drive does not get there. */
  errors_at_pairs_deg?: readonly (number | null)[];
  /** Named functions: largest magnitude over the range of inputs that is reached; null where only pairs are given or nothing is reached. */
  max_structural_error_deg?: number | null;
  /** Where that is. */
  worst_input_deg?: number;
  /** Named functions: parts [from, to] of the range of inputs where the drive does not get. */
  unreached_deg?: readonly (readonly [number, number])[];
  /** Named functions: columns by rising input. */
  error_curve?: ErrorCurve;
  /** Tasks with a freed position. */
  miss?: Miss;
  /** Paths: the point of the coupler in position 1. */
  point?: readonly [number, number];
  /** Paths: turns of the crank from position 1. */
  input_deg_at_points?: readonly number[];
  /** Paths: turns of the coupler from position 1, in (-180, 180]. */
  theta_deg_at_points?: readonly number[];
  /** Paths at given angles of the crank. */
  cognate?: TimedCognate;
  /** Paths that pass near points: how near, in their turn. */
  fit?: PathFit;
  /** Paths with points at which no angle is given: on which side of the line from the arm's ground pivot to each of them its elbow stands, + left or - right, and which of the further dyads. */
  elbows?: string;
  /** Paths: the crank turns fully, so that the path is closed. */
  full_turn?: boolean;
  /** Paths: along the circuit of the linkage, either way round, the points come as they are listed; null where they lie on different circuits. */
  circuit_order?: boolean | null;
  /** Paths, free of defects: by driving, the largest distance of the point from where it is to be with the crank turned by input_deg_at_points. */
  position_error?: number;
  /** Paths, free of defects: by driving, the largest turn of the crank from there to where the point is nearest. */
  timing_error_deg?: number;
  /** Motions past near poses: how near, in their turn. */
  near?: NearPoses;
  local_optimum: boolean;
  /** Driven through the task it has the defects told; of functions, free of defects, it also stood right at each pair, of paths the point at each point. */
  verified_by_driving: boolean;
  /** Of a linkage at a picked place (options.at). */
  meets_requirements?: boolean;
  /** The requirements that a linkage at a picked place does not meet; only where there are some. */
  fails?: readonly RequirementKey[];
  /** Only with tolerances; null at a dead point. */
  tolerance?: Tolerance | null;
  /** Only with loads; null where the linkage does not get through its positions in order without a dead point. */
  loads?: LoadReport | null;
  /** With a defect: which positions it parts, in words. */
  reason?: string;
  /** Functions with a free number: the value that this linkage has. */
  free_value?: number;
  /** Of the coupler, as in problem files, where they are not the task's: of functions (origin in the input's moving pivot, angle 0 at the first pair), of paths (origin in the point, angle 0 in position 1), of five positions with one freed, and of motions past near poses: exact ones, or where the body is nearest to some. */
  poses?: readonly Pose[];
  /** The same bars driven from the other grounded link. */
  swapped: Swapped;
}
export interface AddedLink {
  between: string;
  points: readonly [readonly [number, number], readonly [number, number]];
  coordinate?: number;
}
export interface Joints {
  a: readonly [number, number];
  b: readonly [number, number];
  d: readonly [number, number];
  c4: readonly [number, number];
  z4: readonly [number, number];
  c5: readonly [number, number];
  z5: readonly [number, number];
}
/** As it lies in position 1, driven by body 1 at hinge a. Bodies: 0 ground, 1 driver, 2 link between, 3 guided body, 4 and 5 the added links. */
export interface SixBar {
  mechanism: "six_bar";
  topology: "watt_1" | "stephenson_1" | "stephenson_2" | "stephenson_3" | null;
  /** Hinges between 0 and 1, 1 and 2, 2 and 3; sign of cross(d − a, b − a) in each position. */
  chain: Chain;
  /** Links 4 and 5: the bodies that each joins, its hinges on them, its place on its curve. */
  added: readonly [AddedLink, AddedLink];
  /** All hinges by name; c4 and z4 are those of link 4, c5 and z5 those of link 5. */
  joints: Joints;
  /** Distances between hinges of one body, "1:a-b" of body 1. */
  lengths: Readonly<Record<string, number>>;
  /** Longest over shortest of them. */
  link_ratio: number;
  /** Of its loop of four bodies. */
  type: LinkageType;
  defects: Defects;
  drive: DriveSense | null;
  /** 0 where all positions are one pose; null with a defect. */
  driver_sweep_deg: number | null;
  /** Over the task; null with a defect. Of two dyads the smaller; where all bodies move together, asin of √(|det| / Π|columns|) of the loops. */
  min_transmission_angle_deg: number | null;
  /** Of the dyad that follows the driver, and of the one that follows that; null where all bodies move together. */
  min_transmission_angles_of_dyads_deg?: readonly [number, number] | null;
  /** Worst relative change of a length over the poses. */
  residual: number;
  /** Worst miss of a pose, as a share of the longest link, or in radians. */
  pose_residual: number;
  local_optimum: boolean;
  /** Driven another way it has the defects told. */
  verified_by_driving: boolean;
  /** Of a linkage at a picked place (options.at). */
  meets_requirements?: boolean;
  /** The requirements that a linkage at a picked place does not meet; only where there are some. */
  fails?: readonly RequirementKey[];
  /** Only with tolerances; null at a dead point. */
  tolerance?: Tolerance | null;
  /** Only with loads; null where the linkage does not get through its positions in order without a dead point. */
  loads?: LoadReport | null;
}
/** A grounded link of a spherical linkage, its moving axis in position 1. */
export interface SphericalDyad {
  moving_axis: readonly [number, number, number];
  fixed_axis: readonly [number, number, number];
  angle_deg: number;
  coordinate: number | null;
  residual: number;
}
export interface LinkAngles {
  ground: number;
  input: number;
  coupler: number;
  output: number;
}
export interface SphericalFourBar {
  mechanism: "spherical_four_bar";
  input: SphericalDyad;
  output: SphericalDyad;
  /** Between the axes as listed: their senses are chosen so that input and output are at most 90, and the coupler where it can be. */
  angles_deg: LinkAngles;
  type: LinkageType;
  defects: Defects;
  /** About what input and output swing: 0 the arc between the fixed axes (the output: its continuation), pi the opposite. */
  triple_rocker?: "00" | "0pi" | "pi0" | "pipi";
  drive: DriveSense | null;
  /** 0 where all positions are one pose; null with a defect. */
  driver_sweep_deg: number | null;
  /** Over the task; null with a defect. */
  min_transmission_angle_deg: number | null;
  /** Cranks; else null. */
  min_transmission_angle_full_turn_deg: number | null;
  /** Largest change of the cosine between a dyad's axes over the orientations. */
  residual: number;
  /** Tasks with derivatives: largest |Gᵀ D W| of their conditions as unit rows; of a function, of the coupler as the input link sees it. */
  residual_derivatives?: number;
  /** Functions: largest error of the output at the pairs that are reached. */
  precision_error_deg?: number;
  /** Functions: generated less wanted output at each pair; null where the drive does not get there. */
  errors_at_pairs_deg?: readonly (number | null)[];
  /** Named functions: largest magnitude over the range of inputs that is reached; null where only pairs are given or nothing is reached. */
  max_structural_error_deg?: number | null;
  /** Where that is. */
  worst_input_deg?: number;
  /** Named functions: parts [from, to] of the range of inputs where the drive does not get. */
  unreached_deg?: readonly (readonly [number, number])[];
  /** Named functions: columns by rising input. */
  error_curve?: ErrorCurve;
  local_optimum: boolean;
  /** Driven through the task it has the defects told. */
  verified_by_driving: boolean;
  /** Of a linkage at a picked place (options.at). */
  meets_requirements?: boolean;
  /** The requirements that a linkage at a picked place does not meet; only where there are some. */
  fails?: readonly RequirementKey[];
  /** Only with tolerances; null at a dead point. */
  tolerance?: Tolerance | null;
  /** Only with loads; null where the linkage does not get through its positions in order without a dead point. */
  loads?: LoadReport | null;
  /** Functions with a free number: the value that this linkage has. */
  free_value?: number;
  /** Of the coupler, as in problem files, where they are not the task's: of functions, from where it is at the first pair. */
  orientations?: readonly Orientation[];
  /** The same bars driven from the other grounded link. */
  swapped: Swapped;
}
export interface LineShape {
  /** Bits: the other side of the line, the other sense of it, the other side of the dyad. */
  turns: number;
  numbers: readonly number[];
}
export interface TracingPivots {
  input_fixed: readonly [number, number];
  input_moving: readonly [number, number];
  output_moving: readonly [number, number];
  output_fixed: readonly [number, number];
  point: readonly [number, number];
}
export interface TracingLengths {
  ground: number;
  input: number;
  coupler: number;
  output: number;
  point_to_input: number;
  point_to_output: number;
}
/** A circle; the line that it has become where its centre is at infinity. */
export type CircleOrLine = {
  center: readonly [number, number];
  radius: number;
} | {
  line: {
    point: readonly [number, number];
    direction_deg: number;
  };
};
export interface Invariants {
  a3: number;
  b3: number;
  a4: number | null;
  b4: number | null;
}
export interface Hyperbola {
  center: readonly [number, number];
  direction_deg: number;
  product: number;
}
export type Cubic = {
  m: number;
  n: number;
} | {
  hyperbola: Hyperbola;
};
export interface PathNow {
  at: readonly [number, number];
  /** null: the path runs straight, or the point rests. */
  center_of_curvature: readonly [number, number] | null;
  radius_of_curvature: number | null;
  /** That the path has in common with its tangent; 0 for the pole, which rests. */
  contact_points: number;
}
/** One instant of a body, fixed frame, the user's unit; rates by the turn of the input, of a prescribed motion by its parameter. */
export type Instant = {
  /** Why there is no instant. */
  degenerate: string;
} | {
  /** pivoting: about a point that stays to the second order; translating: the pole is at infinity. */
  kind: "turning" | "pivoting" | "translating";
  pole: readonly [number, number] | null;
  /** The pole travels against it as the body turns counter-clockwise; the inflection pole lies to its left. */
  pole_tangent_deg: number | null;
  inflection_diameter: number | null;
  inflection_pole: readonly [number, number] | null;
  /** Null where there is none. */
  inflection_circle: CircleOrLine | null;
  /** Null where there is none. */
  return_circle: CircleOrLine | null;
  /** Null where there is none. */
  bresse_circle: CircleOrLine | null;
  acceleration_pole: readonly [number, number] | null;
  /** null: the input stands still. */
  body_rate: number | null;
  body_acceleration: number | null;
  /** By the body's turn, in the frame of pole and pole tangent; the fourth order is null where it is not known. */
  invariants: Invariants | null;
  /** Of stationary curvature, (x² + y²)(m x + n y) = x y in that frame; of a translating body x y = product, x along direction_deg from center. */
  cubic: Cubic | null;
  ball_point: readonly [number, number] | null;
  /** At most four, a four-bar's moving pivots among them. */
  burmester_points: readonly (readonly [number, number])[];
  /** What holds because the links lie as they do. */
  notes: readonly Notice[];
  point?: PathNow;
};
/** A straight stretch by the way s along the line, 0 where the linkage lies. */
export interface UsableLine {
  length: number;
  from_s: number;
  to_s: number;
  /** Why it ends: farther off the line, or the point turns back. */
  ends: readonly ["deviation" | "turn" | "travel" | "unfinished", "deviation" | "turn" | "travel" | "unfinished"];
}
export interface Stroke {
  s_from: number;
  s_to: number;
  /** Off the line itself. */
  max_deviation: number;
  /** Off the best line parallel to it. */
  parallel_line_deviation: number;
  /** Off the best line of any direction. */
  best_line_deviation: number;
  min_transmission_angle_deg: number;
  /** (max − min) / mean; null where the input turns back. */
  velocity_nonuniformity: number | null;
  crank_range_deg: number | null;
}
export interface StraightLineCognate {
  pivots: TracingPivots;
  lengths: TracingLengths;
  type: LinkageType;
  /** Over the usable length that counts, its own input driving. */
  min_transmission_angle_deg: number;
  over_usable: Stroke;
}
/** A four-bar whose point runs straight, as it lies with its point on the line. */
export interface StraightLineFourBar {
  mechanism: "four_bar";
  case: string;
  layer: number;
  layer_name?: string;
  /** On the map of its case, by the numbers of its axes: the layer and [u, v] find it again (options.at). */
  place: readonly [number, number];
  /** Of a search: the task of whose map it is a place. */
  task?: StraightLineTask;
  /** Of a search: what it is of the shapes of its case that are drawn. */
  shape?: LineShape;
  pivots: TracingPivots;
  lengths: TracingLengths;
  type: LinkageType;
  /** Of contacts at places. */
  defects?: Defects;
  /** Of path and line where the linkage lies, as its path has them. */
  contact_points: number;
  /** Coefficients of e(s) by the power of s, the first that does not vanish and those after it; e to the left of the line. */
  deviation_series: Readonly<Record<string, number>>;
  instant: Instant;
  /** Half the width of the strip by which it is measured. */
  deviation: number;
  usable: UsableLine;
  usable_strip: UsableLine;
  /** Of the usable length that counts, over the longest link or arm. */
  stroke_over_longest: number;
  /** Over the stroke where one is asked for and reached, otherwise over the usable length that counts. */
  min_transmission_angle_deg: number;
  over_usable: Stroke;
  /** Over the stroke that is asked for or that of the case; null where there is none or the path does not reach so far. */
  stroke: Stroke | null;
  /** The others whose point traces the same curve (Roberts); none where it is a circle. */
  cognates: readonly StraightLineCognate[];
  /** Distance of the point from the line. */
  residual: number;
  local_optimum: boolean;
  /** Assembled anew at places of its stroke it is where its path has it; driven, it passes the contacts at places. */
  verified_by_driving: boolean;
  /** Of a linkage at a picked place (options.at). */
  meets_requirements?: boolean;
  /** The requirements that a linkage at a picked place does not meet; only where there are some. */
  fails?: readonly RequirementKey[];
  /** Only with tolerances; null at a dead point. */
  tolerance?: Tolerance | null;
  /** Only with loads; null where the linkage does not get through its positions in order without a dead point. */
  loads?: LoadReport | null;
}
/** Without one position: the nearest that a linkage through the others comes to it, or why there is none. */
export interface WayOut {
  /** Which one, counted from 1. */
  pose: number;
  /** Why there is no linkage; null where there is one. */
  reason: string | null;
  meeting_requirements: number;
  miss: Miss | null;
  /** As it lies in the first of its own poses, those that are left. */
  linkage: FourBar | null;
}
/** Without one orientation: the nearest that a linkage through the others comes to it, or why there is none. */
export interface SphericalWayOut {
  /** Which one, counted from 1. */
  orientation: number;
  /** Why there is no linkage; null where there is one. */
  reason: string | null;
  meeting_requirements: number;
  /** The turn that is missing there. */
  miss_deg: number | null;
  /** As it lies in the first of the orientations that are left. */
  linkage: SphericalFourBar | null;
}
export interface Relaxation {
  requirement: RequirementKey;
  only_this: number;
  /** Of a box, the box made larger; null: drop it. */
  value: number | Box | null;
  leaves: number;
}
export interface JointRelaxation {
  requirements: readonly RequirementKey[];
  leaves: number;
}
