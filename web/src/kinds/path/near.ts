// What is given of paths that pass near their points: closed or open, tolerances and weights, and how long it is searched.
import type {Options} from "../../contract/problem";
import {with_options, type Problem} from "../../state/problem";
import {without_angle} from "./angles";
import {asks_for_near, is_near, is_path, type PathPoint, type PathTask} from "./task";

const efforts = ["quick", "standard", "deep"] as const;
export type Effort = (typeof efforts)[number];

/** Those that are soon answered, and that of the problem: deep is looked for beside the work (deep_search.svelte.ts). */
export function efforts_to_choose(problem: Problem): Effort[] {
  return efforts.filter((effort) => effort !== "deep" || effort_of(problem) === effort);
}

export function effort_of({options}: Problem): Effort {
  return options?.fit?.effort ?? "standard";
}
export function with_effort(problem: Problem, effort: Effort): Problem {
  const {effort: _, ...rest} = problem.options?.fit ?? {};
  return with_fit(problem, effort === "standard" ? rest : {...rest, effort});
}
type Fit = NonNullable<Options["fit"]>;
export type FitStarts = NonNullable<Fit["starts"]>;

/** Linkages to begin with. */
export function starts_of({options}: Problem): FitStarts {
  return options?.fit?.starts ?? [];
}
export function with_starts(problem: Problem, starts: FitStarts): Problem {
  const {starts: _, ...rest} = problem.options?.fit ?? {};
  return with_fit(problem, starts.length ? {...rest, starts} : rest);
}
function with_fit(problem: Problem, fit: Fit): Problem {
  return with_options(problem, {fit: Object.keys(fit).length ? fit : undefined});
}
export const maps = ["curves", "pivots"] as const;
/** What the map runs over. */
export type PathMap = (typeof maps)[number];

export function path_map_of({map}: Pick<PathTask, "map">): PathMap {
  return map ?? "curves";
}
/** What is asked while a hand moves: an answer soon. */
export function with_quick_fit(problem: Problem): Problem {
  const {task} = problem;
  return is_path(task) && is_near(task) ? with_effort(problem, "quick") : problem;
}

/** Near its points, however few there are and whatever else was taken away. */
export function kept_near(task: PathTask): PathTask {
  return asks_for_near(task) ? task : {...task, between: "free"};
}
/** Without what only a path that passes through its points has; its points stay. */
export function near_task({given, ...task}: PathTask): PathTask {
  return {
    ...(given && is_near({...task, given}) ? {given} : {}),
    ...kept_near(task),
    points: task.points.map((point) => {
      const {derivatives: _, ...place} = without_angle(point);
      return place;
    }),
  };
}
/** Without what only a path that passes near its points has. */
export function exact_task({closed: _, tolerance: __, between: ___, map: ____, ...task}: PathTask): PathTask {
  return {
    ...task,
    points: task.points.map(({tolerance: _, weight: __, ...point}) => point),
  };
}
export function tolerance_at({tolerance}: PathTask, point: PathPoint): number | null {
  return point.tolerance ?? tolerance ?? null;
}
/** One more, between the last and the first of a closed path. */
export function between_ends([first, ...rest]: readonly PathPoint[]): PathPoint | null {
  const last = rest.at(-1);
  if (!first || !last) return null;
  const middle = (key: "x" | "y") => Number(((first[key] + last[key]) / 2).toPrecision(6));
  return {x: middle("x"), y: middle("y")};
}
