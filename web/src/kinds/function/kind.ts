// The output link of a four-bar turns with its input link as prescribed: by pairs of angles, or by a function.
import type {Point} from "../../contract/messages";
import type {Problem} from "../../state/problem";
import {is_number, is_object, is_pair, present, read_list, type JsonObject} from "../../state/shape";
import {diagonal_of, pattern_of, position_count, type Interval} from "../../state/task";
import {
  is_function,
  type AnglePair,
  type AngleTask,
  type FreeParameter,
  type FunctionTask,
  type NamedFunction,
} from "./task";
import {significant} from "../../texts/numbers";
import type {ObjectiveDescription, PropertyDescription, TaskKind} from "../kind";
import {planar_objectives, planar_properties, planar_requirements, planar_types} from "../planar";
import {angle_making} from "../../analyses/tolerances/making";
import {defaults} from "../../state/defaults";

const most_pairs = 10_000;

function read_pair(value: unknown): AnglePair | null {
  if (!is_object(value) || !is_number(value.input_deg) || !is_number(value.output_deg)) return null;
  const {input_deg, output_deg} = value;
  const rates = (item: unknown) =>
    is_object(item) && is_number(item.input) && is_number(item.output)
      ? {input: item.input, output: item.output}
      : null;
  const derivatives = read_list(value.derivatives, rates, 4);
  return {input_deg, output_deg, ...(derivatives?.length ? {derivatives} : {})};
}
function read_range(value: unknown): Interval | null {
  return is_pair(value) ? value : null;
}
function read_function(value: unknown): NamedFunction | null {
  if (!is_object(value)) return null;
  const input_range_deg = read_range(value.input_range_deg),
    output_range_deg = read_range(value.output_range_deg);
  if (!input_range_deg || !output_range_deg) return null;
  const {interpolation, spacing} = value;
  return {
    input_range_deg,
    output_range_deg,
    ...present({
      expression: typeof value.expression === "string" ? value.expression : null,
      table: read_list(value.table, read_range, Infinity),
      x: read_range(value.x),
      y: read_range(value.y),
      interpolation: interpolation === "linear" || interpolation === "monotone_cubic" ? interpolation : null,
      points: is_number(value.points) ? value.points : null,
      spacing:
        spacing === "chebyshev" || spacing === "even"
          ? spacing
          : read_list(spacing, (x) => (is_number(x) ? x : null), 5),
    }),
  } as NamedFunction;
}
function read_free(value: unknown): FreeParameter | null {
  if (!is_object(value) || (value.number !== "output_scale" && value.number !== "pair_output")) return null;
  return {
    number: value.number,
    ...present({pair: is_number(value.pair) ? value.pair : null, range: read_range(value.range)}),
  } as FreeParameter;
}
/** What is prescribed; nothing where it is neither pairs nor a function. */
export function read_angles(value: JsonObject): Pick<AngleTask, "pairs" | "function" | "free"> | null {
  const pairs = read_list(value.pairs, read_pair, most_pairs),
    of = read_function(value.function);
  return pairs || of ? present({pairs: of ? null : pairs, function: of, free: read_free(value.free)}) : null;
}
function read(value: JsonObject): FunctionTask | null {
  const angles = read_angles(value),
    pivots = value.ground_pivots;
  if (value.kind !== "function" || value.mechanism !== "four_bar" || !angles) return null;
  const ground_pivots =
    is_object(pivots) && is_pair(pivots.input) && is_pair(pivots.output)
      ? {input: pivots.input, output: pivots.output}
      : null;
  return {kind: "function", mechanism: "four_bar", ...angles, ...present({ground_pivots})};
}

export function ground_pivots_of({ground_pivots}: FunctionTask): {input: Point; output: Point} {
  return ground_pivots ?? {input: [0, 0], output: [1, 0]};
}
export function position_count_of(task: AngleTask): number {
  return task.function ? (task.function.points ?? defaults.function.points) : position_count(task.pairs ?? []);
}
/** A table's own where none is given. */
export function x_range_of({x, table}: NamedFunction): Interval | undefined {
  if (x || !table) return x;
  const first = table[0],
    last = table.at(-1);
  return first && last && [first[0], last[0]];
}
/** A square over the angles of the pairs. */
export function fresh_function(pairs: readonly AnglePair[]): NamedFunction {
  const range = (key: "input_deg" | "output_deg"): Interval => [
    pairs[0]?.[key] ?? 0,
    (pairs.length > 1 ? pairs.at(-1)?.[key] : null) ?? 60,
  ];
  return {
    expression: "x^2",
    x: [0, 1],
    input_range_deg: range("input_deg"),
    output_range_deg: range("output_deg"),
    points: Math.min(Math.max(pairs.length, 4), 5),
    spacing: "chebyshev",
  };
}
function default_max_length({task}: Problem): number {
  const {input, output} = ground_pivots_of(task as FunctionTask);
  return Number((5 * Math.hypot(output[0] - input[0], output[1] - input[1])).toPrecision(2));
}
function new_problem(): Problem {
  const task: FunctionTask = {
    kind: "function",
    mechanism: "four_bar",
    pairs: [
      {input_deg: 0, output_deg: 0},
      {input_deg: 20, output_deg: 12},
      {input_deg: 40, output_deg: 31},
      {input_deg: 60, output_deg: 60},
    ],
    ground_pivots: {input: [0, 0], output: [100, 0]},
  };
  const problem: Problem = {linkwright: 1, title: "", length_unit: "mm", task};
  return {...problem, requirements: {min_transmission_angle_deg: 30, max_length: default_max_length(problem)}};
}

