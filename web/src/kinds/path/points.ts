// The points of a path task, as they are edited.
import {with_task, type Problem} from "../../state/problem";
import {multiple} from "../../drawing/snapping";
import {without_unmet} from "../kind_dispatch";
import {is_path, type PathPoint, type PathTask} from "./task";

export function path_task({task}: Problem): PathTask | null {
  return is_path(task) ? task : null;
}
export function points_of(problem: Problem): readonly PathPoint[] {
  return path_task(problem)?.points ?? [];
}
export function with_points(problem: Problem, change: (points: readonly PathPoint[]) => readonly PathPoint[]): Problem {
  const task = path_task(problem);
  return task ? without_unmet(with_task(problem, {...task, points: change(task.points)})) : problem;
}
export function with_point(problem: Problem, index: number, change: Partial<PathPoint>): Problem {
  return with_points(problem, (points) => points.map((one, i) => (i === index ? {...one, ...change} : one)));
}

/** One more, as far on as the last is from the one before, by place and by angle. */
export function continued(points: readonly PathPoint[], step: number): PathPoint {
  const last = points.at(-1) ?? {x: -step, y: 0, input_deg: -30},
    before = points.at(-2) ?? {x: last.x - step, y: last.y, input_deg: last.input_deg - 30};
  const on = (key: "x" | "y" | "input_deg") => Number((2 * last[key] - before[key]).toPrecision(12));
  return {x: on("x"), y: on("y"), input_deg: on("input_deg")};
}
/** Another place in the order in which they are passed; the angles stay where they were, in theirs. */
export function reordered(points: readonly PathPoint[], from: number, to: number): PathPoint[] {
  const angles = points.map(({input_deg}) => input_deg),
    list = [...points],
    [moved] = list.splice(from, 1);
  if (moved) list.splice(to, 0, moved);
  return list.map((one, i) => ({...one, input_deg: angles[i]!}));
}
/** The angles in equal steps between the first and the last. */
export function evenly_timed(points: readonly PathPoint[]): PathPoint[] {
  const first = points[0]?.input_deg ?? 0,
    span = (points.at(-1)?.input_deg ?? 0) - first;
  return points.map((one, i) => ({
    ...one,
    input_deg: multiple(first + (span * i) / Math.max(points.length - 1, 1), 1e-6),
  }));
}
