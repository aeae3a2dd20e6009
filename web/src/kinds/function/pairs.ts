// The pairs of angles of a function task, whether they are given or taken from a named function.
import type {Point, Side} from "../../contract/messages";
import type {DegreePair} from "./replies";
import type {AnglePair, AngleTask, FreeParameter, FunctionTask, NamedFunction} from "./task";
import type {Desk} from "../../drawing/surface";
import {with_task, type Problem} from "../../state/problem";
import {is_pair, read_list} from "../../state/shape";
import {cells_of} from "../../task_panel/paste";
import {by_parameter} from "../../task_panel/derivatives";
import {evaluated, largest_number} from "../../task_panel/arithmetic";
import {with_other_task} from "../kind_dispatch";
import {position_count_of} from "./kind";

export const angle_keys = {input: "input_deg", output: "output_deg"} as const;

/** What is prescribed, wherever the links turn. */
export function angles_of(problem: Problem): AngleTask {
  return problem.task as AngleTask;
}
export function function_of(problem: Problem): FunctionTask {
  return problem.task as FunctionTask;
}
/** Given ones as they are; those of a named function as the engine has found them. */
export function pairs_of({problem, task}: Pick<Desk, "problem" | "task">): readonly AnglePair[] {
  return (
    angles_of(problem).pairs ??
    (task?.function?.pairs ?? []).map(([input_deg, output_deg]) => ({input_deg, output_deg}))
  );
}
/** With the free number as it is in the linkage in hand. */
export function pairs_in_hand(workbench: Pick<Desk, "problem" | "task" | "hand">): DegreePair[] {
  const own = pairs_of(workbench),
    made = workbench.hand?.function?.pairs,
    free = angles_of(workbench.problem).free;
  return own.map(({input_deg, output_deg}, j) => [
    input_deg,
    (free && made?.length === own.length ? made[j]?.[1] : undefined) ?? output_deg,
  ]);
}

/** Given pairs take the place of a named function. */
export function with_pairs(problem: Problem, pairs: readonly AnglePair[]): Problem {
  const {function: _, ...task} = angles_of(problem);
  return with_other_task(problem, without_foreign_free({...task, pairs}));
}
export function with_named(problem: Problem, named: NamedFunction): Problem {
  const {pairs: _, ...task} = angles_of(problem);
  return with_other_task(problem, without_foreign_free({...task, function: named}));
}
export function with_free(problem: Problem, free: FreeParameter | null): Problem {
  const {free: _, ...task} = angles_of(problem);
  return with_other_task(problem, free ? {...task, free} : task);
}
/** Five positions leave nothing free. */
function without_foreign_free(task: AngleTask): AngleTask {
  if (!task.free || position_count_of(task) <= 4) return task;
  const {free: _, ...rest} = task;
  return rest;
}
/** A step that says so where it leaves no room for the number that was free. */
export function edit_angles(workbench: Desk, change: (problem: Problem) => Problem, merge: string | null = null): void {
  const had_free = angles_of(workbench.problem).free !== undefined;
  workbench.edit(change, merge);
  if (had_free && !angles_of(workbench.problem).free)
    workbench.say("function.free_dropped", {}, {key: "edit.undo", run: () => workbench.undo()});
}
export function with_pair(
  problem: Problem,
  pairs: readonly AnglePair[],
  index: number,
  change: Partial<AnglePair>,
): Problem {
  return with_pairs(
    problem,
    pairs.map((pair, i) => (i === index ? {...pair, ...change} : pair)),
  );
}
export function with_ground_pivot(
  problem: Problem,
  pivots: {input: Point; output: Point},
  side: Side,
  place: Point,
): Problem {
  return with_task(problem, {...function_of(problem), ground_pivots: {...pivots, [side]: place}});
}

/** Where the output's dial is stretched, what is read off it is the pair's angle stretched. */
export function unstretched(
  own: readonly AnglePair[],
  shown: readonly DegreePair[],
  index: number,
  value: number,
): number {
  const [first] = own,
    pair = own[index],
    as_shown = shown[index];
  if (!first || !pair || !as_shown) return value;
  const travel = as_shown[1] - first.output_deg;
  if (Math.abs(travel) < 1e-9) return value;
  return first.output_deg + ((value - first.output_deg) * (pair.output_deg - first.output_deg)) / travel;
}

// ---- rates --------------------------------------------------------------------------------------------------------

/** dψ/dφ, d²ψ/dφ², … as derivatives by the input angle, as many as are given. */
export function with_rates(pair: AnglePair, rates: readonly number[]): AnglePair {
  const {derivatives: _, ...plain} = pair;
  return rates.length === 0
    ? plain
    : {...plain, derivatives: rates.map((output, order) => ({input: order === 0 ? 1 : 0, output}))};
}
export function rates_of({derivatives = []}: AnglePair): number[] {
  return by_parameter(
    derivatives.map((d) => d.output),
    derivatives.map((d) => d.input),
  );
}

// ---- rows of two numbers -----------------------------------------------------------------------------------------

/** Rows of two numbers from a spreadsheet, a heading left out; nothing where it is something else. */
export function rows_of(text: string): Point[] | null {
  return plain_rows(text) ?? read_rows(text);
}
/** Two numbers without any finesse in each line, as programs write them: 200,000 rows in the blink of an eye. */
function plain_rows(text: string): Point[] | null {
  const row =
    /[ \t]*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)(?:[ \t]*[,;\t][ \t]*|[ \t]+)([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)[ \t]*(?:[\r\n]+|$)/y;
  const rows: Point[] = [];
  while (row.lastIndex < text.length) {
    const found = row.exec(text),
      x = Number(found?.[1]),
      y = Number(found?.[2]);
    if (!found || Math.abs(x) > largest_number || Math.abs(y) > largest_number) return null;
    rows.push([x === 0 ? 0 : x, y === 0 ? 0 : y]);
  }
  return rows.length > 0 ? rows : null;
}
function read_rows(text: string): Point[] | null {
  const rows = cells_of(text).map((cells) => cells.map((cell) => evaluated(cell, "number")));
  const numbers = rows.map((row) => row.flatMap((cell) => ("value" in cell ? [cell.value] : [])));
  if (numbers[0]?.length === 0) numbers.shift();
  return numbers.length > 0 ? read_list(numbers, (row) => (is_pair(row) ? row : null), Infinity) : null;
}
