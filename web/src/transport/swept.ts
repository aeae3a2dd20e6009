import type {Drive, Point} from "../engine/protocol";
import {row_count, row_state, type State} from "../state/drive";
import {placed} from "../state/problem";
import {played_span} from "./play";

/** The states of the task, or of the whole travel. */
export function shown_states(drive: Drive, whole: boolean): State[] {
  const [low, high] = played_span(drive, whole);
  const states = Array.from({length: row_count(drive)}, (_, row) => row_state(drive, row));
  return states.filter((s) => s.input_deg >= low && s.input_deg <= high);
}
/** Where moving pivots and body get to in these states. */
export function swept_points(states: readonly State[], outline: readonly Point[]): Point[] {
  return states.flatMap((s): Point[] => [[s.ax, s.ay], [s.bx, s.by], ...outline.map((p) => placed(p, s))]);
}
