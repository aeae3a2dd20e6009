// Looks for a chain, in rounds of more and more chains.
import type {Box, Linkage, Ranked, TauPair} from "../../contract/messages";
import type {Chain, SixBarTask} from "./task";
import {engine_text, with_options, type Problem} from "../../state/problem";
import {without_unmet} from "../kinds";
import {RoundSearch} from "../../state/round_search.svelte";
import {same_value, type Pose} from "../../state/task";
import type {Workbench} from "../../state/workbench.svelte";
import {default_box, six_bar_task, with_six_bar} from "./chain";
import {defaults} from "../../state/defaults";

export const most_effort = 1_000_000,
  most_seed = 999_999_999;
const first_chains = 1000,
  times_as_many = 4;

export interface Found {
  chain: Chain;
  tau: TauPair;
  min_transmission_angle_deg: number;
  link_ratio: number;
  longest: number;
  added: SixBarTask["added"];
  linkage: Linkage | null;
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

export class ChainSearch extends RoundSearch {
  private found = $state.raw<readonly Found[]>([]);
  /** The positions through which they go. */
  private poses = $state.raw<readonly Pose[]>([]);

  async start(): Promise<void> {
    const {problem} = this.workbench,
      task = six_bar_task(problem);
    if (this.running || !task) return;
    this.found = [];
    this.poses = task.poses;
    await this.look({
      rounds: rounds_of(problem).map((chains) => ({problem: engine_text(round_of(problem, chains)), tries: chains})),
      most: problem.options?.best ?? defaults.options.best,
      take: (entries) => this.take_round(entries, task.added),
      fetch: () => this.fetch_linkages(problem),
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
  /** What a round before has found as well keeps its linkage. */
  private take_round(entries: readonly Ranked[], added: SixBarTask["added"]): void {
    const known = this.found;
    this.found = entries.flatMap((entry) => {
      if (!entry.chain) return [];
      const chain = plain(entry.chain),
        before = known.find((other) => same_value(other.chain, chain) && same_value(other.tau, entry.tau));
      const {link_ratio, longest} = entry;
      if (link_ratio === null || longest === null) return [];
      return [{...entry, link_ratio, longest, chain, added, linkage: before?.linkage ?? null}];
    });
  }
  /** For their pictures: by the engine that follows the pointer, in turn with what it follows. */
  private async fetch_linkages(problem: Problem): Promise<void> {
    for (const one of this.found.filter(({linkage}) => !linkage)) {
      if (!this.found.includes(one)) continue; // of a round before
      const {chain, added, tau} = one,
        asked = engine_text(with_six_bar(problem, {chain, added}));
      const reply = await this.workbench.driver_client?.run({kind: "linkage", problem: asked, tau}).catch(() => null);
      if (reply) this.found = this.found.map((other) => (other === one ? {...one, linkage: reply.linkage} : other));
    }
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
