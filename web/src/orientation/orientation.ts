// An orientation as files give it (schema/attitude.schema.json), and what the engine's report says of it.
import {is_number, is_object, type JsonObject} from "../state/shape";
import type {Rows, Vec3} from "../sphere/vectors";
import type {TextKey} from "../texts/texts.svelte";

export const sequences = [
  ...["xyz", "xzy", "yxz", "yzx", "zxy", "zyx"],
  ...["xyx", "xzx", "yxy", "yzy", "zxz", "zyz"],
] as const;
export type Turning = "intrinsic" | "extrinsic";
export type Quaternion = readonly [w: number, x: number, y: number, z: number];

export type Orientation =
  | {quaternion: Quaternion}
  | {axis: Vec3; angle_deg: number}
  | {rotation_vector: Vec3}
  | {matrix: Rows; nearest?: boolean}
  | {euler_deg: Vec3; sequence: string; turning?: Turning};
export const forms = ["quaternion", "axis", "rotation_vector", "matrix", "euler_deg"] as const;
export type Form = (typeof forms)[number];
export const form_names: Record<Form, TextKey> = {
  quaternion: "orientation.quaternion",
  axis: "orientation.axis_angle",
  rotation_vector: "orientation.rotation_vector",
  matrix: "orientation.matrix",
  euler_deg: "orientation.euler",
};

/** Of the sequences' twelve members each. */
type BySequence<T> = Record<string, T>;
/** What the engine says of an orientation: the report of `linkwright attitude convert`. */
export interface Converted {
  matrix: Rows;
  quaternion: Quaternion;
  axis: Vec3;
  axis_defined: boolean;
  angle_deg: number;
  rotation_vector: Vec3;
  rodrigues: Vec3 | null;
  mrp: Vec3;
  /** Intrinsic ones. */
  euler_deg: BySequence<Vec3>;
  locked: BySequence<boolean>;
  lock_distance: BySequence<number>;
  determined: BySequence<{combination: "first + third" | "first - third"; angle_deg: number}>;
  properties: {orthogonality_error: number; determinant: number};
}

export function form_of(orientation: Orientation): Form {
  return forms.find((form) => form in orientation) ?? "quaternion";
}
export function reversed(sequence: string): string {
  return [...sequence].reverse().join("");
}
/** An extrinsic sequence is the intrinsic one read from its end. */
export function intrinsic_name(sequence: string, turning: Turning): string {
  return turning === "intrinsic" ? sequence : reversed(sequence);
}
/** The angles of any of 24 sequences. */
export function angles_of({euler_deg}: Converted, sequence: string, turning: Turning): Vec3 {
  const angles = euler_deg[intrinsic_name(sequence, turning)] ?? [0, 0, 0];
  return turning === "intrinsic" ? angles : (angles.toReversed() as unknown as Vec3);
}
/** The same orientation in another form. */
export function in_form(report: Converted, form: Form, sequence: string, turning: Turning): Orientation {
  switch (form) {
    case "quaternion":
      return {quaternion: report.quaternion};
    case "axis":
      return {axis: report.axis, angle_deg: report.angle_deg};
    case "rotation_vector":
      return {rotation_vector: report.rotation_vector};
    case "matrix":
      return {matrix: report.matrix};
    case "euler_deg":
      return {
        euler_deg: angles_of(report, sequence, turning),
        sequence,
        ...(turning === "extrinsic" ? {turning} : {}),
      };
  }
}
/** In the form of another. */
export function in_form_of(report: Converted, like: Orientation): Orientation {
  const {sequence, turning} = "euler_deg" in like ? like : {sequence: "zxz", turning: undefined};
  return in_form(report, form_of(like), sequence, turning ?? "intrinsic");
}

// ---- from outside ---------------------------------------------------------------------------------------------------

function read_numbers<T>(value: unknown, count: number): T | null {
  return Array.isArray(value) && value.length === count && value.every(is_number) ? (value as T) : null;
}
export function read_vector(value: unknown): Vec3 | null {
  return read_numbers(value, 3);
}
export function is_sequence(value: unknown): value is string {
  return sequences.some((sequence) => sequence === value);
}
function read_euler(value: JsonObject): Orientation | null {
  const euler_deg = read_vector(value.euler_deg);
  if (!euler_deg || !is_sequence(value.sequence)) return null;
  return {euler_deg, sequence: value.sequence, ...(value.turning === "extrinsic" ? {turning: "extrinsic"} : {})};
}
function read_matrix(value: JsonObject): Orientation | null {
  const rows = Array.isArray(value.matrix) && value.matrix.length === 3 ? value.matrix.map(read_vector) : [];
  if (rows.length !== 3 || !rows.every((row) => row !== null)) return null;
  return {matrix: rows as unknown as Rows, ...(value.nearest === true ? {nearest: true} : {})};
}
/** Right in its outlines: the engine says what is wrong with it in detail. */
export function read_orientation(value: unknown): Orientation | null {
  if (!is_object(value)) return null;
  const form = forms.filter((one) => one in value);
  if (form.length !== 1) return null;
  const axis = read_vector(value.axis),
    quaternion = read_numbers<Quaternion>(value.quaternion, 4),
    rotation_vector = read_vector(value.rotation_vector);
  switch (form[0]!) {
    case "quaternion":
      return quaternion && {quaternion};
    case "axis":
      return axis && is_number(value.angle_deg) ? {axis, angle_deg: value.angle_deg} : null;
    case "rotation_vector":
      return rotation_vector && {rotation_vector};
    case "matrix":
      return read_matrix(value);
    case "euler_deg":
      return read_euler(value);
  }
}
