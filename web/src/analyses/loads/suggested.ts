// What loads, a spring, a case begin with: round numbers that the engine takes for this task.
import type {Point} from "../../contract/messages";
import {least_of, most_of} from "../../state/ends";
import {outline_of, placed, round_step, type Problem} from "../../state/problem";
import {diagonal_of, poses_of} from "../../state/task";
import {anchors_of, extent_of} from "../../kinds/kind_dispatch";
import {t} from "../../texts/texts.svelte";
import type {Cylinder} from "../../contract/problem";
import {cases_of, loads_of, type ExtraLoad, type LoadCase, type Loads, type Spring} from "./block";

const usual_mass = 20; // kg

function tidy(value: number): number {
  return Number(value.toPrecision(12)) + 0;
}
function multiple_of(step: number): (value: number) => number {
  return (value) => tidy(Math.round(value / step) * step);
}
/** Corners of the body; none where a point is guided and nothing is drawn about it. */
function corners_of(problem: Problem): readonly Point[] {
  const is_there = (problem.view?.outline?.length ?? 0) >= 3 || poses_of(problem.task).length > 1;
  return is_there ? outline_of(problem) : [];
}
function middle_of(points: readonly Point[]): Point {
  if (points.length === 0) return [0, 0];
  const round = multiple_of(round_step((diagonal_of(points) || 1) / 200)),
    middle = (values: number[]) => round((least_of(values) + most_of(values)) / 2);
  return [middle(points.map(([x]) => x)), middle(points.map(([, y]) => y))];
}
/** As far from the body's origin as it gets. */
function farthest_of(points: readonly Point[]): Point {
  const origin: Point = [0, 0];
  return points.reduce((far, point) => (distance(origin, point) > distance(origin, far) ? point : far), origin);
}
export function suggested_loads(problem: Problem): Loads {
  const corners = corners_of(problem);
  return {
    body: {mass: usual_mass, center: middle_of(corners)},
    handle: {point: farthest_of(corners), direction: "tangential"},
    cases: [{name: t("loads.case_room")}],
  };
}

/** Where a point of the body is in the positions; of a guided point alone only that itself is known. */
function visits_of({task}: Problem, point: Point): readonly Point[] {
  const poses = poses_of(task);
  return poses.length ? poses.map((pose) => placed(point, pose)) : anchors_of(task);
}
/** On the ground, so that the spring gets longer from the first position to the last, by less than it can. */
function ground_stud(visits: readonly Point[], size: number): Point {
  const [x, y] = middle_of(visits),
    round = multiple_of(round_step(size / 100));
  const directions = 24,
    longest_ratio = 1.7;
  let best: {at: Point; gain: number} = {at: [round(x + 2 * size), round(y)], gain: 0};
  for (let k = 0; k < 3 * directions; ++k) {
    const reach = (0.8 + 0.4 * Math.floor(k / directions)) * size,
      angle = (2 * Math.PI * k) / directions;
    const at: Point = [round(x + reach * Math.cos(angle)), round(y + reach * Math.sin(angle))],
      lengths = visits.map((visit) => distance(at, visit));
    const gain = (lengths.at(-1) ?? 0) - (lengths[0] ?? 0);
    if (most_of(lengths) < longest_ratio * least_of(lengths) && gain > best.gain) best = {at, gain};
  }
  return best.at;
}
function distance([x, y]: Point, [to_x, to_y]: Point): number {
  return Math.hypot(to_x - x, to_y - y);
}
interface Placed extends Cylinder {
  /** In the positions. */
  lengths: number[];
  step: number;
}
/** Between the ground and the body's centre, or the guided point. */
function placed_between(problem: Problem): Placed {
  const {body} = loads_of(problem) ?? {},
    size = extent_of(problem.task);
  const to: Point = poses_of(problem.task).length ? (body?.center ?? [0, 0]) : [0, 0],
    visits = visits_of(problem, to),
    from = ground_stud(visits, size);
  return {
    from: {on: "ground", at: from},
    to: {on: "body", at: to},
    lengths: visits.map((visit) => distance(from, visit)),
    step: round_step(size / 100),
  };
}
export function suggested_cylinder(problem: Problem): Cylinder {
  const {from, to} = placed_between(problem);
  return {from, to};
}
export function suggested_spring(problem: Problem, kind: Spring["kind"] = "gas"): Spring {
  const {springs = []} = loads_of(problem) ?? {},
    {from, to, lengths, step} = placed_between(problem);
  const up = (value: number) => tidy(Math.ceil(value / step) * step),
    extended_length = up(most_of(lengths) + 2 * step);
  const name = unused_name(
    springs.map(({name = ""}) => name),
    t("loads.spring"),
  );
  switch (kind) {
    case "gas":
      return {
        kind,
        name,
        count: 1,
        from,
        to,
        extended_length,
        stroke: up(extended_length - least_of(lengths) + 2 * step),
        measured_at: tidy(step / 2),
        F1: 200,
        F2: 260,
        friction: 20,
      };
    case "coil": // pulls, or pushes with about 100 N where it is shortest
      return {
        kind,
        name,
        from,
        to,
        rate: round_step(100 / (extended_length - least_of(lengths) || extended_length)),
        free_length: extended_length,
      };
    case "torsion":
      return {kind, name, joint: "input_ground", rate_per_deg: 0.1, torque_at_position_1: 0};
  }
}
export function suggested_extra({extra = [], body}: Loads, by: "mass" | "force"): ExtraLoad {
  const name = unused_name(
      extra.map((one) => one.name),
      t(`loads.extra_${by}`),
    ),
    placed = {name, on: "body", at: body?.center ?? [0, 0], always: true} as const;
  return by === "mass" ? {...placed, mass: 1} : {...placed, force: [0, -10]};
}
export function suggested_case(loads: Loads): LoadCase {
  const names = cases_of(loads).map(({name}) => name),
    [cold, hot] = [t("loads.case_cold"), t("loads.case_hot")];
  if (!names.includes(cold)) return {name: cold, temperature_C: -30};
  if (!names.includes(hot)) return {name: hot, temperature_C: 80};
  return {name: unused_name(names, t("loads.case"))};
}
function unused_name(names: readonly string[], begin: string): string {
  if (!names.includes(begin)) return begin;
  let n = 2;
  while (names.includes(`${begin} ${n}`)) ++n;
  return `${begin} ${n}`;
}
