// Looks for a chain, in an engine of its own: the page goes on. Rounds of more and more chains, each beginning with those
// of the round before, so that what was found is there when the search is stopped, and the last is the program's answer.
import {Crashed, Refusal, type EngineClient} from "../../engine/client";
import type {Box, Chain, Linkage, Replies, TauPair} from "../../engine/protocol";
import {engine_text, with_options, type Problem} from "../../state/problem";
import {same_value, type Pose, type SixBarTask} from "../../state/task";
import type {Workbench} from "../../state/workbench.svelte";
import {default_box, six_bar_task, with_six_bar} from "./chain";

export const default_effort = 20_000,
  most_effort = 1_000_000,
  most_seed = 999_999_999;
const first_chains = 1000,
  times_as_many = 4,
  default_best = 10;

export interface Found {
  chain: Chain;
  tau: TauPair;
  min_transmission_angle_deg: number;
  link_ratio: number;
  longest: number;
  added: SixBarTask["added"];
  linkage: Linkage | null;
}
type Entry = Replies["best"]["linkages"][number];

export function box_of_search(problem: Problem): Box {
  return problem.options?.box ?? default_box(problem);
}
/** How many chains each round tries. */
export function rounds_of({options}: Problem): number[] {
  const rounds = [options?.effort ?? default_effort];
  while (rounds[0] > first_chains) rounds.unshift(Math.ceil(rounds[0] / times_as_many));
  return rounds;
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
    const begin = performance.now(),
      rounds = rounds_of(problem);
    this.found = [];
    this.poses = task.poses;
    [this.running, this.seconds, this.tried, this.to_try, this.end] = [
      true,
      0,
      0,
      rounds.reduce((sum, chains) => sum + chains),
      null,
    ];
    this.timer = setInterval(() => (this.seconds = Math.round((performance.now() - begin) / 1000)), 250);
    const client = (this.client = start_engine(
      () => {},
      () => {},
    ));
    try {
      for (const chains of rounds) {
        if (this.client !== client || !this.is_for(this.workbench.problem)) break;
        await this.try_round(client, round_of(problem, chains), task);
        this.tried += chains;
      }
      if (this.client === client) this.stop(this.tried < this.to_try ? "stopped" : "done");
    } catch (error) {
      if (this.client !== client) return; // stopped
      this.stop("failed");
      if (error instanceof Crashed) return;
      if (!(error instanceof Refusal)) throw error;
      this.workbench.say("six_bar.refused", {reason: error.message});
    }
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
  private async try_round(client: EngineClient, asked: Problem, {added}: SixBarTask): Promise<void> {
    const {linkages} = await client.request("best", {
      problem: engine_text(asked),
      most: asked.options?.best ?? default_best,
    });
    const entries = linkages.filter((entry): entry is Entry & {chain: Chain} => entry.chain !== undefined);
    const known = this.found;
    this.found = entries.map((entry) => {
      const one = {...entry, chain: plain(entry.chain), added};
      return {
        ...one,
        linkage:
          known.find((other) => same_value(other.chain, one.chain) && same_value(other.tau, one.tau))?.linkage ?? null,
      };
    });
    for (const one of this.found.filter(({linkage}) => !linkage)) {
      const {linkage} = await client.request("linkage", {
        problem: engine_text(with_six_bar(asked, {chain: one.chain})),
        tau: one.tau,
      });
      this.found = this.found.map((other) => (other === one ? {...one, linkage} : other));
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
