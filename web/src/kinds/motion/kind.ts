// A body is guided through three, four or five positions by a four-bar.
import type {Point} from "../../contract/messages";
import {length_levels, outline_of, placed, with_requirements, type Problem} from "../../state/problem";
import {is_number, is_object, is_pair, present, read_list, type JsonObject} from "../../state/shape";
import {diagonal_of, pattern_of, poses_of, position_count, served_poses, type Pose} from "../../state/task";
import {exact_poses, fitting_options, has_near, is_fitted, is_motion, type Given, type MotionTask} from "./task";
import {significant} from "../../texts/numbers";
import type {Beginning, TaskKind} from "../kind";
import {planar_objectives, planar_properties, planar_requirements, planar_types} from "../planar";
import {four_bar_loading} from "../../analyses/loads/making";
import {body_making} from "../../analyses/tolerances/making";
import {form_of} from "./given";
import {lines_of, moved_given, pivots_of, read_lines, read_pivot_on, read_pivots, turned_line} from "./pivots";

const most_poses = 10_000; // the engine takes five; what was typed is kept until it is set right

/** How near, as a file says it. */
function read_nearness({tolerance, weight}: JsonObject): Pick<Pose, "tolerance" | "weight"> {
  const given = is_object(tolerance) ? tolerance : {},
    number_or_null = (one: unknown) => (is_number(one) ? one : null),
    known = present({position: number_or_null(given.position), angle_deg: number_or_null(given.angle_deg)});
  return present({tolerance: Object.keys(known).length ? known : null, weight: number_or_null(weight)});
}
export function read_pose(value: unknown): Pose | null {
  if (!is_object(value) || !is_number(value.x) || !is_number(value.y) || !is_number(value.theta_deg)) return null;
  const {x, y, theta_deg, derivatives} = value;
  if (value.near === true) return {x, y, theta_deg, near: true, ...read_nearness(value)};
  const known = Array.isArray(derivatives)
    ? derivatives.filter(
        (d): d is {x: number; y: number; theta: number} =>
          is_object(d) && is_number(d.x) && is_number(d.y) && is_number(d.theta),
      )
    : [];
  return known.length
    ? {x, y, theta_deg, derivatives: known.map((d) => ({x: d.x, y: d.y, theta: d.theta}))}
    : {x, y, theta_deg};
}
export function read_poses(value: unknown): Pose[] | null {
  return read_list(value, read_pose, most_poses);
}
function read_given(value: unknown): Given | null {
  if (!is_object(value)) return null;
  if (is_pair(value.side_lengths)) return {side_lengths: value.side_lengths};
  if (is_number(value.side_length)) return {side_length: value.side_length};
  if (is_number(value.side_angle_deg)) {
    const directed = typeof value.directed === "boolean" ? value.directed : null;
    return {
      side_angle_deg: value.side_angle_deg,
      ...present({directed, input_length: is_number(value.input_length) ? value.input_length : null}),
    };
  }
  if (is_pair(value.instant_center))
    return {instant_center: value.instant_center, ...(value.at_infinity === true ? {at_infinity: true} : {})};
  return read_pivots(value) ?? read_lines(value);
}
function read(value: JsonObject): MotionTask | null {
  const poses = read_poses(value.poses);
  if (value.kind !== "motion" || value.mechanism !== "four_bar" || !poses) return null;
  const freed_pose = Number.isInteger(value.freed_pose) ? (value.freed_pose as number) : null;
  const turning_length = is_number(value.turning_length) ? value.turning_length : null,
    beside = {given: read_given(value.given), pivot_on: read_pivot_on(value.pivot_on), freed_pose, turning_length};
  return {kind: "motion", mechanism: "four_bar", poses, ...present(beside)};
}

/** What is given beside the poses belongs to three positions, a freed pose to five. */
function with_poses(task: MotionTask, poses: readonly Pose[]): MotionTask {
  const changed = {...task, poses},
    count = position_count(exact_poses(changed));
  if (!has_near(changed)) delete changed.turning_length;
  if (count !== 3) delete changed.given;
  if (count !== 4) delete changed.pivot_on;
  if (count !== 5 || poses[(changed.freed_pose ?? 1) - 1]?.derivatives?.length) delete changed.freed_pose;
  return changed;
}

/** What the axes of the map are over. */
function map_of_given(given: Given): string {
  const of = Object.entries(pivots_of(given) ?? {}).map(([side, {kind}]) => side + kind);
  return [
    form_of(given),
    "directed" in given ? String(given.directed) : "",
    ...of,
    ...Object.keys(lines_of(given) ?? {}),
  ].join(" ");
}

function motion_task(poses: readonly Pose[], given?: Given): MotionTask {
  return {kind: "motion", mechanism: "four_bar", poses, ...(given ? {given} : {})};
}
function motion_problem(poses: readonly Pose[], given?: Given): Problem {
  const problem: Problem = {linkwright: 1, title: "", length_unit: "mm", task: motion_task(poses, given)};
  return with_requirements(problem, {min_transmission_angle_deg: 30, max_length: default_max_length(problem)});
}
export function default_max_length(problem: Problem): number {
  const points = poses_of(problem.task).flatMap((pose) => outline_of(problem).map((p) => placed(p, pose)));
  return Number((3 * diagonal_of(points)).toPrecision(2));
}

