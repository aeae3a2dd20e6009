// Looks for a chain, in rounds of more and more chains.
import type {Box, Ranked} from "../../contract/messages";
import type {Chain, SixBarTask} from "./task";
import type {LinkageOf} from "../../state/document";
import {engine_text, with_options, type Problem} from "../../state/problem";
import {without_unmet} from "../kind_dispatch";
import {RoundSearch} from "../../state/round_search.svelte";
import {same_value, type Pose} from "../../state/task";
import type {Workbench} from "../../state/workbench.svelte";
import {default_box, six_bar_task, with_six_bar} from "./chain";
import {defaults} from "../../state/defaults";

export const most_effort = 1_000_000,
  most_seed = 999_999_999;
const first_chains = 1000,
  times_as_many = 4;

export interface Found extends LinkageOf {
  chain: Chain;
  min_transmission_angle_deg: number;
  link_ratio: number;
  longest: number;
  added: SixBarTask["added"];
}

export function box_of_search(problem: Problem): Box {
  return problem.options?.box ?? default_box(problem);
}
/** How many chains each round tries. */
export function rounds_of({options}: Problem): number[] {
  const rounds: number[] = [];
  for (let chains = options?.effort ?? defaults.options.effort; ; chains = Math.ceil(chains / times_as_many)) {
    rounds.unshift(chains);
    if (chains <= first_chains) return rounds;
  }
}
/** The problem of a round: for the last one, what the program would be asked. */
export function round_of(problem: Problem, chains: number): Problem {
  return with_options(without_unmet(with_six_bar(problem, {chain: undefined})), {
    box: box_of_search(problem),
    effort: chains,
  });
}

/** Elbows that are all as in position 1 need not be said. */
function plain({elbow, ...chain}: Chain): Chain {
  return elbow?.some((sign) => sign !== 0) ? {...chain, elbow} : chain;
}

function found_in(entries: readonly Ranked[], problem: Problem, added: SixBarTask["added"]): Found[] {
  return entries.flatMap(({link_ratio, longest, chain: found, ...entry}) => {
    if (!found || link_ratio === null || longest === null) return [];
    const chain = plain(found);
    return [{...entry, link_ratio, longest, chain, added, problem: with_six_bar(problem, {chain, added})}];
  });
}

export class ChainSearch extends RoundSearch<Found> {
  /** The positions through which they go. */
  private poses = $state.raw<readonly Pose[]>([]);

  async start(): Promise<void> {
    const {problem} = this.workbench,
      task = six_bar_task(problem);
    if (this.running || !task) return;
    this.poses = task.poses;
    await this.look({
      rounds: rounds_of(problem).map((chains) => ({problem: engine_text(round_of(problem, chains)), tries: chains})),
      most: problem.options?.best ?? defaults.options.best,
      read: (entries) => found_in(entries, problem, task.added),
      is_wanted: () => this.is_for(this.workbench.problem),
      refused: "six_bar.refused",
    });
  }
  /** Whether it goes, or went, through the positions of this problem. */
  is_for(problem: Problem): boolean {
    return same_value(six_bar_task(problem)?.poses, this.poses);
  }
  /** A chain that was found for other positions does not reach these. */
  found_for(problem: Problem): readonly Found[] {
    return this.is_for(problem) ? this.found : [];
  }

  /** Takes one in hand: its chain and its place on the map of that chain, one step. */
  take({chain, added, tau}: Found): void {
    this.workbench.edit_document((document) => ({
      ...document,
      problem: with_six_bar(document.problem, {chain, added}),
      picked: {tau, place: null},
    }));
  }
}

const searches = new WeakMap<Workbench, ChainSearch>();
export function search_of(workbench: Workbench): ChainSearch {
  const search = searches.get(workbench) ?? new ChainSearch(workbench);
  searches.set(workbench, search);
  return search;
}
