// What problem files hold: generated from the fields of the engine (docs/architecture.md), not written.
export interface Problem {
  /** Version of the file format. */
  linkwright: 1;
  title?: string;
  /** Echoed, never converted. Drawings and models know µm, mm, cm, dm, m, km, mil, in, ft, yd and mi by symbol or name, in any spelling that is usual (inch, inches, ", millimeter, MM); of another the export says that it does not know it. */
  length_unit?: string;
  task: Task;
  requirements?: Requirements;
  tolerances?: Tolerances | null;
  loads?: Loads;
  options?: Options;
  /** The workbench's own; kept. Of it the program reads only the `outline`, which it draws: corners [x, y] of the guided body in the moving frame. */
  view?: object;
}
/** x and y in the user's length, theta in radians, per power of the parameter. */
export interface Derivative {
  x: number;
  y: number;
  theta: number;
}
/** Where two points of the body lie; the moving frame has its origin in the first and its x axis toward the second. Distances that differ from pose to pose are told, and fitted by least squares. */
export interface PoseByPoints {
  points: readonly [readonly [number, number], readonly [number, number]];
  /** First, second, … derivatives by any parameter that increases along the task: the direction of travel through the pose, then its curvature, …. */
  derivatives?: readonly Derivative[];
}
export interface PoseTolerance {
  /** Of the moving frame's origin. */
  position?: number;
  angle_deg?: number;
}
/** Pose of the moving frame in the fixed frame; theta counts modulo 360. Passed exactly, or as near as a linkage can. */
export interface MotionPose {
  x: number;
  y: number;
  theta_deg: number;
  /** First, second, … derivatives by any parameter that increases along the task: the direction of travel through the pose, then its curvature, …. */
  derivatives?: readonly Derivative[];
  /** As near as a linkage can, in its turn, instead of exactly. */
  near?: boolean;
  /** Near poses: how far off the body may be. */
  tolerance?: PoseTolerance;
  /** Near poses: of the squared error; 1 where it is left out. */
  weight?: number;
}
export interface Line {
  point: readonly [number, number];
  direction_deg: number;
}
export interface PivotOnLine {
  which: "input" | "output";
  /** A moving pivot as it lies in position 1. */
  pivot: "ground" | "moving";
  line: Line;
}
/** Lengths of the grounded links, input and output. */
export interface GivenSideLengths {
  side_lengths: readonly [number, number];
}
/** Length of the input link; that of the output link is chosen. */
export interface GivenSideLength {
  side_length: number;
}
/** Angle in position 1 from the input to the output link, each directed from its fixed to its moving pivot; undirected: modulo 180. Without the input's length that is chosen. */
export interface GivenSideAngle {
  side_angle_deg: number;
  directed?: boolean;
  input_length?: number | null;
}
/** Instant centre of the body in position 1; at infinity: the direction in which it lies. */
export interface GivenInstantCenter {
  instant_center: readonly [number, number];
  at_infinity?: boolean;
}
export interface GroundPivots {
  input: readonly [number, number];
  output: readonly [number, number];
}
/** Both ground pivots: one linkage. */
export interface GivenGroundPivots {
  ground_pivots: GroundPivots | readonly [readonly [number, number], readonly [number, number]];
}
/** Both moving pivots as they lie in position 1: one linkage. */
export interface GivenMovingPivots {
  moving_pivots: GroundPivots | readonly [readonly [number, number], readonly [number, number]];
}
/** One pivot of each link: one linkage. One pivot of one link: the solution region is the place of the other link's pivot of the same kind. Moving pivots as they lie in position 1. */
export interface GivenSinglePivots {
  input_ground_pivot?: readonly [number, number];
  input_moving_pivot?: readonly [number, number];
  output_ground_pivot?: readonly [number, number];
  output_moving_pivot?: readonly [number, number];
}
/** A line on which both links have their ground pivots, one on which they have their moving pivots in position 1; with both lines at most two dyads are left. */
export interface GivenPivotLines {
  ground_pivot_on?: Line;
  moving_pivot_on?: Line;
}
export type Given = GivenSideLengths | GivenSideLength | GivenSideAngle | GivenInstantCenter | GivenGroundPivots | GivenMovingPivots | GivenSinglePivots | GivenPivotLines;
/** Motion generation: a body shall pass through three, four or five positions in this order. A pose counts as one position, and as one more for each of its derivatives. Poses that are near come in their order beside them: with four exact positions they are measured over the solution region, with fewer linkages are fitted to all. */
export interface MotionTask {
  kind: "motion";
  mechanism: "four_bar";
  poses: readonly (PoseByPoints | MotionPose)[];
  /** Near poses: an error of angle of 1 radian counts as one of position of this length; left out: the characteristic length of all poses. */
  turning_length?: number;
  /** Five positions: the pose, counted from 1 and without derivatives, that need not be passed exactly; the result says by how much a linkage misses it. */
  freed_pose?: number | null;
  /** Four positions: lines on which the links have a pivot, one at most to each link; it is then one of at most three dyads. */
  pivot_on?: readonly PivotOnLine[] | null;
  /** Three positions: what is known beside them; otherwise left out. */
  given?: Given | null;
}
export interface Rates {
  input: number;
  output: number;
}
/** Angles of input and output link, counter-clockwise, each from a datum of its own. */
export interface Pair {
  input_deg: number;
  output_deg: number;
  /** First, second, … derivatives by any parameter that increases along the task, in radians. */
  derivatives?: readonly Rates[];
}
export interface ByExpression {
  /** A function of x, times a number, plus a number: x^2, 2x, 0.5 sin_deg + 1. log is of base 10; sin, cos, tan take radians, sin_deg, cos_deg, tan_deg degrees. */
  expression: string;
}
export interface ByTable {
  /** Rows [x, y] by rising x. */
  table: readonly (readonly [number, number])[];
}
/** A function y(x) and the dials on which x and y are read, both even; the pairs are its precision points. */
export type Function = {
  /** Between the rows of a table. */
  interpolation?: "monotone_cubic" | "linear";
  /** Range, low first; a table's own where it is missing. */
  x?: readonly [number, number] | null;
  /** What the output's range stands for; least and greatest y where it is missing. */
  y?: readonly [number, number] | null;
  /** Where the ends of x stand on the input's dial, at most a turn apart. */
  input_range_deg: readonly [number, number];
  /** Where the ends of y stand on the output's dial. */
  output_range_deg: readonly [number, number];
  /** Precision points; where they are listed, as many as the list has. */
  points?: number;
  /** Chebyshev's, even steps with both ends, or a list of x. */
  spacing?: readonly number[] | "chebyshev" | "even";
} & (ByExpression | ByTable);
/** A positive factor on the output's travel. */
export interface FreeScale {
  number: "output_scale";
  range?: readonly [number, number] | null;
}
/** The output angle of one pair, degrees; pairs count from 1. */
export interface FreeOutput {
  number: "pair_output";
  pair: number;
  range: readonly [number, number];
}
export type Free = FreeScale | FreeOutput;
/** Function generation: the input link turns the output link through four or five pairs of angles in this order. A pair counts as one position, and as one more for each of its derivatives. */
export type FunctionTask = {
  kind: "function";
  mechanism: "four_bar";
  /** Default: (0, 0) and (1, 0). */
  ground_pivots?: GroundPivots;
  /** Four positions: a number left open, the map's second coordinate. */
  free?: Free | null;
} & ({
  pairs: readonly Pair[];
} | {
  function: Function;
});
/** Pose of the moving frame in the fixed frame; theta counts modulo 360. */
export interface Pose {
  x: number;
  y: number;
  theta_deg: number;
  /** First, second, … derivatives by any parameter that increases along the task: the direction of travel through the pose, then its curvature, …. */
  derivatives?: readonly Derivative[];
}
/** Hinges of the chain 0-1-2-3 in position 1, fixed frame. */
export interface Chain {
  a: readonly [number, number];
  b: readonly [number, number];
  d: readonly [number, number];
  /** By pose, the side of the line from a to d on which b lies: 1 left, -1 right, 0 as in position 1. */
  elbow?: readonly [number, number, number, number];
}
/** Motion generation by a six-bar: a chain of three links that guides the body through four poses, and two links added to it. Without a chain one is searched for in options.box. */
export interface SixBarTask {
  kind: "motion";
  mechanism: "six_bar";
  poses: readonly (PoseByPoints | Pose)[];
  chain?: Chain | null;
  /** Bodies joined by the first and by the second added link: 0 the ground, 1 … 3 the chain, 3 the guided body, 4 the first added link. */
  added: readonly [string, string];
}
/** The rotation that carries the body from its reference attitude into this one, in one of five forms, and optionally its angular velocity and the derivatives of that, in the fixed frame, radians per unit of any parameter that increases along the task. */
export interface Orientation {
  matrix?: readonly [readonly [number, number, number], readonly [number, number, number], readonly [number, number, number]];
  /** Of a matrix: whether the nearest rotation is meant; without it, no. */
  nearest?: boolean;
  /** Of any length, not null. */
  axis?: readonly [number, number, number];
  angle_deg?: number;
  /** [w, x, y, z] of any length, not null. */
  quaternion?: readonly [number, number, number, number];
  /** Along the axis, its length the angle in radians. */
  rotation_vector?: readonly [number, number, number];
  euler_deg?: readonly [number, number, number];
  /** Of the axes, as in "zyx", "ZYX" or "3-2-1"; capitals mean the same. */
  sequence?: string;
  /** About axes carried along, as without it, or about fixed ones. */
  turning?: "intrinsic" | "extrinsic";
  angular_velocity?: readonly [number, number, number];
  angular_acceleration?: readonly [number, number, number];
  angular_jerk?: readonly [number, number, number];
  angular_snap?: readonly [number, number, number];
}
export type GivenAxes = {
  fixed_axes: readonly [readonly [number, number, number], readonly [number, number, number]];
} | {
  moving_axes: readonly [readonly [number, number, number], readonly [number, number, number]];
};
/** Motion generation about a fixed centre by a spherical four-bar: a body shall pass through four or five orientations in this order, or through three with two axes given. An orientation counts as one position, and as one more for each of its derivatives. */
export interface SphericalMotionTask {
  kind: "motion";
  mechanism: "spherical_four_bar";
  orientations: readonly Orientation[];
  /** Three orientations: both fixed axes, or both moving axes in position 1, the input's first. */
  given?: GivenAxes | null;
}
/** Function generation by a spherical four-bar: the input turns about the first fixed axis, (0, 0, 1), the output about the second, (sin, 0, cos) of ground_angle_deg, both right-handed. */
export type SphericalFunctionTask = {
  kind: "function";
  mechanism: "spherical_four_bar";
  /** Between the fixed axes. */
  ground_angle_deg: number;
  /** Four positions: a number left open, the map's second coordinate. */
  free?: Free | null;
} & ({
  pairs: readonly Pair[];
} | {
  function: Function;
});
export interface Contact {
  /** Along the line from its point. */
  s: number;
  /** Points in common with the line: 1 crosses, 2 touches, 3 inflects. */
  multiplicity?: number;
  /** Of the way from the input pivot to the point on which the crank's pin lies there: 1 left, -1 right. */
  side?: number;
}
/** A point of the coupler is to run along a line. What is given beside it is told by the case; what is left open, by the axes of the map. Where no ground pivots are given, the line's point is where the coupler point is. The pole lies pole_distance from it, along the line's right normal; rays lead from the pole, their angles are counted from the pole tangent. */
export type StraightLineTask = {
  kind: "straight_line";
  mechanism: "four_bar";
} & ({
  case: "four_point_pivots";
  line: Line;
  ground_pivots: GroundPivots;
} | {
  case: "four_point_cubic";
  line: Line;
  pole_distance: number;
  point_ray_deg: number;
  cubic_n?: number | null;
} | {
  case: "ball_point_on_side_link";
  line: Line;
  input_pivot: readonly [number, number];
} | {
  case: "isosceles_trapezoid";
  line: Line;
  half_frame: number;
} | {
  case: "pole_at_fixed_pivot";
  line: Line;
  ground_pivots: GroundPivots;
  /** Of the output link, signed along the pole tangent. */
  output_arm: number;
} | {
  case: "pole_at_fixed_pivot";
  line: Line;
  pole_distance: number;
  /** Of the output link, signed along the pole tangent. */
  output_arm: number;
} | {
  case: "pole_at_fixed_pivot_ball_point_on_frame";
  line: Line;
  pole_distance: number;
} | {
  case: "five_point";
  line: Line;
  pole_distance: number;
  point_ray_deg: number;
} | {
  case: "five_point_inflection_pole";
  line: Line;
  pole_distance: number;
} | {
  case: "five_point_side_link_on_frame";
  line: Line;
  pole_distance: number;
} | {
  case: "six_point";
  line: Line;
  pole_distance: number;
} | {
  case: "parallel_side_links";
  line: Line;
  input_offset: number;
  output_offset: number;
} | {
  case: "mixed";
  line: Line;
  input_pivot: readonly [number, number];
  contacts: readonly Contact[];
  /** 0: a lambda linkage. */
  coupler_angle_deg?: number;
} | {
  case: "symmetric_lambda";
  line: Line;
  stroke: number;
  crank_range_deg?: number | null;
} | {
  case: "search";
  line: Line;
  stroke: number;
  deviation: number;
});
/** x and y in the user's length, input and theta in radians, per power of the parameter. */
export interface PathDerivative {
  x: number;
  y: number;
  /** Of the crank's angle, where that is given. Left out: the parameter is the turn of the crank in the sense in which it passes the points. */
  input?: number;
  /** Of the coupler's angle, where that is given. */
  theta?: number;
}
/** A place that the point of the coupler is to pass, fixed frame. */
export interface PathPoint {
  x: number;
  y: number;
  /** Angle of the crank there, counter-clockwise, from any datum. */
  input_deg?: number;
  /** Or of the coupler, likewise. */
  theta_deg?: number;
  /** First, second, … derivatives by any parameter that increases along the task: the direction of travel through the point, then its curvature, …. */
  derivatives?: readonly PathDerivative[];
  /** Paths that pass near: how far from it, instead of the task's. */
  tolerance?: number;
  /** Paths that pass near: of the squared distance; 1 where it is left out. */
  weight?: number;
}
/** Of both links, or of one of them. */
export interface PathGroundPivots {
  input?: readonly [number, number];
  output?: readonly [number, number];
}
export interface PathGiven {
  ground_pivots: PathGroundPivots;
}
/** Path generation: a point of the coupler passes places in this order: four or five at given angles of the crank; three with angles of crank or coupler and two without, or four and one; or from given ground pivots, or from one that is searched for in options.box. A point counts as one position, and as one more for each of its derivatives. Or it passes as near as it can to three to 1000 points: where one of closed, tolerance, weight and timing is given, or more than five points, all at angles of the crank or none, and nothing else. */
export interface PathTask {
  kind: "path";
  mechanism: "four_bar";
  points: readonly PathPoint[];
  /** One ground pivot with five positions or with three at given angles of the crank; both with three or five, or with three at given angles of the crank. */
  given?: PathGiven;
  /** The path passes near its points, from the last one on to the first, by an input that turns fully. */
  closed?: boolean;
  /** The path passes near its points: how far from each without a tolerance of its own. */
  tolerance?: number;
  /** The path passes near its points; between them it is free, or keeps to the polyline. */
  between?: "free" | "polyline";
  /** The path passes near its points: the angles of the crank do not count; or as turns, from any datum and in either sense; or as angles of the input link from the x axis. Left out: relative where all points have one. */
  timing?: "free" | "relative" | "absolute";
  /** The path passes near its points; the map runs over the curves that were found, or over the places of the input's ground pivot, each with the nearest path from there. */
  map?: "curves" | "pivots";
}
/** What the linkage is for. */
export type Task = MotionTask | FunctionTask | SixBarTask | SphericalMotionTask | SphericalFunctionTask | StraightLineTask | PathTask;
export interface Box {
  x: readonly [number, number];
  y: readonly [number, number];
}
/** Lines at most half_angle_deg from an axis, in either sense. */
export interface Cone {
  /** [x, y, z] of any length, not null. */
  axis: readonly [number, number, number];
  half_angle_deg: number;
}
/** They choose and rank linkages; they never change the curve or the region's counts. null switches a limit off. */
export interface Requirements {
  /** Wanted types; none or null: any. Triple rockers are told by their longest link in the plane, on the sphere they are one type. */
  types?: readonly ("crank_rocker" | "rocker_crank" | "double_crank" | "double_rocker" | "triple_rocker_ground" | "triple_rocker_input" | "triple_rocker_coupler" | "triple_rocker_output" | "change_point" | "degenerate" | "triple_rocker")[] | null;
  /** Neither order nor branch nor circuit defect. */
  no_defects?: boolean;
  /** Least transmission angle over the task. */
  min_transmission_angle_deg?: number | null;
  /** Longest over shortest of the four links. */
  max_link_ratio?: number | null;
  /** Longest of the four links; default 10 times the task's characteristic length, which is seen from position 1: give a length where the positions may also be passed the other way round. */
  max_length?: number | null;
  /** Shortest of the four links; default a thousandth of the task's characteristic length, or of max_length where that is shorter. null: any. */
  min_length?: number | null;
  /** Both fixed pivots. */
  ground_pivots_within?: Box | null;
  /** Both moving pivots, in position 1; in position 2 where "freed_pose" is 1. */
  moving_pivots_within?: Box | null;
  /** Spherical linkages: least of the four links' angles, an angle and its supplement being the same link. */
  min_link_angle_deg?: number | null;
  /** Spherical linkages: largest of the four links' angles, as for the least. */
  max_link_angle_deg?: number | null;
  /** Spherical linkages: both fixed axes. */
  fixed_axes_within?: Cone | null;
  /** Spherical linkages: both moving axes, in position 1. */
  moving_axes_within?: Cone | null;
  /** Straight lines: least usable length. */
  min_stroke?: number | null;
  /** Straight lines: largest deviation over the stroke, or over the usable length where no stroke is asked for. */
  max_deviation?: number | null;
  /** Paths: the crank turns fully, so that the path is closed. */
  full_turn?: boolean;
  /** Paths near their points: root mean square of the distances of the points from the path, or the largest of them where that is to be least. */
  max_path_error?: number | null;
  /** Motions past near poses: root mean square of the errors there, user's unit; an error of angle counts by the turning length. */
  max_near_error?: number | null;
  /** Largest error by tolerances, in their unit: the user's length; of functions and spherical linkages degrees. Needs tolerances; off where it is not given. */
  max_tolerance_error?: number | null;
  /** Least share of sampled linkages that assemble and keep the limit in all positions. Needs tolerances with a limit; off where it is not given. */
  min_yield?: number | null;
  /** Loads: largest force of the hand while opening, N; a negative one: it is never needed. */
  max_open_force?: number | null;
  /** Loads: largest force of the hand while closing, N. */
  max_close_force?: number | null;
  /** Loads: least force that holds the last position open, N: with it the body still rises by itself. */
  min_hold_open?: number | null;
  /** Loads: largest force of a pin, N. */
  max_pin_force?: number | null;
  /** Loads, driven by a crank: its largest torque, N·m. */
  max_torque?: number | null;
  /** Loads, driven by a cylinder: its largest force, N. */
  max_cylinder_force?: number | null;
  /** Loads: largest turn of the body from position 1 from which it rises by itself to the end; 0: all the way. */
  max_self_rise_deg?: number | null;
  /** Loads: least turn of the body from position 1 from which it closes by itself all the way. */
  min_self_close_deg?: number | null;
  /** Loads: largest F1 of the spring that leaves it free, N. */
  max_best_F1?: number | null;
  /** Poses with derivatives are passed in the direction of the first one, not against it. */
  respect_direction?: boolean;
}
export interface LengthTolerances {
  input?: number | null;
  coupler?: number | null;
  output?: number | null;
  /** Of each coordinate. */
  ground_pivots?: number | null;
  /** Of the body's origin in the coupler, each coordinate. */
  point?: number | null;
}
export type ToleranceLimit = {
  position: number;
} | {
  angle_deg: number;
} | {
  deviation: number;
};
export interface ToleranceCost {
  exponent: number;
}
/** How exactly linkages are made: half tolerances, all independent, in the user's unit. */
export interface Tolerances {
  /** Of all lengths of a planar linkage, or of each kind: of six-bars those of the driver, of the other links on the ground, of all others. */
  length?: LengthTolerances | number | null | null;
  /** Radius by which a pin can move in its hole. */
  clearance?: number | null;
  /** Of the input's angle. */
  driver_deg?: number | null;
  /** Of each arc of a spherical linkage. */
  link_angle_deg?: number | null;
  /** Normal with half tolerance = 3 standard deviations, the same cut off at the tolerances, or even. */
  distribution?: "normal" | "truncated_normal" | "uniform";
  /** By which an angle is multiplied to be weighed against a distance: 0 leaves angles out; the characteristic length of the task where it is not given. */
  turning_length?: number | null;
  /** The error up to which a linkage is good, at all positions. */
  limit?: ToleranceLimit | null;
  /** A tolerance T costs T^-exponent: asks for the tolerances of least cost. */
  cost?: ToleranceCost | null;
  /** How many linkages are sampled. */
  samples?: number;
  /** Of the samples: the same one gives the same answer. */
  seed?: number;
}
export interface Gravity {
  /** Of a level ground. */
  direction_deg?: number;
  /** m/s². */
  acceleration?: number;
}
export interface BodyMass {
  /** kg. */
  mass: number;
  /** In the moving frame. */
  center?: readonly [number, number];
  /** About the centre, kg·m². */
  inertia?: number;
}
export type LinkMass = {
  /** [along, across] from the fixed pivot; the middle where it is not given. */
  center?: readonly [number, number];
  /** About the centre, kg·m². */
  inertia?: number;
} & ({
  /** A thin rod from pivot to pivot. */
  kg_per_m: number;
} | {
  /** kg. */
  mass: number;
});
export interface LinkMasses {
  input?: LinkMass;
  coupler?: LinkMass;
  output?: LinkMass;
}
export const loaded_bodys = ["ground","input","body","coupler","output"] as const;
export type LoadedBody = (typeof loaded_bodys)[number];
export type ExtraLoad = {
  name: string;
  /** On the body points are told in the moving frame, on the ground in the fixed frame, on a link along and across it from its fixed pivot towards the moving one, the coupler's from its pivot at the input. */
  on: LoadedBody;
  at: readonly [number, number];
  /** In every case; otherwise in those that name it. */
  always?: boolean;
} & ({
  /** kg. */
  mass: number;
} | {
  /** N. */
  force: readonly [number, number];
  /** In which the force keeps its components. */
  frame?: "fixed" | "body";
});
export interface FixedDirection {
  fixed_deg: number;
}
export interface Handle {
  /** In the moving frame. */
  point: readonly [number, number];
  /** Which way the hand pulls: as the point moves, against gravity, or at an angle in the fixed frame. */
  direction?: "tangential" | "vertical" | FixedDirection;
}
export interface CarriedPoint {
  /** On the body points are told in the moving frame, on the ground in the fixed frame, on a link along and across it from its fixed pivot towards the moving one, the coupler's from its pivot at the input. */
  on: LoadedBody;
  at: readonly [number, number];
}
export interface FreeStrength {
  /** N; the weakest spring there is, of 1 N, where it is not given. */
  min_F1?: number;
  /** N: without it the search runs into short strong springs. */
  max_F1: number;
  /** N, of the cases that count for it. */
  min_hold_open?: number;
}
/** As catalogues have it (GB/T 25751). */
export interface GasSpring {
  kind: "gas";
  from: CarriedPoint;
  to: CarriedPoint;
  extended_length: number;
  stroke: number;
  /** How far before both ends the forces are measured; 5 mm where it is not given. */
  measured_at?: number;
  /** Extending, near the extended end, N, at 20 °C. */
  F1: number;
  /** Extending, near the compressed end, N. */
  F2: number;
  /** Compressing, near the extended end, N. */
  F3?: number;
  /** Compressing, near the compressed end, N. */
  F4?: number;
  /** Half of the difference of compressing and extending, N; in place of F3 and F4. Some sheets print the whole difference. */
  friction?: number;
  /** Always in millimetres; 0: not known. */
  rod_diameter?: number;
  /** How the force grows with the temperature, of that at 20 °C; null: as an ideal gas, 3.41. */
  percent_per_10K?: number | null;
  /** Leaves the strength free: each linkage has the one with which the largest force of its hand is least. F1 to F4 then say how much the force grows over the stroke, and what friction takes. One spring at most. */
  best_F1?: FreeStrength;
}
export interface CoilSpring {
  kind: "coil";
  from: CarriedPoint;
  to: CarriedPoint;
  /** N per unit of length. */
  rate: number;
  free_length: number;
  /** Whether it can push and pull. */
  acts?: "both" | "tension" | "compression";
}
export const four_bar_joints = ["input_ground","input_coupler","output_coupler","output_ground"] as const;
export type FourBarJoint = (typeof four_bar_joints)[number];
export interface TorsionSpring {
  kind: "torsion";
  joint: FourBarJoint;
  /** N·m per degree. */
  rate_per_deg: number;
  /** N·m on the link that turns on the ground, or on the coupler, counter-clockwise positive. */
  torque_at_position_1?: number;
}
export type Spring = {
  name?: string;
  /** Side by side. */
  count?: number;
} & (GasSpring | CoilSpring | TorsionSpring);
export interface Pins {
  radius: number;
  /** Coefficient. */
  friction: number;
}
export interface Cylinder {
  from: CarriedPoint;
  to: CarriedPoint;
}
export interface ByCylinder {
  cylinder: Cylinder;
}
export const driver_laws = ["uniform","trapezoid","cycloid","3-4-5"] as const;
export type DriverLaw = (typeof driver_laws)[number];
export type DriverMotion = {
  /** From [0, 0] to [duration, 1]: a smooth motion from rest to rest through these points, a cubic spline. */
  table: readonly (readonly [number, number])[];
} | {
  /** All but uniform from rest to rest. */
  law: DriverLaw;
  /** From position 1 to the last one. */
  duration_s: number;
  /** Of a trapezoid: share of the duration in which it speeds up, and as long in which it slows down. */
  ramp?: number;
};
export const read_outs = ["max_open_force","max_close_force","hand_force","hold_open","close_start","hump","pop_up","self_rise","self_close","max_pin_force","max_torque","cylinder_force"] as const;
export type ReadOut = (typeof read_outs)[number];
export interface LoadCase {
  name: string;
  temperature_C?: number;
  /** Of the ground, rising to the right: gravity turns clockwise by it. */
  slope_deg?: number;
  /** Loads that act in it, by name. */
  extra?: readonly string[];
  /** Of the springs' forces: what is left of them. */
  spring_percent?: number;
  /** 1 where the gas keeps its temperature, up to 1.4 where it moves too fast. */
  gas_exponent?: number;
  /** The read-outs for which it counts; none: all. */
  for?: readonly ReadOut[];
}
/** What acts on the linkage: weights, forces, springs, a hand or a drive. */
export interface Loads {
  gravity?: Gravity | null;
  /** What the body on the coupler weighs. */
  body?: BodyMass;
  /** What the links weigh. */
  links?: LinkMasses;
  /** Snow, a tool, a cutting force. */
  extra?: readonly ExtraLoad[];
  /** Where the hand takes hold. */
  handle?: Handle;
  springs?: readonly Spring[];
  /** All alike, with friction. */
  pins?: Pins;
  /** What moves and holds the linkage. */
  drive?: "hand" | "input" | "output" | ByCylinder;
  /** Of the driver at a steady speed: adds the forces of inertia. */
  rpm?: number | null;
  /** In place of rpm: how the input link goes from position 1 to the last one in time, which adds the forces of inertia. Closing is the same backwards. */
  motion?: DriverMotion;
  cases?: readonly LoadCase[];
  /** Of the travel of each linkage of a map, the positions among them. */
  stations?: number;
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
export interface Fit {
  /** How many places and starts are tried. */
  effort?: "quick" | "standard" | "deep";
  /** What is least: the squares of the distances, or the largest distance. */
  measure?: "least_squares" | "least_largest";
  /** Closed paths: by how much the longest and the shortest link are shorter than the other two together, at least, over the diagonal of the points; null: any linkage. */
  grashof_margin?: number | null;
  /** Linkages to begin with beside those that are found, each as it lies at the first of the points or poses. */
  starts?: readonly FitStart[];
}
export interface Options {
  /** N of the N × N region. */
  region_samples?: number;
  /** Even steps of the curve coordinate, or of the length run by circle and centre point. */
  spacing?: "coordinate" | "arc_length";
  /** What the best linkages have: the largest least transmission angle, the smallest link ratio, the smallest longest link, the smallest structural error of a named function, of spherical linkages the largest least link angle, or with tolerances the smallest error by them or the largest yield. */
  objective?: "min_transmission_angle" | "link_ratio" | "size" | "structural_error" | "link_angle" | "stroke" | "deviation" | "velocity_uniformity" | "tolerance_error" | "yield" | "hand_force" | "hold_open" | "pin_force" | "torque" | "cylinder_force" | "self_rise" | "self_close" | "best_F1" | "path_error" | "near_error";
  /** Two objectives of the map: linkages that no other beats in both are listed, instead of the best by one. */
  pareto?: readonly ["min_transmission_angle" | "link_ratio" | "size" | "structural_error" | "link_angle" | "stroke" | "deviation" | "velocity_uniformity" | "tolerance_error" | "yield" | "hand_force" | "hold_open" | "pin_force" | "torque" | "cylinder_force" | "self_rise" | "self_close" | "best_F1" | "path_error" | "near_error", "min_transmission_angle" | "link_ratio" | "size" | "structural_error" | "link_angle" | "stroke" | "deviation" | "velocity_uniformity" | "tolerance_error" | "yield" | "hand_force" | "hold_open" | "pin_force" | "torque" | "cylinder_force" | "self_rise" | "self_close" | "best_F1" | "path_error" | "near_error"] | null;
  /** How many linkages the result lists. */
  best?: number;
  /** Straight lines: half the width of the strip in which the usable length counts; null: 1/10 000 of the longest link or arm. */
  deviation?: number | null;
  /** Straight lines: the stroke over which deviations, transmission angle and velocity are judged, half of it either way; what does not reach it is not listed. Null: none, or that of the case. */
  stroke?: number | null;
  /** Straight lines: usable by the line itself, or by the best strip beside it. */
  measure?: "tangent" | "strip";
  /** Paths that pass near points, and linkages that pass near poses. */
  fit?: Fit;
  /** Six-bars without a chain: where all pivots lie in position 1. Paths of five points and nothing else given: where the input's ground pivot is searched for. */
  box?: Box | null;
  /** Of the chains, or places, tried. */
  seed?: number;
  /** How many chains, or arms of a path, are tried. */
  effort?: number;
  /** The part of the region to sample: [[low, high], [low, high]] of the curve coordinates of input and output. */
  window?: readonly [readonly [number, number], readonly [number, number]] | null;
  /** A place [u, v] of the region by the coordinates of its axes: the result then lists the linkage there, whether it meets the requirements or not, and no other. Not where six-bars are searched for without a chain. */
  at?: readonly [number, number] | null;
}
