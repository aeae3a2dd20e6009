// What the page and its two engine workers say to each other. All kinematics happens behind these messages, in the
// C++ engine; the page only draws and words. Angles are degrees where a name ends in _deg, else radians; lengths and
// points are the user's unit, fixed frame; moving pivots lie as in position 1 unless said otherwise. What comes as text is
// described by the engine itself (replies.ts); here is what comes in arrays of numbers, and what is asked.
import type {Requirements, Spring} from "./problem";
import {
  linkage_types,
  type Axes,
  type Census,
  type CurveKinds,
  type Defects,
  type LinkageType,
  type LoadsReply,
  type MachinePlan,
  type Mistake,
  type Notice,
  type PlateSizes,
  type FitSearchReply,
  type StudMapReply,
  type TaskReply,
  type ToleranceReply,
  type Travel,
} from "./replies";
import type {Tolerance} from "./result";

export type {Box, Requirements} from "./problem";
export type {InsideWindows, Relaxation, Tolerance as ToleranceFigures} from "./result";
export {axis_quantities, defect_bits, linkage_types, requirement_keys_of, state_columns, state_width} from "./replies";
export type {
  Axes,
  Axis,
  AxisBlock,
  AxisQuantity,
  Branch,
  Census,
  Defects,
  LinkageType,
  MachinePlan,
  MissedBox,
  Mistake,
  Notice,
  PlateCrossing,
  PlateSizes,
  Special,
} from "./replies";

/** A cell or a point of the map: coordinates τ along its two axes, that of the input link (input) and the other's
 *  (output) where each has an axis of its own. */
export type TauPair = readonly [input: number, output: number];
export type Point = readonly [x: number, y: number];
/** Where a linkage has a joint: a point of the plane, or a unit vector along an axis through the centre of a sphere. */
export type Pivot = Point | readonly [x: number, y: number, z: number];
export type Side = keyof Axes;

/** What can be required of a linkage. Made-up kinds of tests add theirs. */
export type RequirementKey = Exclude<keyof Requirements, "respect_direction">;

export const degenerate = linkage_types.indexOf("degenerate");

/** What a colour of the map can stand for, beside the type: values as f32, 0 where not defined, never NaN. Kinds of tasks
 *  add theirs (kinds/<kind>/replies.ts). */
export interface Properties {
  min_transmission_angle_deg: number;
  min_transmission_angle_full_turn_deg: number;
  link_ratio: number;
  longest_link: number;
  driver_sweep_deg: number;
  tolerance_error: number; // with tolerances: user's unit, of functions and spheres degrees
  yield: number; // with tolerances and a limit, as far as it is sampled
  hand_force: number; // with loads: N, the worst of the cases that count
  max_open_force: number;
  max_close_force: number;
  hold_open: number;
  max_pin_force: number;
  max_torque: number; // N·m, of the driving crank
  cylinder_force: number;
  self_rise_deg: number; // turn of the body where it begins to rise by itself: the whole where it does not
  self_close_deg: number; // where it begins to close by itself: 0 where it does not
  hand_force_error: number; // N, of the stations at which hand_force is looked for
  best_F1: number; // N, of a spring that leaves it free
}
export type Property = keyof Properties;

// ---- the task -------------------------------------------------------------------------------------------------

