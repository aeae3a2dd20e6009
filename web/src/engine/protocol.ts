// What the page and its two engine workers say to each other. All kinematics happens behind these messages, in the
// C++ engine; the page only draws and words. Angles are degrees where a name ends in _deg, else radians; lengths and
// points are the user's unit, fixed frame; moving pivots lie as in position 1 unless said otherwise.
import type {Box, Requirements} from "./problem";

export type {Box, Requirements};

/** A cell or a point of the map: coordinates τ along its two axes, that of the input link (input) and the other's
 *  (output) where each has an axis of its own. */
export type TauPair = readonly [input: number, output: number];
export type Point = readonly [x: number, y: number];
/** Where a linkage has a joint: a point of the plane, or a unit vector along an axis through the centre of a sphere. */
export type Pivot = Point | readonly [x: number, y: number, z: number];

export const linkage_types = [
  "crank_rocker",
  "rocker_crank",
  "double_crank",
  "double_rocker",
  "triple_rocker_ground",
  "triple_rocker_input",
  "triple_rocker_coupler",
  "triple_rocker_output",
  "change_point",
  "degenerate",
  "triple_rocker",
] as const; // index = code in the map
export type LinkageType = (typeof linkage_types)[number];
export const degenerate = linkage_types.indexOf("degenerate");

export const defect_bits = {order: 1, branch: 2, circuit: 4} as const;

/** What can be required of a linkage. In a cell's bits of what it fails (a degenerate cell has all set), and in counts by
 *  requirement, they come in the order in which the kind of the task has them (tasks/kind.ts). */
export type RequirementKey = Exclude<keyof Requirements, "respect_direction">;

/** What a colour of the map can stand for, beside the type: values as f32, 0 where not defined, never NaN. Kinds of tasks
 *  add theirs (tasks/<kind>/replies.ts). */
export interface Properties {
  min_transmission_angle_deg: number;
  min_transmission_angle_full_turn_deg: number;
  link_ratio: number;
  longest_link: number;
  driver_sweep_deg: number;
  tolerance_error: number; // with tolerances: user's unit, of functions and spheres degrees
  yield: number; // with tolerances and a limit, as far as it is sampled
}
export type Property = keyof Properties;

/** A sentence to be worded by the page: texts hold `<code>` with {placeholders} for `values`. `message` is the same
 *  sentence in English as the command line prints it, for codes that the texts do not know. */
export interface Notice {
  code: string;
  values: Record<string, number | string>;
  message: string;
}
/** The caller's mistake, as the command line says it: worded like a notice, and where it is. */
export interface Mistake extends Notice {
  place: string;
}

// ---- the task -------------------------------------------------------------------------------------------------

/** A stretch of a map axis in display order. `place` runs over [0, 1] along the whole axis; τ within a block is
 *  piecewise linear through the knots and unwrapped: it may leave the branch's own interval and is to be taken modulo
 *  the branch. */
export interface AxisBlock {
  branch: number; // index into branches
  from: number;
  to: number; // places, from < to
  knots: [place: number, tau: number][]; // at least the two ends, rising places, tau strictly monotone
}
export interface Branch {
  /** Of a curve: odd, oval, nodal, line, circle, conic, line_at_infinity, point, center_line, fixed_circle. Of other axes: sheet_1,
   *  sheet_2, sheet_1_opposite, …, direction_1, …, direct, opposite, range; of straight lines the layers. */
  name: string;
  from: number;
  to: number; // τ
}
/** What the coordinate along an axis stands for. */
export const axis_quantities = [
  "curve_coordinate", // place on a curve of dyads
  "burmester_point", // one of a few dyads; each fills a branch
  "side_direction", // of the grounded link in position 1, degrees
  "side_length", // of the grounded link
  "output_scale", // factor on the output's travel
  "pair_output", // output angle of one pair, degrees
  "nothing", // one place only
  // Of straight lines: degrees, or lengths.
  "link_direction", // of a grounded link's line
  "link_ray", // from the pole along a grounded link, counted from the pole tangent
  "point_ray",
  "pole_height", // off the line
  "pivot_height",
  "frame_height", // of the point off the ground link
  "pivot_distance", // of a ground pivot from the pole, signed
  "output_arm",
  "link_length", // signed
  "crank_length",
  "point_arm",
  "crank_range",
  // Of three positions with given pivots, lengths; a centre is a ground pivot, a circle point a moving one.
  "center_x", // of the link that is looked for
  "center_y",
  "circle_x",
  "circle_y",
  "center_on_line", // along the line, from its point on
  "circle_on_line",
] as const;
export type AxisQuantity = (typeof axis_quantities)[number];

