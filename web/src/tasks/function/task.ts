// As the problem file has it.
import type {Point} from "../../engine/protocol";
import type {Range, Task} from "../../state/task";

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
  x?: Range;
  y?: Range;
  input_range_deg: Range;
  output_range_deg: Range;
  points?: number;
  spacing?: "chebyshev" | "even" | readonly number[];
}
/** A number that is left open for a map of two parameters; pairs count from 1. */
export interface FreeParameter {
  number: "output_scale" | "pair_output";
  pair?: number;
  range?: Range;
}
export interface FunctionTask extends Task {
  kind: "function";
  mechanism: "four_bar";
  pairs?: readonly AnglePair[]; // these or the function
  function?: NamedFunction;
  ground_pivots?: {input: Point; output: Point};
  free?: FreeParameter;
}

export function is_function(task: Task): task is FunctionTask {
  return task.kind === "function" && task.mechanism === "four_bar";
}