const some_poses = [
  {x: 0, y: 0, theta_deg: 0},
  {x: -60, y: 80, theta_deg: 20},
  {x: -80, y: 190, theta_deg: 50},
  {x: -40, y: 300, theta_deg: 85},
] as const;
/** The best known: four positions. */
export function new_problem(): Problem {
  return motion_problem(some_poses);
}
const through = (count: number) => ({count, task: (poses: readonly Pose[]) => motion_task(poses)});
const beginnings: Beginning[] = [
  {
    id: "four_positions",
    name: "new.four_positions",
    about: "new.four_positions_about",
    make: new_problem,
    through: through(4),
  },
  {
    id: "three_positions",
    name: "new.three_positions",
    about: "new.three_positions_about",
    make: () => motion_problem([some_poses[0], some_poses[1], some_poses[3]], {side_lengths: [200, 250]}),
    through: through(3), // what is given beside them is chosen then
  },
  {
    id: "five_positions",
    name: "new.five_positions",
    about: "new.five_positions_about",
    make: () => motion_problem(five_poses),
    through: through(5),
  },
];
/** On a crank-rocker's way, in whole numbers. */
const five_poses: Pose[] = [
  {x: 0, y: 0, theta_deg: 0},
  {x: -43, y: 36, theta_deg: 8},
  {x: -74, y: 138, theta_deg: 36},
  {x: -78, y: 238, theta_deg: 63},
  {x: -40, y: 300, theta_deg: 85},
];

/** Positions that the engine tells of a linkage that was fitted. */
const most_stops = 5,
  /** Of a length typical of the task, where the colours of an error end. */
  usual_error = 0.2;

function map_of_exact(task: MotionTask): string {
  const {given, pivot_on, freed_pose} = task,
    count = freed_pose === undefined ? position_count(exact_poses(task)) : "freed";
  return `motion ${count} ${given ? map_of_given(given) : ""}${(pivot_on ?? []).map(({which}) => which).join()}`;
}

export const motion_kind: TaskKind<MotionTask> = {
  name: "task.kind_motion",
  is: is_motion,
  read,
  of_poses: (poses) => read({kind: "motion", mechanism: "four_bar", poses}),
  with_poses,
  fitting: fitting_options,
  incompleteness(task) {
    const {given} = task,
      n = position_count(exact_poses(task)),
      all = task.poses.length;
    if (n <= 5 && has_near(task)) return all < 3 ? {state: "too_few", text: "state.too_few", n: all} : null;
    if (n === 0) return {state: "empty", text: "state.empty_task", n};
    if (n < 3) return {state: "too_few", text: "state.too_few", n};
    if (n > 5) return {state: "too_many", text: "state.too_many", n};
    return n === 3 && !given ? {state: "no_given", text: "state.no_given", n} : null;
  },
  stops: (task) =>
    is_fitted(task)
      ? Math.min(task.poses.length, most_stops)
      : served_poses({...task, poses: exact_poses(task)}).length,
  pattern: (task) => pattern_of(exact_poses(task)), // it counts positions that are passed
  is_mixed: ({poses}) => poses.some((pose) => pose.derivatives?.length),
  anchors: ({poses}) => poses.map((pose): Point => [pose.x, pose.y]),
  default_max_length,
  map_of: (task) => (is_fitted(task) ? "motion near" : map_of_exact(task)),
  properties: {
    near_error: {
      is_of: has_near,
      text: "region.by_near_error",
      short: "region.short_near_error",
      term: null,
      larger_is_better: false,
      requirement: "max_near_error",
      quantity: "length",
      span: (_, typical) => [0, usual_error * typical],
      levels: length_levels,
    },
    ...planar_properties,
    pose_miss: {
      is_of: ({freed_pose}) => freed_pose !== undefined,
      text: "region.by_miss",
      short: "region.by_miss",
      term: "missed_pose",
      larger_is_better: false,
      requirement: null,
      quantity: "length",
      of_meeting: true,
      span: (_, typical) => [0, usual_error * typical],
      levels: length_levels,
    },
  },
  types: planar_types,
  requirements: {
    ...planar_requirements,
    max_near_error: {
      is_of: (task) => is_motion(task) && has_near(task),
      name: "req.max_near_error",
      short: "req.short.max_near_error",
      control: "limit",
      bound: "most",
      term: null,
      quantity: "length",
      from: 0,
    },
  },
  objectives: {
    near_error: {name: "req.objective.near_error", measure: "near_error", is_of: has_near},
    ...planar_objectives,
  },
  default_objective: (task) => (has_near(task) ? "near_error" : "min_transmission_angle"),
  analysed: {tolerances: body_making, loads: four_bar_loading},
  moved: (task, point) => ({
    ...task,
    ...(task.given ? {given: moved_given(task.given, point)} : {}),
    ...(task.pivot_on ? {pivot_on: task.pivot_on.map((on) => ({...on, line: turned_line(on.line, point)}))} : {}),
  }),
  table: ({poses}, unit) => pose_table(poses, unit),
  beginnings,
};

export function pose_table(poses: readonly Pose[], unit: string): {head: string[]; rows: string[][]} {
  const with_unit = (name: string) => (unit ? `${name} ${unit}` : name);
  return {
    head: [with_unit("x"), with_unit("y"), "θ °"],
    rows: poses.map(({x, y, theta_deg}) => [x, y, theta_deg].map((value) => significant(value, 7))),
  };
}
