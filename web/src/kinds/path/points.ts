// The points of a path task and what is given beside them, as they are edited.
import type {Linkage, Point, Side, TauPair} from "../../contract/messages";
import {round_step, with_task, type Problem} from "../../state/problem";
import {diagonal_of, position_count} from "../../state/task";
import {multiple} from "../../drawing/snapping";
import {without_unmet} from "../kind_dispatch";
import {counts, form_of, given_sides, is_path, pivots_of, place_of} from "./task";
import type {GroundPivots, PathForm, PathPoint, PathRate, PathTask} from "./task";

export function path_task({task}: Problem): PathTask | null {
  return is_path(task) ? task : null;
}
export function points_of(problem: Problem): readonly PathPoint[] {
  return path_task(problem)?.points ?? [];
}
function changed(problem: Problem, change: (task: PathTask) => PathTask): Problem {
  const task = path_task(problem);
  return task ? without_unmet(with_task(problem, change(task))) : problem;
}
export function with_points(problem: Problem, change: (points: readonly PathPoint[]) => readonly PathPoint[]): Problem {
  return changed(problem, (task) => ({...task, points: change(task.points)}));
}
export function with_point(problem: Problem, index: number, change: Partial<PathPoint>): Problem {
  return with_points(problem, (points) => points.map((one, i) => (i === index ? {...one, ...change} : one)));
}

/** One more, as far on as the last is from the one before, by place and, where angles are given, by angle. */
export function continued({points, given}: PathTask, step: number): PathPoint {
  const last = points.at(-1) ?? {x: -step, y: 0, input_deg: -30},
    before = points.at(-2) ?? {x: last.x - step, y: last.y, input_deg: (last.input_deg ?? 0) - 30};
  const on = (key: "x" | "y" | "input_deg") => Number((2 * (last[key] ?? 0) - (before[key] ?? 0)).toPrecision(12));
  return {x: on("x"), y: on("y"), ...(given ? {} : {input_deg: on("input_deg")})};
}
/** What a click on the drawing adds where points are missing. */
export function with_clicked(problem: Problem, [x, y]: Point): Problem | null {
  const task = path_task(problem);
  if (!task || position_count(task.points) >= counts[form_of(task)][0]) return null;
  return with_points(problem, (points) => [...points, {...continued(task, 0), x, y}]);
}
/** Another place in the order in which they are passed; the angles stay where they were, in theirs. */
export function reordered(points: readonly PathPoint[], from: number, to: number): PathPoint[] {
  const list = points.map(untimed),
    [moved] = list.splice(from, 1);
  if (moved) list.splice(to, 0, moved);
  return list.map((one, i) => timed(one, points[i]!.input_deg));
}
/** The angles in equal steps between the first and the last. */
export function evenly_timed(points: readonly PathPoint[]): PathPoint[] {
  const first = points[0]?.input_deg ?? 0,
    span = (points.at(-1)?.input_deg ?? 0) - first;
  return points.map((one, i) => timed(one, multiple(first + (span * i) / Math.max(points.length - 1, 1), 1e-6)));
}
function timed(point: PathPoint, input_deg: number | undefined): PathPoint {
  return input_deg === undefined ? point : {...point, input_deg};
}
function untimed({input_deg: _, ...rest}: PathPoint): PathPoint {
  return rest;
}

// ---- what is given beside them ----------------------------------------------------------------------------------------

const usual_span_deg = 120;

/** With something else given. Points stay, and pivots as far as they are given then, too; others begin where the linkage in
 *  hand has them, else beside the points. Angles come back evenly. */
export function with_form(problem: Problem, form: PathForm, hand: Linkage | null): Problem {
  return changed(problem, (task) => {
    if (form_of(task) === form) return task;
    if (form === "angles") return timed_task(task);
    const [side = "input"] = given_sides(task),
      sides = form === "pivot" ? [side] : (["input", "output"] as const);
    return {...task, points: task.points.map(directed), given: {ground_pivots: pivots_at(task, sides, hand)}};
  });
}
function timed_task({given: _, ...task}: PathTask): PathTask {
  return {...task, points: evenly_timed(task.points.map((one, i) => timed(one, i === 0 ? 0 : usual_span_deg)))};
}
/** Without the crank: its rates go with its angle. */
function directed(point: PathPoint): PathPoint {
  const {derivatives, ...rest} = untimed(point);
  return {...rest, ...(derivatives ? {derivatives: derivatives.map(({x, y}): PathRate => ({x, y}))} : {})};
}
function pivots_at(task: PathTask, sides: readonly Side[], hand: Linkage | null): GroundPivots {
  return sides.reduce<GroundPivots>((pivots, side) => {
    const of_hand = hand?.[side].center?.map((value) => Number(value.toPrecision(4))) as unknown as Point | undefined;
    return {...pivots, [side]: pivots_of(task)[side] ?? of_hand ?? pivot_beside(task.points, side, pivots)};
  }, {});
}
/** Off the points' middle, the input's to the left, at none of the points and no other pivot. */
function pivot_beside(points: readonly PathPoint[], side: Side, pivots: GroundPivots): Point {
  const places = points.map(place_of),
    size = diagonal_of(places) || 100,
    step = round_step(size / 50);
  const middle = (axis: 0 | 1) => places.reduce((sum, place) => sum + place[axis], 0) / Math.max(places.length, 1);
  const is_free = ([x, y]: Point) =>
    [...places, ...Object.values(pivots)].every((place) => Math.hypot(place[0] - x, place[1] - y) > 0.05 * size);
  for (let share = 0.2; ; share += 0.1) {
    const off = side === "input" ? -share : share,
      at: Point = [multiple(middle(0) + off * size, step), multiple(middle(1) - 0.5 * share * size, step)];
    if (is_free(at)) return at;
  }
}
export function with_pivot(problem: Problem, side: Side, at: Point): Problem {
  return changed(problem, (task) => ({...task, given: {ground_pivots: {...pivots_of(task), [side]: at}}}));
}
/** The one pivot that is given, of this link. */
export function with_pivot_of(problem: Problem, side: Side): Problem {
  return changed(problem, (task) => {
    const [at] = Object.values(pivots_of(task));
    return at ? {...task, given: {ground_pivots: {[side]: at}}} : task;
  });
}

/** Which of the linkages at a place τ names: the first, the best there, where it names none. */
export function layer_at(layers: readonly {tau: TauPair}[], tau: TauPair): number {
  return Math.max(
    layers.findIndex((layer) => tau[0] >= 1 && Math.floor(layer.tau[0]) === Math.floor(tau[0])),
    0,
  );
}