/** What every kind has whose tasks prescribe angles. */
export const angles_kind = {
  incompleteness(task) {
    const n = position_count_of(task);
    if (n < 4) return {state: "too_few", text: "state.too_few_pairs", n};
    return n > 5 ? {state: "too_many", text: "state.too_many_pairs", n} : null;
  },
  stops: (task) => task.pairs?.length ?? position_count_of(task),
  pattern: (task) => pattern_of(task.pairs ?? Array.from({length: position_count_of(task)}, () => ({}))),
  is_mixed: ({pairs}) => (pairs ?? []).some((pair) => pair.derivatives?.length),
  table({pairs, function: named}) {
    if (!named)
      return {
        head: ["φ °", "ψ °"],
        rows: (pairs ?? []).map((pair) => [significant(pair.input_deg, 7), significant(pair.output_deg, 7)]),
      };
    const range = (ends: Interval | undefined) => ends?.map((end) => significant(end, 7)).join(" … ") ?? "";
    return {
      head: ["y", "x", "φ °", "ψ °"],
      rows: [
        [
          named.expression ?? "y(x)",
          range(x_range_of(named)),
          range(named.input_range_deg),
          range(named.output_range_deg),
        ],
      ],
    };
  },
  texts: {
    "num.residual": "function.residual",
    "status.residual": "function.status_residual",
    "notice.branch_defect": "function.branch_defect",
    "notice.change_point_defect": "function.change_point_defect",
    "notice.circuit_defect": "function.circuit_defect",
    "notice.direction_defect": "function.direction_defect",
    "notice.order_defect": "function.order_defect",
    "state.none_defect_free": "function.none_defect_free",
    "notice.every_point": "function.every_point",
    "notice.dependent_rows": "function.dependent_rows",
    "notice.ill_conditioned": "function.ill_conditioned",
  },
} satisfies Partial<TaskKind<AngleTask>>;
export const max_structural_error_deg: PropertyDescription<AngleTask> = {
  is_of: ({function: named, free}) => named !== undefined && !free,
  text: "function.max_error",
  short: "function.error",
  term: "structural_error",
  larger_is_better: false,
  requirement: null,
  quantity: "fine_angle",
  span: () => [0, 2],
  levels: () => [0.1, 0.2, 0.5, 1],
};
export const structural_error: ObjectiveDescription<AngleTask> = {
  name: "req.objective.structural_error",
  measure: "max_structural_error_deg",
  is_of: ({function: named}) => named !== undefined,
};

export const function_kind: TaskKind<FunctionTask> = {
  name: "task.kind_function",
  ...angles_kind,
  is: is_function,
  read,
  anchors: (task) => Object.values(ground_pivots_of(task)),
  around(task) {
    const pivots = Object.values(ground_pivots_of(task)),
      room = 0.5 * diagonal_of(pivots);
    return pivots.flatMap(([x, y]): Point[] => [
      [x - room, y],
      [x + room, y],
      [x, y - room],
      [x, y + room],
    ]);
  },
  default_max_length,
  map_of: (task) => `function ${position_count_of(task)} ${task.free?.number ?? ""}`,
  moved: (task, point) => ({
    ...task,
    ground_pivots: {input: point(ground_pivots_of(task).input), output: point(ground_pivots_of(task).output)},
  }),
  properties: {
    ...planar_properties,
    max_structural_error_deg,
  },
  types: planar_types,
  requirements: planar_requirements,
  objectives: {
    structural_error,
    ...planar_objectives,
  },
  analysed: {tolerances: angle_making},
  beginnings: [{id: "function", name: "new.function", about: "new.function_about", make: new_problem}],
};
