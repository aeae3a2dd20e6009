// A point of a four-bar's coupler passes places, at given angles of the crank or about given ground pivots.
import type {Point, Requirements, Side} from "../../contract/messages";
import {length_levels, type Problem} from "../../state/problem";
import {is_number, is_object, is_pair, read_list, type JsonObject} from "../../state/shape";
import {diagonal_of, pattern_of} from "../../state/task";
import {significant} from "../../texts/numbers";
import {four_bar_loading} from "../../analyses/loads/making";
import {path_making} from "../../analyses/tolerances/making";
import {told_with_point} from "../carried";
import type {TaskKind} from "../kind";
import {planar_objectives, planar_properties, planar_requirements, planar_types} from "../planar";
import {layer_at} from "./layers";
import {incompleteness} from "./missing";
import {path_map_of, with_quick_fit} from "./near";
import {
  angle_counts,
  angle_key,
  angle_of,
  angle_signs,
  given_sides,
  is_near,
  is_path,
  pivots_of,
  place_of,
} from "./task";
import type {GroundPivots, PathPoint, PathRate, PathTask} from "./task";

const most_points = 10_000,
  most_rates = 4;
const most_positions = 5, // of a path that passes near its points the drive stops at some
  usual_error = 0.02; // of its size
/** mm. */
const bean_outline: readonly Point[] = [
  [-1, 64],
  [28, 74],
  [62, 77],
  [98, 70],
  [125, 51],
  [135, 22],
  [129, -8],
  [106, -26],
  [80, -17],
  [54, -9],
  [27, -3],
  [-2, 1],
  [-27, 5],
  [-44, 18],
  [-36, 37],
  [-21, 51],
];