export interface Axis {
  quantity: AxisQuantity;
  /** What people read along it, at even steps of each branch; null where they read nothing. */
  ticks: (readonly [tau: number, value: number])[] | null;
  /** Which of the display orders this is: given back in `explore.order`, it is forced (undo restores the map exactly). */
  order: number;
  branches: Branch[];
  blocks: AxisBlock[];
}
export type Side = "input" | "output";
export type Axes = Record<Side, Axis>;
/** A linkage of the map. */
export interface Picked {
  tau: TauPair;
  /** Where it stands on the map. It stays there while the task changes; τ follows. Null until the axis is known. */
  place: TauPair | null;
}

/** Marks along the axes and on the curves. */
export interface Special {
  kind: "pole" | "node" | "center_at_infinity" | "circle_at_infinity" | "focus";
  /** pole: the two positions, from 1. */
  positions?: [number, number];
  /** Places on the map axis, τ; empty for what is only drawn (a pole that is no circle point of its own, focus). */
  tau: number[];
  center: Point | null; // where it lies on the drawing, fixed curve
  circle: Point | null;
}
/** M dyads along all branches of an axis by rising τ, dense enough to draw (evenly by length). Homogeneous (w, x, y) of
 *  unit length, user's frame; a point at infinity has |w| < 1e-9 in the working frame. Each branch is closed. None where
 *  the dyads depend on the other axis as well. */
export interface DyadPolygon {
  tau: Float64Array;
  center: Float64Array; // 3M
  circle: Float64Array; // 3M
  branch: Uint8Array; // M
}
/** The Burmester curves; where there are none, what the dyads of the input lie along. */
export interface Curves extends DyadPolygon {
  kind: string; // or an axis quantity
  center_kind: string;
  kappa: number | null;
  /** Asymptotes of the two curves as (point, direction), where they have one. */
  asymptotes: {center: [Point, Point] | null; circle: [Point, Point] | null};
}
/** Kinds of tasks add what is theirs (tasks/<kind>/replies.ts), here and to linkages. */
export interface TaskAnswer {
  status: "solved" | "no_solution" | "degenerate";
  reason: Notice | null; // set unless solved
  pattern: string; // "P-P-P-P"
  condition: number;
  characteristic_length: number;
  warnings: Notice[];
  curves: Curves;
  /** Of the output; null: the same as the input's. */
  output_curves: DyadPolygon | null;
  axes: Axes;
  /** Both axes carry the same dyads: (u, v) and (v, u) are the same bars, driven from the other side. */
  symmetric: boolean;
  specials: Special[];
  /** Requirements as used, the defaults filled in (null: switched off). */
  requirements: Requirements;
}

// ---- the map --------------------------------------------------------------------------------------------------

/** Part of the region in places of the two axes. */
export interface Window {
  input: readonly [number, number];
  output: readonly [number, number];
}
export const whole: Window = {input: [0, 1], output: [0, 1]};

