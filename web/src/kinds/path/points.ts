// The points of a path task, their angles and what is given beside them, as they are edited.
import type {Linkage, Point, Side} from "../../contract/messages";
import {round_step, with_options, with_requirements, with_task, type Problem} from "../../state/problem";
import {diagonal_of} from "../../state/task";
import {multiple} from "../../drawing/snapping";
import {without_unmet} from "../kind_dispatch";
import {smoothed} from "./curve";
import {angle_ahead, angle_between, evenly_timed, some_angled, with_angle_on, without_angle} from "./angles";
import {wanted_point} from "./missing";
import {exact_task, kept_near, near_task, type PathMap} from "./near";
import {angle_key, angle_of, form_of, given_sides, is_near, is_path, pivots_of, place_of} from "./task";
import type {AngleKey, GroundPivots, PathForm, PathPoint, PathTask} from "./task";

export function path_task({task}: Problem): PathTask | null {
  return is_path(task) ? task : null;
}
export function points_of(problem: Problem): readonly PathPoint[] {
  return path_task(problem)?.points ?? [];
}
function changed(problem: Problem, change: (task: PathTask) => PathTask): Problem {
  const task = path_task(problem);
  if (!task) return problem;
  const edited = fitting_options(without_unmet(with_task(problem, change(task))));
  return problem.options?.box && edited.task !== task ? with_options(edited, {box: undefined}) : edited; // of a file
}
/** It stays near its points where it was. */
function changed_alike(problem: Problem, change: (task: PathTask) => PathTask): Problem {
  return changed(problem, (task) => (is_near(task) ? kept_near(change(task)) : change(task)));
}
/** What is said of how the nearest paths are found, ranked and chosen goes with such tasks only. */
function fitting_options(problem: Problem): Problem {
  const {options, requirements} = problem;
  if (is_near(problem.task as PathTask)) return problem;
  const by_error = options?.objective === "path_error",
    fitting =
      requirements?.max_path_error === undefined ? problem : with_requirements(problem, {max_path_error: undefined});
  return options?.fit || by_error
    ? with_options(fitting, {fit: undefined, ...(by_error ? {objective: undefined} : {})})
    : fitting;
}
export function with_points(problem: Problem, change: (points: readonly PathPoint[]) => readonly PathPoint[]): Problem {
  return changed_alike(problem, (task) => ({...task, points: change(task.points)}));
}
export function with_point(problem: Problem, index: number, change: Partial<PathPoint>): Problem {
  return with_points(problem, (points) => points.map((one, i) => (i === index ? {...one, ...change} : one)));
}

/** One more, as far on as the last is from the one before, by place and, with an angle of `key`, by angle. */
export function continued({points}: Pick<PathTask, "points">, step: number, key: AngleKey | null): PathPoint {
  const last = points.at(-1) ?? {x: -step, y: 0},
    before = points.at(-2) ?? {x: last.x - step, y: last.y};
  const on = (to: number, from: number) => Number((2 * to - from).toPrecision(12));
  const place = {x: on(last.x, before.x), y: on(last.y, before.y)};
  return key ? with_angle_on(place, key, angle_ahead(points, key)) : place;
}
/** Whose angles a point gets that is to have one. */
export function usual_key(task: PathTask): AngleKey {
  return angle_key(task) ?? (form_of(task) === "some" ? "theta_deg" : "input_deg");
}
/** What a click on the drawing adds where points are missing. */
export function with_clicked(problem: Problem, [x, y]: Point): Problem | null {
  const task = path_task(problem),
    wanted = task && wanted_point(task);
  if (!wanted) return null;
  const point = continued(task, 0, wanted === "angled" ? usual_key(task) : null);
  return with_points(problem, (points) => [...points, {...point, x, y}]);
}
/** To be clicked anew: all points, or those without an angle where others have one. */
export function clicked_anew(points: readonly PathPoint[]): readonly PathPoint[] {
  const angled = points.filter((point) => angle_of(point) !== null);
  return angled.length < points.length ? angled : [];
}

// ---- angles -----------------------------------------------------------------------------------------------------------

/** With an angle at a point that has none, or without the one that it has. */
export function with_angle_turned(problem: Problem, index: number): Problem {
  const task = path_task(problem);
  if (!task) return problem;
  const key = usual_key(task);
  const turned = (point: PathPoint) =>
    angle_of(point) === null ? with_angle_on(point, key, angle_between(task.points, index, key)) : without_angle(point);
  return with_points(problem, (points) => points.map((one, i) => (i === index ? turned(one) : one)));
}
/** The angles that there are as those of the other link. */
export function with_angles_of(problem: Problem, key: AngleKey): Problem {
  const swapped = (point: PathPoint): PathPoint => {
    const angle = angle_of(point);
    return angle === null ? point : with_angle_on(point, key, angle);
  };
  return changed(problem, (task) => {
    if (angle_key(task) === key) return task;
    return {...task, points: angle_key(task) ? task.points.map(swapped) : some_angled(task.points, key)};
  });
}

