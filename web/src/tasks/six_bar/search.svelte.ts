// Looks for a chain, in an engine of its own: the page goes on. Rounds of more and more chains, each beginning with those
// of the round before, so that what was found is there when the search is stopped, and the last is the program's answer.
import {Crashed, Refusal, type EngineClient} from "../../engine/client";
import type {Box, Linkage, Ranked, TauPair, Tidings} from "../../engine/protocol";
import type {Chain, SixBarTask} from "./task";
import {engine_text, with_options, type Problem} from "../../state/problem";
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

function sum(numbers: readonly number[]): number {
  return numbers.reduce((total, number) => total + number, 0);
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
  return with_options(with_six_bar(problem, {chain: undefined}), {box: box_of_search(problem), effort: chains});
}

/** Elbows that are all as in position 1 need not be said. */
function plain({elbow, ...chain}: Chain): Chain {
  return elbow?.some((sign) => sign !== 0) ? {...chain, elbow} : chain;
}

export class ChainSearch {
  private found = $state.raw<readonly Found[]>([]);
  /** The positions through which they go. */
  private poses = $state.raw<readonly Pose[]>([]);
  running = $state(false);
  /** Chains tried, of all that are to be tried. */
  tried = $state(0);
  to_try = $state(0);
  seconds = $state(0);
  /** How the last one ended. */
  end = $state.raw<"done" | "stopped" | "failed" | null>(null);
  private client: EngineClient | null = null;
  private timer: ReturnType<typeof setInterval> | undefined;

  constructor(private readonly workbench: Workbench) {}

  async start(): Promise<void> {
    const {problem, start_engine} = this.workbench,
      task = six_bar_task(problem);
    if (this.running || !start_engine || !task) return;
    this.begin(task, rounds_of(problem));
    const client = (this.client = start_engine());
    try {
      await this.search(client, problem, task);
      if (this.client === client) this.stop("done");
    } catch (error) {
      if (this.client !== client) return; // stopped
      this.stop("failed");
      if (error instanceof Crashed) return;
      if (!(error instanceof Refusal)) throw error;
      this.workbench.say("six_bar.refused", {reason: error.message});
    }
  }
  private begin({poses}: SixBarTask, rounds: readonly number[]): void {
    const begin = performance.now();
    this.found = [];
    this.poses = poses;
    [this.running, this.seconds, this.tried, this.to_try, this.end] = [true, 0, 0, sum(rounds), null];
    this.timer = setInterval(() => (this.seconds = Math.round((performance.now() - begin) / 1000)), 250);
  }
  private async search(client: EngineClient, problem: Problem, {added}: SixBarTask): Promise<void> {
    const chains = rounds_of(problem),
      rounds = chains.map((of_round) => engine_text(round_of(problem, of_round)));
    let drawn = Promise.resolve();
    const progress = (tidings: Tidings["search"]) => {
      if (this.client !== client) return;
      this.take_round(tidings.found.linkages, added);
      this.tried = sum(chains.slice(0, tidings.rounds));
      drawn = drawn.then(() => this.fetch_linkages(problem));
      if (!this.is_for(this.workbench.problem)) this.stop();
    };
    await client.run({kind: "search", rounds, most: problem.options?.best ?? defaults.options.best}, {progress});
    await drawn;
  }
  /** Whether it goes, or went, through the positions of this problem. */
  is_for(problem: Problem): boolean {
    return same_value(six_bar_task(problem)?.poses, this.poses);
  }
  /** A chain that was found for other positions does not reach these. */
  found_for(problem: Problem): readonly Found[] {
    return this.is_for(problem) ? this.found : [];
  }
  /** What was found so far is kept. */
  stop(end: "done" | "stopped" | "failed" = "stopped"): void {
    clearInterval(this.timer);
    const {client} = this;
    this.client = null;
    this.running = false;
    this.end = end;
    client?.close();
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
