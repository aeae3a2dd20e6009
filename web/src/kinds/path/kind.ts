// A point of a four-bar's coupler passes places at given angles of the crank.
import type {Problem} from "../../state/problem";
import {is_number, is_object, read_list, type JsonObject} from "../../state/shape";
import {diagonal_of, pattern_of, position_count} from "../../state/task";
import {significant} from "../../texts/numbers";
import {path_making} from "../../analyses/tolerances/making";
import {told_with_point} from "../carried";
import type {TaskKind} from "../kind";
import {planar_objectives, planar_properties, planar_requirements, planar_types} from "../planar";
import {is_path, place_of, type PathPoint, type PathRate, type PathTask} from "./task";

const most_points = 10_000,
  most_rates = 4;

function read_rate(value: unknown): PathRate | null {
  if (!is_object(value) || !is_number(value.x) || !is_number(value.y)) return null;
  const {x, y, input} = value;
  return {x, y, ...(is_number(input) ? {input} : {})};
}
function read_point(value: unknown): PathPoint | null {
  if (!is_object(value) || !is_number(value.x) || !is_number(value.y) || !is_number(value.input_deg)) return null;
  const {x, y, input_deg} = value,
    derivatives = read_list(value.derivatives, read_rate, most_rates);
  return {x, y, input_deg, ...(derivatives?.length ? {derivatives} : {})};
}
function read(value: JsonObject): PathTask | null {
  const points = read_list(value.points, read_point, most_points);
  return value.kind === "path" && value.mechanism === "four_bar" && points
    ? {kind: "path", mechanism: "four_bar", points}
    : null;
}

/** The film claw of the examples: down along the film, and back outside. */
function new_problem(): Problem {
  const task: PathTask = {
    kind: "path",
    mechanism: "four_bar",
    points: [
      {x: 0, y: 95, input_deg: 0},
      {x: 1, y: 32, input_deg: 35},
      {x: 1, y: -33, input_deg: 70},
      {x: 0, y: -95, input_deg: 105},
    ],
  };
  const problem: Problem = {linkwright: 1, title: "", length_unit: "mm", task};
  return {...problem, requirements: {min_transmission_angle_deg: 30, max_length: default_max_length(problem)}};
}
function default_max_length({task}: Problem): number {
  return Number((5 * (diagonal_of((task as PathTask).points.map(place_of)) || 1)).toPrecision(2));
}

const {types, no_defects, min_transmission_angle_deg, max_link_ratio, max_length, min_length} = planar_requirements,
  {ground_pivots_within, moving_pivots_within} = planar_requirements;

export const path_kind: TaskKind<PathTask> = {
  name: "task.kind_path",
  is: is_path,
  read,
  incompleteness({points}) {
    const n = position_count(points);
    if (n < 4) return {state: "too_few", text: "state.too_few_points", n};
    return n > 5 ? {state: "too_many", text: "state.too_many_points", n} : null;
  },
  stops: ({points}) => points.length,
  pattern: ({points}) => pattern_of(points),
  is_mixed: ({points}) => points.some(({derivatives}) => derivatives?.length),
  anchors: ({points}) => points.map(place_of),
  default_max_length,
  map_of: ({points}) => `path ${position_count(points)}`,
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
  table: ({points}, unit) => ({
    head: [`x ${unit}`.trim(), `y ${unit}`.trim(), "φ °"],
    rows: points.map(({x, y, input_deg}) => [x, y, input_deg].map((value) => significant(value, 7))),
  }),
  beginnings: [{id: "path", name: "new.path", about: "new.path_about", make: new_problem}],
  ...told_with_point(({path}) => path ?? null),
  texts: {
    "num.residual": "path.residual",
    "status.residual": "path.status_residual",
    "notice.order_defect": "path.order_defect",
  },
};
