import {state_columns, state_width, type Drive} from "../contract/messages";
import type {State} from "../state/drive";

/** For tests: a drive whose rows are given by some of their columns. */
export function sample_drive(rows: Partial<State>[], ticks: number[], more: Partial<Drive> = {}): Drive {
  const states = new Float64Array(rows.length * state_width);
  rows.forEach((row, i) =>
    state_columns.forEach((name, column) => (states[i * state_width + column] = row[name] ?? 0)),
  );
  return {
    states,
    width: state_width,
    ticks: ticks.map((state, i) => ({position: i + 1, state, reached: state >= 0})),
    full_turn: false,
    limits: {low: "dead_point", high: "dead_point"},
    task: [ticks[0]!, ticks.at(-1)!],
    ...more,
  };
}
/** Rows at these input angles. */
export function rows_at(angles: number[]): Partial<State>[] {
  return angles.map((input_deg) => ({input_deg}));
}
