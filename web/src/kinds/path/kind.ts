// A point of a four-bar's coupler passes places, at given angles of the crank or about given ground pivots.
import type {Point, Requirements, Side} from "../../contract/messages";
import type {Problem} from "../../state/problem";
import {is_number, is_object, is_pair, read_list, type JsonObject} from "../../state/shape";
import {diagonal_of, pattern_of, position_count} from "../../state/task";
import {significant} from "../../texts/numbers";
import {path_making} from "../../analyses/tolerances/making";
import {told_with_point} from "../carried";
import type {Incomplete, TaskKind} from "../kind";
import {planar_objectives, planar_properties, planar_requirements, planar_types} from "../planar";
import {counts, form_of, given_sides, is_path, pivots_of, place_of} from "./task";
import type {GroundPivots, PathPoint, PathRate, PathTask} from "./task";

const most_points = 10_000,
  most_rates = 4;

function read_rate(value: unknown): PathRate | null {
  if (!is_object(value) || !is_number(value.x) || !is_number(value.y)) return null;
  const {x, y, input} = value;
  return {x, y, ...(is_number(input) ? {input} : {})};
}
function read_point(value: unknown): PathPoint | null {
  if (!is_object(value) || !is_number(value.x) || !is_number(value.y)) return null;
  const {x, y, input_deg} = value,
    derivatives = read_list(value.derivatives, read_rate, most_rates);
  if (input_deg !== undefined && !is_number(input_deg)) return null;
  return {
    x,
    y,
    ...(input_deg === undefined ? {} : {input_deg}),
    ...(derivatives?.length ? {derivatives} : {}),
  };
}
function read_pivots(value: unknown): GroundPivots | null {
  const of = is_object(value) && is_object(value.ground_pivots) ? value.ground_pivots : {};
  const pivots: GroundPivots = {
    ...(is_pair(of.input) ? {input: of.input} : {}),
    ...(is_pair(of.output) ? {output: of.output} : {}),
  };
  return Object.keys(pivots).length ? pivots : null;
}
function read(value: JsonObject): PathTask | null {
  const points = read_list(value.points, read_point, most_points),
    ground_pivots = read_pivots(value.given);
  return value.kind === "path" && value.mechanism === "four_bar" && points
    ? {kind: "path", mechanism: "four_bar", points, ...(ground_pivots ? {given: {ground_pivots}} : {})}
    : null;
}

function new_problem(beside: Pick<PathTask, "points" | "given">, wanted: Requirements): Problem {
  const problem: Problem = {
    linkwright: 1,
    title: "",
    length_unit: "mm",
    task: {kind: "path", mechanism: "four_bar", ...beside} as PathTask,
  };
  return {...problem, requirements: {...wanted, max_length: default_max_length(problem)}};
}
/** The film claw of the examples: down along the film, and back outside. */
function film_claw(): Problem {
  const points = [
    {x: 0, y: 95, input_deg: 0},
    {x: 1, y: 32, input_deg: 35},
    {x: 1, y: -33, input_deg: 70},
    {x: 0, y: -95, input_deg: 105},
  ];
  return new_problem({points}, {min_transmission_angle_deg: 30});
}
/** Round a bowl, the crank's pivot on the machine's column. */
function mixer_blade(): Problem {
  const points = [
    {x: 0, y: 0},
    {x: 95, y: 40},
    {x: 150, y: 140},
    {x: 60, y: 230},
    {x: -70, y: 190},
  ];
  const given = {ground_pivots: {input: [40, 90] as const}};
  return new_problem({points, given}, {full_turn: true, min_transmission_angle_deg: 25});
}
function anchors(task: PathTask): Point[] {
  return [...task.points.map(place_of), ...Object.values(pivots_of(task))];
}
function default_max_length({task}: Problem): number {
  return Number((5 * (diagonal_of(anchors(task as PathTask)) || 1)).toPrecision(2));
}
/** What the engine is not asked for is said by what is given: how many points there are, or how many are missing or too many. */
function incompleteness(task: PathTask): Incomplete | null {
  const n = position_count(task.points),
    form = form_of(task),
    [fewest, most] = counts[form];
  if (n >= fewest && n <= most) return null;
  const state = n < fewest ? "too_few" : "too_many";
  return form === "angles"
    ? {state, text: `state.${state}_points`, n}
    : {state, text: `state.${state}_points_${form}`, n: Math.abs(n - fewest)};
}
function moved_pivots(task: PathTask, point: (p: Point) => Point): Pick<PathTask, "given"> {
  if (!task.given) return {};
  const pivots = Object.entries(pivots_of(task)).map(([side, at]) => [side as Side, point(at)]);
  return {given: {ground_pivots: Object.fromEntries(pivots) as GroundPivots}};
}
function table(task: PathTask, unit: string): {head: string[]; rows: string[][]} {
  const head = [`x ${unit}`.trim(), `y ${unit}`.trim()],
    written = (values: readonly number[]) => values.map((value) => significant(value, 7));
  if (task.given) return {head, rows: task.points.map(({x, y}) => written([x, y]))};
  return {head: [...head, "φ °"], rows: task.points.map(({x, y, input_deg = NaN}) => written([x, y, input_deg]))};
}

const {types, no_defects, min_transmission_angle_deg, max_link_ratio, max_length, min_length} = planar_requirements,
  {ground_pivots_within, moving_pivots_within} = planar_requirements;

export const path_kind: TaskKind<PathTask> = {
  name: "task.kind_path",
  is: is_path,
  read,
  incompleteness,
  stops: ({points}) => points.length,
  pattern: ({points}) => pattern_of(points),
  is_mixed: ({points}) => points.some(({derivatives}) => derivatives?.length),
  anchors,
  default_max_length,
  map_of: (task) => ["path", position_count(task.points), ...given_sides(task)].join(" "),
  properties: planar_properties,
  types: planar_types,
  requirements: {
    types,
    no_defects,
    min_transmission_angle_deg,
    max_link_ratio,
    max_length,
    min_length,
    ground_pivots_within,
    moving_pivots_within,
    full_turn: {
      name: "req.full_turn",
      short: "req.short.full_turn",
      term: null,
      control: "own",
      is_value: (value) => typeof value === "boolean",
    },
  },
  objectives: planar_objectives,
  analysed: {tolerances: path_making},
  moved: (task, point) => ({
    ...task,
    ...moved_pivots(task, point),
    points: task.points.map((one) => {
      const [x, y] = point(place_of(one)),
        [x0, y0] = point([0, 0]);
      // A derivative is a difference of places.
      const derivatives = one.derivatives?.map((rate) => {
        const [dx, dy] = point([rate.x, rate.y]);
        return {...rate, x: dx - x0, y: dy - y0};
      });
      return {...one, x, y, ...(derivatives ? {derivatives} : {})};
    }),
  }),
  table,
  beginnings: [
    {id: "path", name: "new.path", about: "new.path_about", make: film_claw},
    {id: "path_pivot", name: "new.path_pivot", about: "new.path_pivot_about", make: mixer_blade},
  ],
  ...told_with_point(({path}) => path ?? null),
  texts: {
    "num.residual": "path.residual",
    "status.residual": "path.status_residual",
    "notice.order_defect": "path.order_defect",
  },
};
