// What the engine says of an attitude (bindings/wasm/attitude_reply.cpp).
import type {Converted} from "../../orientation/orientation";
import type {Rows, Vec3} from "../../sphere/vectors";

export type Triple<T> = readonly [T, T, T];
/** A 4 × 4 matrix by rows. */
export type Pose = readonly [Row4, Row4, Row4, Row4];
type Row4 = readonly [number, number, number, number];

export interface Turns {
  angles_deg: Vec3;
  given: boolean;
  locked: boolean;
  near_lock: boolean;
  lock_distance: number;
  determined: {combination: "first + third" | "first - third"; angle_deg: number};
  frames: Triple<Rows>;
  axes: Triple<Vec3>;
  now: {frame: Rows; axes: Triple<Vec3>};
}
export interface ScrewReport {
  matrix: Pose;
  translation: Vec3;
  screw: {
    kind: "identity" | "pure_translation" | "half_turn" | "general";
    axis: Vec3;
    axis_defined: boolean;
    point: Vec3 | null;
    angle_deg: number;
    slide: number;
    pitch: number | null;
  };
}
export interface SequenceRates {
  angles_deg: Vec3;
  rates_deg: Vec3;
  locked: boolean;
  lock_distance: number;
}
export interface AttitudeReply {
  convert: Converted;
  turns: Turns;
  rotation: {path: Vec3[]; now: {frame: Rows; vector: Vec3}};
  screw: ScrewReport;
  motion: {path: Vec3[]; from: Pose; now: Pose};
  rates: {
    fixed: {velocity: Vec3};
    moving: {velocity: Vec3};
    quaternion_first: readonly [number, number, number, number];
    euler: Record<string, SequenceRates>;
  };
  rate_matrix: Rows;
}