// ---- what is given beside them ----------------------------------------------------------------------------------------

const usual_span_deg = 120;

/** With something else given. Points stay, and pivots as far as they are given then, too; others begin where the linkage in
 *  hand has them, else beside the points. Angles at all come back evenly, at some they stay at three. */
export function with_form(problem: Problem, form: PathForm, hand: Linkage | null): Problem {
  return changed(problem, (task) => {
    if (form_of(task) === form) return task;
    if (form === "near") return near_task(task);
    if (form_of(task) === "near") return formed(exact_task(task), form, hand);
    return formed(task, form, hand);
  });
}
function formed(task: PathTask, form: Exclude<PathForm, "near">, hand: Linkage | null): PathTask {
  if (form === "angles") return timed_task(task);
  if (form === "some")
    return {...without_pivots(task), points: some_angled(task.points, angle_key(task) ?? "theta_deg")};
  const [side = "input"] = given_sides(task),
    sides = form === "pivot" ? [side] : (["input", "output"] as const);
  const stay = given_sides(task).length > 0; // with one pivot what goes with both
  return {
    ...task,
    points: stay ? task.points : task.points.map(without_angle),
    given: {ground_pivots: pivots_at(task, sides, hand)},
  };
}
function without_pivots({given: _, ...task}: PathTask): PathTask {
  return task;
}
function timed_task(task: PathTask): PathTask {
  const timed = (point: PathPoint, i: number): PathPoint => ({
    ...without_coupler(point),
    input_deg: i === 0 ? 0 : usual_span_deg,
  });
  const {points} = task,
    known = points.length > 0 && points.every(({input_deg}) => input_deg !== undefined);
  return {...without_pivots(task), points: known ? points : evenly_timed(points.map(timed))};
}
function without_coupler(point: PathPoint): PathPoint {
  return point.theta_deg === undefined ? point : without_angle(point);
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

// ---- near its points --------------------------------------------------------------------------------------------------

/** A path that is to pass near these. */
export function with_near_points(problem: Problem, places: readonly Point[], closed: boolean): Problem {
  return changed(problem, (task) => {
    const {closed: _, ...open} = is_near(task) ? task : without_pivots(task);
    return {
      ...near_task(kept_near(closed ? {...open, closed} : open)),
      points: places.map(([x, y]): PathPoint => ({x, y})),
    };
  });
}
export function with_closed(problem: Problem, closed: boolean): Problem {
  return changed_alike(problem, ({closed: _, ...task}) => (closed ? {...task, closed} : task));
}
export function with_between(problem: Problem, polyline: boolean): Problem {
  return changed_alike(problem, ({between: _, ...task}) => (polyline ? {...task, between: "polyline"} : task));
}
export function with_path_map(problem: Problem, map: PathMap): Problem {
  return changed_alike(problem, ({map: _, ...task}) => (map === "curves" ? task : {...task, map}));
}
/** A ground pivot stands where the linkage in hand has it, or anywhere. Where one is given there is no map of its places. */
export function with_bolted(problem: Problem, side: Side, wanted: boolean, hand: Linkage | null): Problem {
  return changed_alike(problem, (task) => {
    const {given: _, map, ...rest} = task,
      {[side]: __, ...others} = pivots_of(task),
      sides = [...(Object.keys(others) as Side[]), ...(wanted ? [side] : [])];
    if (sides.length === 0) return map ? {...rest, map} : rest;
    return {...rest, given: {ground_pivots: pivots_at(task, sides, hand)}};
  });
}
export function with_tolerance(problem: Problem, tolerance: number | null): Problem {
  return changed_alike(problem, ({tolerance: _, ...task}) => (tolerance === null ? task : {...task, tolerance}));
}
/** Of one point; null takes it off. */
export function with_point_number(
  problem: Problem,
  index: number,
  key: "tolerance" | "weight",
  value: number | null,
): Problem {
  return with_points(problem, (points) =>
    points.map((point, i) => {
      if (i !== index) return point;
      const {[key]: _, ...rest} = point;
      return value === null ? rest : {...rest, [key]: value};
    }),
  );
}
/** The same points, made smooth: what each has of its own stays with it. */
export function smoothed_points(problem: Problem): Problem {
  return changed(problem, (task) => {
    const places = smoothed(task.points.map(place_of), task.closed === true);
    return {
      ...task,
      points: task.points.map((point, i) => ({...point, x: tidy(places[i]![0]), y: tidy(places[i]![1])})),
    };
  });
}
const tidy = (value: number) => Number(value.toPrecision(7));
