// Looks over all cases for linkages that run straight over a stroke; each lies on a map of its own case.
import type {Ranked} from "../../contract/messages";
import type {LinkageOf} from "../../state/document";
import {defaults} from "../../state/defaults";
import {engine_text, with_options, with_task, type Problem} from "../../state/problem";
import {without_unmet} from "../kind_dispatch";
import {RoundSearch} from "../../state/round_search.svelte";
import {same_value} from "../../state/task";
import type {Workbench} from "../../state/workbench.svelte";
import {line_task} from "./line_handles";
import type {OwnMap} from "./replies";
import type {StraightLineTask} from "./task";

export interface Found extends OwnMap, LinkageOf {
  usable: number;
  share: number;
  min_transmission_angle_deg: number;
  longest: number;
}

const first_share = 0.1; // of the effort, for a first list

/** A linkage of a search on the map of its case, measured by what was wanted: its strip is as long as the stroke. */
export function problem_of(problem: Problem, {deviation}: StraightLineTask, {task, window}: OwnMap): Problem {
  return with_options(with_task(problem, task), {deviation, measure: "strip", window: window ?? undefined});
}
/** Back to what was wanted. */
export function sought_again(problem: Problem, sought: StraightLineTask): Problem {
  return with_options(without_unmet(with_task(problem, sought)), {
    deviation: undefined,
    measure: undefined,
    window: undefined,
  });
}

function found_in(entries: readonly Ranked[], problem: Problem, sought: StraightLineTask): Found[] {
  return entries.flatMap(({straight_line: own, tau, usable_strip, stroke_over_longest, ...entry}) => {
    const {longest, min_transmission_angle_deg} = entry;
    if (!own || longest === null) return [];
    return [
      {
        ...own,
        problem: problem_of(problem, sought, own),
        tau,
        usable: usable_strip ?? 0,
        share: stroke_over_longest ?? 0,
        min_transmission_angle_deg,
        longest,
      },
    ];
  });
}

export class LineSearch extends RoundSearch<Found> {
  /** What is, or was, wanted. */
  sought = $state.raw<StraightLineTask | null>(null);

  async start(): Promise<void> {
    const {problem} = this.workbench,
      task = line_task(problem);
    if (this.running || task?.case !== "search") return;
    this.sought = task;
    const effort = problem.options?.effort ?? defaults.options.effort;
    const round = (tries: number) => ({problem: engine_text(with_options(problem, {effort: tries})), tries});
    await this.look({
      rounds: [round(Math.max(Math.round(first_share * effort), 1)), round(effort)],
      most: problem.options?.best ?? defaults.options.best,
      read: (entries) => found_in(entries, problem, task),
      is_wanted: () => this.is_for(this.workbench.problem),
      refused: "straight.refused",
    });
  }
  /** Whether it is for what this problem wants, or has found what this problem has. */
  is_for({task}: Problem): boolean {
    return same_value(task, this.sought) || this.found.some((one) => same_value(one.task, task));
  }
  found_for(problem: Problem): readonly Found[] {
    return this.is_for(problem) ? this.found : [];
  }

  /** Opens the map of its case with it in hand, one step. */
  take(found: Found): void {
    const {sought} = this;
    if (!sought) return;
    this.workbench.edit_document((document) => ({
      ...document,
      problem: problem_of(document.problem, sought, found),
      picked: {tau: found.tau, place: null},
    }));
  }
  /** Opens what was wanted again. */
  back(): void {
    const {sought} = this;
    if (sought) this.workbench.edit((problem) => sought_again(problem, sought));
  }
}

const searches = new WeakMap<Workbench, LineSearch>();
export function line_search_of(workbench: Workbench): LineSearch {
  const search = searches.get(workbench) ?? new LineSearch(workbench);
  searches.set(workbench, search);
  return search;
}
