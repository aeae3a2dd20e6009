// As the problem file has it.
import type {Point} from "../../contract/messages";
import type {Interval, Task} from "../../state/task";

export interface AnglePair {
  input_deg: number;
  output_deg: number;
  derivatives?: {input: number; output: number}[];
}
/** What the pairs are taken from: an expression in x, or a table. */
export interface NamedFunction {
  expression?: string;
  table?: readonly Point[];
  interpolation?: "monotone_cubic" | "linear";
  x?: Interval;
  y?: Interval;
  input_range_deg: Interval;
  output_range_deg: Interval;
  points?: number;
  spacing?: "chebyshev" | "even" | readonly number[];
}
/** A number that is left open for a map of two parameters; pairs count from 1. */
export interface FreeParameter {
  number: "output_scale" | "pair_output";
  pair?: number;
  range?: Interval;
}
/** The output shall turn with the input as prescribed, in the plane or about axes through one point. */
export interface AngleTask extends Task {
  kind: "function";
  pairs?: readonly AnglePair[]; // these or the function
  function?: NamedFunction;
  free?: FreeParameter;
}
export interface FunctionTask extends AngleTask {
  mechanism: "four_bar";
  ground_pivots?: {input: Point; output: Point};
}

export function is_function(task: Task): task is FunctionTask {
  return task.kind === "function" && task.mechanism === "four_bar";
}