/** A value that would leave something: a box made larger; null: drop the requirement. */
export interface Relaxation {
  requirement: RequirementKey;
  value: number | Box | null;
  leaves: number;
}
export interface MissedBox {
  requirement: RequirementKey;
  nearest: Point;
  beyond: Point;
}
export interface Census {
  /** Cells (pairs without the diagonal) of each LinkageType; sliders count as degenerate and in nothing else. */
  types: number[];
  pairs: number;
  order: number;
  branch: number;
  circuit: number;
  defect_free: number;
  meeting: number;
  /** Cells of each LinkageType that meet everything. */
  meeting_types: number[];
  /** By requirement: cells that fail only this one ("without it +N"). */
  only: number[];
  /** By requirement: cells left after it and all before it. */
  left: number[];
  /** Defect bits of cells that fail by defects: share per kind, for the sentence "64 % fail by order". */
  relax: Relaxation[]; // dearest first; only if meeting = 0
  /** The fewest requirements that leave something when they are dropped together; where relaxing one alone would, null. */
  relax_together: {requirements: RequirementKey[]; leaves: number} | null;
  /** Boxes that the curve does not enter, its nearest point, and the way to it from the border; only if meeting = 0. */
  missed_boxes: MissedBox[];
  /** Linkages looked at inside the windows for hinges, between the cells of the map; only if meeting = 0. */
  inside: {looked_at: number; meeting: number; is_empty: boolean};
}
export interface MapAnswer {
  samples: number; // as asked; an axis of a few places has one row or column to each
  rows: number;
  columns: number;
  window: Window;
  property: Property;
  /** τ of rows (input, input link) and columns, in display order: row 0 is place window.input[0]. */
  input_tau: Float64Array;
  output_tau: Float64Array;
  // rows × columns, row-major [input][output]
  type: Uint8Array;
  defects: Uint8Array;
  fails: Uint16Array;
  value: Float32Array;
  census: Census;
  /** Along each axis the best objective (property value) that meets everything, 0 where none, and its partner's index. */
  ridge: {input: Float32Array; input_partner: Uint32Array; output: Float32Array; output_partner: Uint32Array};
}

// ---- a linkage ------------------------------------------------------------------------------------------------

export interface GroundedLink {
  coordinate: number;
  center: Point | null; // null: at infinity
  circle: Point | null;
  center_homogeneous: [number, number, number];
  circle_homogeneous: [number, number, number];
  length: number | null;
}
export interface Defects {
  order: boolean;
  branch: boolean;
  circuit: boolean;
}
/** One state of the drive: a row of `states`. */
export const state_columns = [
  "input_deg", // driver angle from position 1, in the sense of travel positive
  "ax",
  "ay", // moving pivot of the input
  "bx",
  "by", // moving pivot of the output
  "x",
  "y",
  "theta_deg", // pose of the moving frame
  "transmission_angle_deg",
  "coupler_deg", // coupler angle from position 1
  "output_deg", // output angle from position 1
  "velocity_ratio", // dψ/dφ, output by input; 0 at a dead point
  "mechanical_advantage", // output torque over input torque, |dφ/dψ|; 0 where unbounded
] as const;
export const state_width = state_columns.length;
export interface Drive {
  /** K × width, by rising input_deg, the prescribed positions among them exactly. */
  states: Float64Array;
  /** Numbers to a state: state_columns, and of a six-bar x and y of each hinge after them. */
  width: number;
  /** One per position: its row, and whether the driver gets there in this assembly. Unreached: state = -1. */
  ticks: {position: number; state: number; reached: boolean}[];
  full_turn: boolean; // first and last state are the same place
  limits: {low: "dead_point" | null; high: "dead_point" | null};
  /** Prescribed stretch: rows of the first and last position (task), −1 where a defect keeps them apart. */
  task: [number, number];
}
export interface Linkage {
  tau: TauPair;
  type: LinkageType;
  defects: Defects;
  /** Why not, e.g. {code: "order_defect", values: {order: "1-3-2-4"}}; null without defects and not degenerate. */
  reason: Notice | null;
  input: GroundedLink;
  output: GroundedLink;
  lengths: {ground: number; input: number; coupler: number; output: number} | null; // null: a slider
  link_ratio: number | null;
  longest: number | null;
  min_transmission_angle_deg: number | null;
  min_transmission_angle_full_turn_deg: number | null;
  driver_sweep_deg: number | null;
  drive_sense: "ccw" | "cw" | "either" | null;
  dead_points_deg: number[]; // driver angles from position 1
  residual: number; // worst error of a grounded link's length over the positions, user's unit
  /** By how much the freed pose is missed at best, and where the driver stands then; null where none is freed. */
  miss?: {distance: number; angle_deg: number; input_deg: number} | null;
  swapped: {type: LinkageType; defects: Defects; min_transmission_angle_deg: number | null} | null;
  fails: number; // requirement bits
  tolerance?: ToleranceFigures | null; // by few samples; with tolerances only, null at a dead point
  drive: Drive | null; // null: a slider or zero link
}
/** Bits failed along the curve samples of each side when one grounded link is held and the other slides. */
export type Live = Record<Side, Uint16Array>;

// ---- one instant ----------------------------------------------------------------------------------------------