/** A linkage of the map. */
export interface Picked {
  tau: TauPair;
  /** Where it stands on the map. It stays there while the task changes; τ follows. Null until the axis is known. */
  place: TauPair | null;
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
export type Curves = CurveKinds & DyadPolygon;
export interface TaskAnswer extends Omit<TaskReply, "curves"> {
  curves: Curves;
  /** Of the output; null: the same as the input's. */
  output_curves: DyadPolygon | null;
}

// ---- the map --------------------------------------------------------------------------------------------------

/** Part of the region in places of the two axes. */
export interface MapWindow {
  input: readonly [number, number];
  output: readonly [number, number];
}
export const whole: MapWindow = {input: [0, 1], output: [0, 1]};

export interface MapAnswer {
  samples: number; // as asked; an axis of a few places has one row or column to each
  rows: number;
  columns: number;
  window: MapWindow;
  property: Property;
  /** τ of rows (input, input link) and columns, in display order: row 0 is place window.input[0]. */
  input_tau: Float64Array;
  output_tau: Float64Array;
  // rows × columns, row-major [input][output]
  type: Uint8Array;
  defects: Uint8Array;
  fails: Uint32Array;
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
export interface Drive extends Omit<Travel, "dead_points_deg"> {
  /** K × width, by rising input_deg, the prescribed positions among them exactly. */
  states: Float64Array;
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
  dead_points_deg: readonly number[]; // driver angles from position 1
  residual: number; // worst error of a grounded link's length over the positions, user's unit
  /** By how much the freed pose is missed at best, and where the driver stands then; null where none is freed. */
  miss?: {distance: number; angle_deg: number; input_deg: number} | null;
  swapped: {type: LinkageType; defects: Defects; min_transmission_angle_deg: number | null} | null;
  fails: number; // requirement bits
  tolerance?: Tolerance | null; // by few samples; with tolerances only, null at a dead point
  drive: Drive | null; // null: a slider or zero link
}
/** Bits failed along the curve samples of each side when one grounded link is held and the other slides. */
export type Live = Record<Side, Uint32Array>;

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

export interface ToleranceAnswer extends ToleranceReply {
  /** By sample, position, joint: x and y, on the sphere x, y, z. Joints: of four-bars the input's fixed and moving pivot,
   *  the output's moving and fixed pivot, in the plane and the body's origin; of six-bars the seven hinges and the body's
   *  origin. Samples that do not assemble are left out. */
  drawn: Float64Array;
}

// ---- springs that are looked for --------------------------------------------------------------------------------

/** What a search of a spring between two studs has come to; `why_not`: nothing. */
export interface PlacedSpring {
  title: string;
  length_unit: string;
  /** As loads have it. */
  spring: Spring | null;
  max_hand_force: number | null; // N, over the whole travel, all friction counted
  at_stations: number | null; // of some places of the travel: what the bound is to be compared with
  lower_bound: number | null; // nothing in the boxes is below
  proven: boolean;
  places: number | null;
  boxes: number | null;
  why_not?: Omit<Notice, "values"> & Partial<Pick<Notice, "values">>;
}
export type StudEnd = "ground" | "body";

// ---- as plates on pins ------------------------------------------------------------------------------------------

/** Also what is drawn of it and how it moves. */
export interface Machine extends MachinePlan {
  /** x, y, z as they lie in position 1; about a centre that is the origin. */
  vertices: Float32Array;
  /** Three of these vertices each, part by part. */
  triangles: Uint32Array;
  /** By rising driver angle: the angle in degrees, then of each body but the ground, in the order of the layers, its
   *  displacement from position 1, a quaternion (w, x, y, z) and a translation. */
  travel: Float64Array;
}

// ---- messages -------------------------------------------------------------------------------------------------

export type ExportFormat = "svg" | "dxf" | "csv" | "json" | "result";
/** Files to make a linkage from, as plates on pins: parts to print, or a drawing (DXF) to cut the plates from; and the
 *  same for simulators of rigid bodies. */
export type MachineFormat = "3mf" | "stl" | "plates" | "urdf" | "sdf" | "mjcf";
/** Requests by kind. Every request carries the problem (the file's text); a worker keeps the last and reads it again
 *  only when the text differs. */
export interface Requests {
  /** Task, map and census at once, and what is picked, settled on the map's axes: what follows a drag. `order`: "nearest"
   *  to the last frame's, "fresh" (the canonical one), or the code of a display order. */
  explore: {
    problem: string;
    samples: number;
    window: MapWindow;
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
  /** With loads: the forces in a linkage, and their curves. */
  loads: {problem: string; tau: TauPair};
  /** With loads: the best spring between two boxes for its studs (BOXES.json text), in rounds of ever longer proof, each told;
   *  the answer is that of the last. */
  place_spring: {problem: string; tau: TauPair; boxes: string};
  stud_map: {problem: string; tau: TauPair; boxes: string; stud: StudEnd; columns: number; rows: number};
  /** Where linkages are fitted: with some 16 times as many starts as usual, told how far it is. */
  search_fits: {problem: string};
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
  /** Of its point, where it has one that is to follow a path. */
  path?: readonly (readonly [number, number])[] | null;
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
  loads: LoadsReply | Record<"loads", null>; // null: no loads, or it does not get through its positions in order
  place_spring: {placed: PlacedSpring | null}; // null: it does not get through its positions in order
  stud_map: {map: StudMapReply | null}; // the other stud in the middle of its box
  search_fits: FitSearchReply;
  yields: {done: number; total: number}; // cells that meet all else
  front: {front: [row: number, column: number, first: number, second: number][]}; // the best by the first one first
  trace: {points: Float64Array}; // 2K, one per drive state
  export: {text: string; extension: string};
  machine: Machine;
  machine_file: {bytes: Uint8Array<ArrayBuffer>; extension: string};
  report: {report: object};
  read: {problem: string; notices: Notice[]};
}
export type Kind = keyof Requests;

/** What a job tells on its way, of those that do. */
export interface Tidings {
  search: {rounds: number; found: Replies["best"]}; // rounds that are through, and what the last of them found
  place_spring: {found: PlacedSpring};
  search_fits: {done: number}; // of 1
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
