// Looks for a ground pivot of the crank, in rounds of more and more places; the best is given then.
import type {Box, Point, Ranked} from "../../contract/messages";
import type {LinkageOf} from "../../state/document";
import {engine_text, with_options, with_task, type Problem} from "../../state/problem";
import {RoundSearch} from "../../state/round_search.svelte";
import {box_of, same_value} from "../../state/task";
import type {Workbench} from "../../state/workbench.svelte";
import {without_unmet} from "../kind_dispatch";
import {path_task, points_of, with_pivot} from "./points";
import {angle_counts, form_of, given_sides, place_of, type PathPoint, type PathTask} from "./task";

/** How many arms each round tries. */
export const rounds = [20_000, 200_000] as const;

/** Five positions without angles leave the place open. */
export function may_seek_pivot(task: PathTask): boolean {
  const {angled, plain} = angle_counts(task);
  return angled === 0 && plain === 5 && form_of(task) === "pivot" && given_sides(task)[0] === "input";
}
/** Where pivots are required, else around the points, with as much room again on each side. */
export function box_of_pivot(problem: Problem): Box {
  const required = problem.requirements?.ground_pivots_within;
  if (required) return {x: required.x, y: required.y};
  const {x, y} = box_of(points_of(problem).map(place_of)),
    room = Math.max(x[1] - x[0], y[1] - y[0]) || 100;
  return {x: [x[0] - room, x[1] + room], y: [y[0] - room, y[1] + room]};
}
/** What the program would be asked. */
export function round_of(problem: Problem, effort: number): Problem {
  const task = path_task(problem)!,
    {given: _, ...open} = task;
  return with_options(without_unmet(with_task(problem, open)), {box: box_of_pivot(problem), effort});
}
function found_in([best]: readonly Ranked[], problem: Problem): LinkageOf[] {
  const center = best?.pivots[0];
  if (!best || !center) return [];
  const at = [center[0], center[1]].map((value) => Number(value!.toPrecision(6))) as unknown as Point;
  return [{tau: best.tau, problem: with_pivot(problem, "input", at)}];
}

export class PivotSearch extends RoundSearch {
  /** The points through which it goes. */
  private points = $state.raw<readonly PathPoint[]>([]);

  async start(): Promise<void> {
    const {problem} = this.workbench,
      task = path_task(problem);
    if (this.running || !task || !may_seek_pivot(task)) return;
    this.points = task.points;
    await this.look({
      rounds: rounds.map((arms) => ({problem: engine_text(round_of(problem, arms)), tries: arms})),
      most: 1,
      read: (entries) => found_in(entries, problem),
      is_wanted: () => this.is_for(this.workbench.problem),
      refused: "path.pivot_refused",
    });
    this.take();
  }
  /** Whether it goes, or went, through the points of this problem. */
  is_for(problem: Problem): boolean {
    return same_value(points_of(problem), this.points);
  }
  get has_found(): boolean {
    return this.found.length > 0;
  }
  /** The place and its best linkage, one step. */
  private take(): void {
    const [best] = this.found;
    if (!best || !this.is_for(this.workbench.problem)) return;
    this.workbench.edit_document((document) => ({
      ...document,
      problem: best.problem,
      picked: {tau: best.tau, place: null},
    }));
  }
}

const searches = new WeakMap<Workbench, PivotSearch>();
export function pivot_search_of(workbench: Workbench): PivotSearch {
  const search = searches.get(workbench) ?? new PivotSearch(workbench);
  searches.set(workbench, search);
  return search;
}