/** A circle, or the line that it is where its centre is at infinity. */
export type CircleOrLine = {center: Point; radius: number} | {line: {point: Point; direction_deg: number}};
/** Of a planar four-bar as it stands: the report "instant" of {"pivots"}; schema/result.schema.json has the numbers. */
export interface InstantReport {
  instant:
    | {degenerate: string}
    | {
        kind: "turning" | "pivoting" | "translating";
        pole: Point | null;
        pole_tangent_deg: number | null;
        inflection_diameter: number | null;
        inflection_pole: Point | null;
        inflection_circle: CircleOrLine | null;
        return_circle: CircleOrLine | null;
        bresse_circle: CircleOrLine | null;
        acceleration_pole: Point | null;
        ball_point: Point | null;
        burmester_points: Point[];
        /** What is special of the configuration. */
        notes: Pick<Notice, "code" | "message">[];
      };
  /** Polylines about the linkage. */
  circling_points?: Point[][];
  centering_points?: Point[][];
}

// ---- tolerances -----------------------------------------------------------------------------------------------

/** What tolerances do to a linkage, as in a result file. */
export interface ToleranceFigures {
  unit: "length" | "degrees"; // of the errors
  error: number; // to first order
  error_sampled: number;
  error_realigned?: number; // of straight lines
  error_realigned_sampled?: number;
  beyond_first_order: boolean; // the sampled error is the one that counts
  worst_case: number;
  mean_plus_3_sigma: number;
  mean_plus_3_sigma_realigned?: number;
  signal_to_noise_db: number | null;
  yield: number | null; // null: no limit
  yield_interval: [number, number] | null;
  not_assembled: number; // share
  samples: number;
  seed: number;
  /** Largest share first. */
  sensitivities: {
    parameter: string;
    tolerance?: number; // half
    tolerance_deg?: number;
    share: number;
    per_position: number[];
  }[];
  allocation: {parameter: string; tolerance?: number; tolerance_deg?: number}[] | null;
}
export interface ToleranceAnswer {
  tolerance: ToleranceFigures;
  /** Errors of samples, a row of counts to each position over one scale: from 0, of lines from the right to the left. */
  histograms: {from: number; to: number; counts: number[][]};
  /** Of the samples drawn: of a straight line its ends and the middle. */
  positions: number;
  /** By sample, position, joint: x and y, on the sphere x, y, z. Joints: of four-bars the input's fixed and moving pivot,
   *  the output's moving and fixed pivot, in the plane and the body's origin; of six-bars the seven hinges and the body's
   *  origin. Samples that do not assemble are left out. */
  drawn: Float64Array;
}

// ---- messages -------------------------------------------------------------------------------------------------

export type ExportFormat = "svg" | "dxf" | "csv" | "json" | "result";
/** Files to make a linkage from, as plates on pins: parts to print, or a drawing (DXF) to cut the plates from; and the
 *  same for simulators of rigid bodies. */
