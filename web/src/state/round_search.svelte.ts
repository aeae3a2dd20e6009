// A search in an engine of its own: the page goes on. Rounds of more and more tries, each beginning with those of the round
// before, so that what was found is there when the search is stopped, and the last is the program's answer.
import {Crashed, Refusal, type EngineClient} from "../engine/client";
import type {Ranked, Tidings} from "../contract/messages";
import type {TextKey} from "../texts/texts.svelte";
import type {Workbench} from "./workbench.svelte";

/** What the engine is asked in a round, and how much it tries. */
export interface Round {
  problem: string;
  tries: number;
}
export interface SoughtRounds {
  rounds: readonly Round[];
  /** How many are listed. */
  most: number;
  /** What a round has found, and then what is to be fetched for it. */
  take(entries: readonly Ranked[]): void;
  fetch(): Promise<void>;
  /** False: it would find what nobody wants any more. */
  is_wanted(): boolean;
  /** Said with {reason} where the engine refuses. */
  refused: TextKey;
}

export class RoundSearch {
  running = $state(false);
  /** Of all tries, as far as they have rounds behind them. */
  tried = $state(0);
  to_try = $state(0);
  seconds = $state(0);
  /** How the last one ended. */
  end = $state.raw<"done" | "stopped" | "failed" | null>(null);
  private client: EngineClient | null = null;
  private timer: ReturnType<typeof setInterval> | undefined;

  constructor(protected readonly workbench: Workbench) {}

  protected async look(sought: SoughtRounds): Promise<void> {
    const {start_engine} = this.workbench;
    if (this.running || !start_engine) return;
    this.begin(sought.rounds);
    const client = (this.client = start_engine());
    try {
      await this.search(client, sought);
      if (this.client === client) this.stop("done");
    } catch (error) {
      if (this.client !== client) return; // stopped
      this.stop("failed");
      if (error instanceof Crashed) return;
      if (!(error instanceof Refusal)) throw error;
      this.workbench.say(sought.refused, {reason: error.message});
    }
  }
  private begin(rounds: readonly Round[]): void {
    const begin = performance.now();
    [this.running, this.seconds, this.tried, this.to_try, this.end] = [true, 0, 0, tries_of(rounds), null];
    this.timer = setInterval(() => (this.seconds = Math.round((performance.now() - begin) / 1000)), 250);
  }
  private async search(client: EngineClient, {rounds, most, take, fetch, is_wanted}: SoughtRounds): Promise<void> {
    let fetched = Promise.resolve();
    const progress = (tidings: Tidings["search"]) => {
      if (this.client !== client) return;
      take(tidings.found.linkages);
      this.tried = tries_of(rounds.slice(0, tidings.rounds));
      fetched = fetched.then(fetch);
      if (!is_wanted()) this.stop();
    };
    await client.run({kind: "search", rounds: rounds.map(({problem}) => problem), most}, {progress});
    await fetched;
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
}
function tries_of(rounds: readonly Round[]): number {
  return rounds.reduce((total, {tries}) => total + tries, 0);
}
