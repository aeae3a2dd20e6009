// Looking up a drive table: where the linkage is at a driver angle. Nothing is computed here but interpolation.
import {state_columns, state_width, type Drive, type Point} from "../contract/messages";

export type State = Record<(typeof state_columns)[number], number>;

/** Rows of numbers by rising driver angle, which stands first in each. */
export type Table = Pick<Drive, "states" | "width">;

export function row_count(drive: Table): number {
  return drive.states.length / drive.width;
}
export function angle_of_row(drive: Table, row: number): number {
  return drive.states[row * drive.width]!;
}
export function travel(drive: Drive): [low: number, high: number] {
  return [angle_of_row(drive, 0), angle_of_row(drive, row_count(drive) - 1)];
}
export function row_state(drive: Drive, row: number): State {
  const state = {} as State;
  state_columns.forEach((name, column) => (state[name] = drive.states[row * drive.width + column]!));
  return state;
}

const [x_at, y_at, theta_at] = (["x", "y", "theta_deg"] as const).map((name) => state_columns.indexOf(name));
/** Where the guided body is: of a whole way nothing else is wanted. */
export function row_pose({states, width}: Table, row: number): Pick<State, "x" | "y" | "theta_deg"> {
  const at = row * width;
  return {x: states[at + x_at!]!, y: states[at + y_at!]!, theta_deg: states[at + theta_at!]!};
}

/** All hinges of a six-bar. */
export function row_joints(drive: Drive, row: number): Point[] {
  const found: Point[] = [];
  for (let at = row * drive.width + state_width; at < (row + 1) * drive.width; at += 2)
    found.push([drive.states[at]!, drive.states[at + 1]!]);
  return found;
}

/** The last row before a driver angle (degrees from position 1), and the share of the way to the next. */
export function row_at(drive: Table, angle_deg: number): {row: number; share: number} {
  const last = row_count(drive) - 1;
  let low = 0,
    high = last;
  const angle = Math.min(Math.max(angle_deg, angle_of_row(drive, 0)), angle_of_row(drive, last));
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (angle_of_row(drive, middle) <= angle) low = middle;
    else high = middle;
  }
  if (angle_of_row(drive, high) === angle) return {row: high, share: 0};
  const from = angle_of_row(drive, low),
    to = angle_of_row(drive, high);
  return {row: low, share: to > from ? (angle - from) / (to - from) : 0};
}
/** The state at a driver angle, linear between the table's rows; rows themselves exactly. */
export function state_at(drive: Drive, angle_deg: number): State {
  const {row, share} = row_at(drive, angle_deg),
    state = row_state(drive, row);
  if (share === 0) return state;
  const next = row_state(drive, row + 1);
  for (const name of state_columns) state[name] += share * (next[name] - state[name]);
  return state;
}

export function joints_at(drive: Drive, angle_deg: number): Point[] {
  const {row, share} = row_at(drive, angle_deg),
    joints = row_joints(drive, row);
  if (share === 0) return joints;
  const next = row_joints(drive, row + 1);
  return joints.map(([x, y], i) => [x + share * (next[i]![0] - x), y + share * (next[i]![1] - y)]);
}

const beyond_deg = 30; // outside the task, one unit of the stage is so many degrees

function stops(drive: Drive): number[] {
  return drive.ticks
    .filter((t) => t.reached)
    .map((t) => angle_of_row(drive, t.state))
    .sort((a, b) => a - b);
}

/** Stage: a number that compares linkages: k between stop k + 1 and the next (0 the first position met), linear in the
 *  driver angle between stops, and running on outside. */
export function angle_at_stage(drive: Drive, stage: number): number {
  const at = stops(drive);
  if (at.length === 0) return 0;
  const last = at.length - 1;
  const [low, high] = travel(drive);
  const angle =
    stage < 0
      ? at[0]! + stage * beyond_deg
      : stage >= last
        ? at[last]! + (stage - last) * beyond_deg
        : at[Math.floor(stage)]! + (stage - Math.floor(stage)) * (at[Math.floor(stage) + 1]! - at[Math.floor(stage)]!);
  return Math.min(Math.max(angle, low), high);
}
export function stage_at_angle(drive: Drive, angle_deg: number): number {
  const at = stops(drive);
  if (at.length === 0) return 0;
  const last = at.length - 1;
  if (angle_deg < at[0]!) return (angle_deg - at[0]!) / beyond_deg;
  if (angle_deg >= at[last]!) return last + (angle_deg - at[last]!) / beyond_deg;
  let k = 0;
  while (k + 1 < last && at[k + 1]! <= angle_deg) ++k;
  return k + (angle_deg - at[k]!) / (at[k + 1]! - at[k]!);
}