function read_rate(value: unknown): PathRate | null {
  if (!is_object(value) || !is_number(value.x) || !is_number(value.y)) return null;
  const {x, y, input, theta} = value;
  return {x, y, ...(is_number(input) ? {input} : {}), ...(is_number(theta) ? {theta} : {})};
}
function read_point(value: unknown): PathPoint | null {
  if (!is_object(value) || !is_number(value.x) || !is_number(value.y)) return null;
  const {x, y, input_deg, theta_deg, tolerance, weight} = value,
    derivatives = read_list(value.derivatives, read_rate, most_rates);
  if (input_deg !== undefined && !is_number(input_deg)) return null;
  if (theta_deg !== undefined && !is_number(theta_deg)) return null;
  return {
    x,
    y,
    ...(input_deg === undefined ? {} : {input_deg}),
    ...(theta_deg === undefined ? {} : {theta_deg}),
    ...(derivatives?.length ? {derivatives} : {}),
    ...(is_number(tolerance) ? {tolerance} : {}),
    ...(is_number(weight) ? {weight} : {}),
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
    ground_pivots = read_pivots(value.given),
    {closed, tolerance, between, map} = value;
  if (value.kind !== "path" || value.mechanism !== "four_bar" || !points) return null;
  return {
    kind: "path",
    mechanism: "four_bar",
    points,
    ...(ground_pivots ? {given: {ground_pivots}} : {}),
    ...(typeof closed === "boolean" ? {closed} : {}),
    ...(between === "free" || between === "polyline" ? {between} : {}),
    ...(is_number(tolerance) ? {tolerance} : {}),
    ...(map === "curves" || map === "pivots" ? {map} : {}),
  };
}

function new_problem(beside: Pick<PathTask, "points" | "given" | "closed">, wanted: Requirements): Problem {
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
/** A gripper swings a part over, and past two places that it must clear. */
function feeder(): Problem {
  const points = [
    {x: 0, y: 0, theta_deg: 0},
    {x: 120, y: 60, theta_deg: -25},
    {x: 230, y: 40, theta_deg: -60},
    {x: 60, y: 150},
    {x: 260, y: 160},
  ];
  const problem = new_problem({points}, {min_transmission_angle_deg: 10});
  return {...problem, requirements: {...problem.requirements, max_length: 700}};
}
/** A foot strikes, pushes off and is lifted, its leg on a frame. */
function walking_leg(): Problem {
  const points = [
    {x: -94, y: -27},
    {x: -117, y: -102},
    {x: -89, y: -173},
    {x: -64, y: -185},
    {x: -59, y: -155},
  ];
  const given = {ground_pivots: {input: [0, 0] as const, output: [190, -66] as const}};
  return new_problem({points, given}, {full_turn: true, min_transmission_angle_deg: 30});
}
/** As one draws it by hand: round, with a dent. */
function bean(): Problem {
  const points = bean_outline.map(([x, y]) => ({x, y}));
  return new_problem({points, closed: true}, {min_transmission_angle_deg: 20});
}
function anchors(task: PathTask): Point[] {
  return [...task.points.map(place_of), ...Object.values(pivots_of(task))];
}
function default_max_length({task}: Problem): number {
  return Number((5 * (diagonal_of(anchors(task as PathTask)) || 1)).toPrecision(2));
}
function moved_pivots(task: PathTask, point: (p: Point) => Point): Pick<PathTask, "given"> {
  if (!task.given) return {};
  const pivots = Object.entries(pivots_of(task)).map(([side, at]) => [side as Side, point(at)]);
  return {given: {ground_pivots: Object.fromEntries(pivots) as GroundPivots}};
}
function table(task: PathTask, unit: string): {head: string[]; rows: string[][]} {
  const key = angle_key(task),
    written = (value: number | null) => (value === null ? "" : significant(value, 7));
  return {
    head: [`x ${unit}`.trim(), `y ${unit}`.trim(), ...(key ? [`${angle_signs[key]} °`] : [])],
    rows: task.points.map((point) => [point.x, point.y, ...(key ? [angle_of(point)] : [])].map(written)),
  };
}
/** The forms of the engine's maps: the nearest paths, or how many positions have angles, of which link, and which pivots are given. */
function map_of(task: PathTask): string {
  if (is_near(task)) return ["path near", path_map_of(task), ...given_sides(task)].join(" ");
  const {angled, plain} = angle_counts(task);
  return ["path", angled, plain, angle_key(task) ?? "", ...given_sides(task)].join(" ");
}

const {types, no_defects, min_transmission_angle_deg, max_link_ratio, max_length, min_length} = planar_requirements,
  {ground_pivots_within, moving_pivots_within} = planar_requirements;

export const path_kind: TaskKind<PathTask> = {
  name: "task.kind_path",
  is: is_path,
  read,
  incompleteness,
  stops: (task) => (is_near(task) ? Math.min(task.points.length, most_positions) : task.points.length),
  pattern: (task) => (is_near(task) ? "" : pattern_of(task.points)), // it counts positions that are passed
  is_mixed: ({points}) => points.some(({derivatives}) => derivatives?.length),
  anchors,
  default_max_length,
  map_of,
  properties: {
    path_error: {
      is_of: is_near,
      text: "region.by_path_error",
      short: "region.short_path_error",
      term: null,
      larger_is_better: false,
      requirement: "max_path_error",
      quantity: "length",
      span: (_, typical) => [0, usual_error * typical],
      levels: length_levels,
    },
    ...planar_properties,
  },
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
    max_path_error: {
      is_of: (task) => is_path(task) && is_near(task),
      name: "req.max_path_error",
      short: "req.short.max_path_error",
      control: "limit",
      bound: "most",
      term: null,
      quantity: "length",
      from: 0,
    },
    full_turn: {
      name: "req.full_turn",
      short: "req.short.full_turn",
      term: null,
      control: "own",
      is_value: (value) => typeof value === "boolean",
    },
  },
  objectives: {
    path_error: {name: "req.objective.path_error", measure: "path_error", is_of: is_near},
    ...planar_objectives,
  },
  default_objective: (task) => (is_near(task) ? "path_error" : "min_transmission_angle"),
  hurried: with_quick_fit,
  analysed: {tolerances: path_making, loads: four_bar_loading},
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
    {id: "path_poses", name: "new.path_poses", about: "new.path_poses_about", make: feeder},
    {id: "path_pivots", name: "new.path_pivots", about: "new.path_pivots_about", make: walking_leg},
    {id: "path_near", name: "new.path_near", about: "new.path_near_about", make: bean},
  ],
  ...told_with_point(({path}) => path ?? null),
  at_place: ({path, tau}) =>
    path?.layers?.length ? {all: path.layers.map((layer) => layer.tau), at: layer_at(path.layers, tau)} : null,
  texts: {
    "num.residual": "path.residual",
    "status.residual": "path.status_residual",
    "notice.order_defect": "path.order_defect",
  },
};