export type MachineFormat = "3mf" | "stl" | "plates" | "urdf" | "sdf" | "mjcf";
/** User's unit. About a centre plates are pieces of spherical shells. */
export interface PlateSizes {
  width: number;
  thickness: number;
  gap: number; // between layers, and between what moves past each other in one
  pin: number; // diameter
  clearance: number; // by how much a hole is wider than its pin
  radius: number; // of the outermost sphere; 0: planar
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
/** A linkage as plates on pins. Bodies and hinges are called as in the files. */
export interface MachinePlan {
  sizes: PlateSizes;
  /** From the ground, which lies in layer 0 (about a centre the innermost). */
  layers: [body: string, layer: number][];
  /** Free of collisions over the whole travel, or at least from the first position to the last. */
  over: "travel" | "task";
  crossings: PlateCrossing[];
}

/** Requests by kind. Every request carries the problem (the file's text); a worker keeps the last and reads it again
 *  only when the text differs. */
export interface Requests {
  /** Task, map and census at once, and what is picked, settled on the map's axes: what follows a drag. `order`: "nearest"
   *  to the last frame's, "fresh" (the canonical one), or the code of a display order. */
  explore: {
    problem: string;
    samples: number;
    window: Window;
    property: Property;
    order: "nearest" | "fresh" | number;
    picked?: Picked | null;
    live?: boolean; // its live part, too
  };
  linkage: {problem: string; tau: TauPair};
  live: {problem: string; tau: TauPair};
  /** Cells that pass (of samples², fewer where cells take long) with a part of the task moved by a grid of offsets up to
   *  ± reach (user's unit) or turned up to ± reach_deg. Parts are the poses, from 0; of six-bars, after them, the chain's
   *  hinges a, b, d. */
  halo: {problem: string; part: number; mode: "move" | "turn"; reach: number; steps: number; samples: number};
  best: {problem: string; most: number};
  /** The best of several problems one after the other, the answer that of the last; each is told as it comes. */
  search: {rounds: readonly string[]; most: number};
  improve: {problem: string; tau: TauPair};
  verify: {problem: string; tau: TauPair};
  /** With tolerances: what they do to a linkage, by all samples, with histograms of so many bins and so many samples to be
   *  drawn. */
  tolerance: {problem: string; tau: TauPair; bins: number; drawn: number};
  /** Samples the yields of so many more cells of the map explored last; `explore` then shows what is known. */
  yields: {problem: string; cells: number};
  /** The cells of the map explored last that no other beats in both objectives. */
  front: {problem: string; objectives: readonly [string, string]};
  trace: {problem: string; tau: TauPair; point: Point}; // path of a body point (position 1 coordinates)
  export: {problem: string; tau: TauPair; format: ExportFormat};
  /** What is left out of the sizes is chosen. */
  machine: {problem: string; tau: TauPair; sizes: Partial<PlateSizes>};
  machine_file: {problem: string; tau: TauPair; sizes: Partial<PlateSizes>; format: MachineFormat};
  /** What is no linkage's: JSON text that the engine's report of this name reads. */
  report: {of: string; text: string};
  /** Reads a problem file: its normal form, poses in numbers, and what to know of it; or its mistakes. */
  read: {text: string};
}
/** One of the best, with what it is on the map by name. */
export interface Ranked extends Partial<Record<Property, number | null>> {
  tau: TauPair;
  type: LinkageType;
  min_transmission_angle_deg: number;
  link_ratio: number | null;
  longest: number | null;
  /** Of a four-bar both ends of input and output, of a longer linkage all its hinges. */
  pivots: Pivot[];
}
export interface Replies {
  explore: {
    task: TaskAnswer;
    map: MapAnswer | null;
    engine_ms: number; // of these two
    linkage: Linkage | null;
    live: Replies["live"] | null;
  };
  linkage: {linkage: Linkage; engine_ms: number};
  live: Live & {engine_ms: number};
  halo: {offsets: Float64Array; counts: Uint32Array; steps: number; reach: number; engine_ms: number}; // counts: row-major [dy][dx] (steps²) or [turn] (steps)
  best: {linkages: Ranked[]; notices: Notice[]};
  search: Replies["best"];
  improve: {tau: TauPair; improved: boolean};
  verify: {verified: boolean; residual: number};
  tolerance: ToleranceAnswer | Record<"tolerance", null>; // null: no tolerances, or a dead point
  yields: {done: number; total: number}; // cells that meet all else
  front: {front: [row: number, column: number, first: number, second: number][]}; // the best by the first one first
  trace: {points: Float64Array}; // 2K, one per drive state
  export: {text: string; extension: string};
  machine: MachinePlan;
  machine_file: {bytes: Uint8Array<ArrayBuffer>; extension: string};
  report: {report: object};
  read: {problem: string; notices: Notice[]};
}
export type Kind = keyof Requests;

/** What a job tells on its way, of those that do. */
export interface Tidings {
  search: {rounds: number; found: Replies["best"]}; // rounds that are through, and what the last of them found
}
export type TidingsOf<K extends Kind> = K extends keyof Tidings ? Tidings[K] : never;

/** A reply that is not one: the caller's mistakes. */
export interface Refused {
  mistakes: Mistake[];
}

export type RequestMessage = {[K in Kind]: {id: number; kind: K} & Requests[K]}[Kind];
export type ReplyMessage =
  | {[K in Kind]: {id: number; kind: K; reply: Replies[K]}}[Kind]
  | {[K in keyof Tidings]: {id: number; kind: K; tidings: Tidings[K]}}[keyof Tidings]
  | {id: number; kind: Kind; refused: Refused}
  | {kind: "ready"; version: string}
  | {kind: "crashed"; message: string};
