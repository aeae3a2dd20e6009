// A search in an engine of its own: the page goes on. Rounds of more and more tries, each beginning with those of the round
// before, so that what was found is there when the search is stopped, and the last is the program's answer.
import type {EngineClient} from "../engine/client";
import type {Linkage, Ranked, Replies, Tidings} from "../contract/messages";
import {Question} from "../questions/question.svelte";
import type {TextKey} from "../texts/texts.svelte";
import type {LinkageOf} from "./document";
import {each_linkage, type Linkages} from "./each_linkage";
import type {Workbench} from "./workbench.svelte";

/** What the engine is asked in a round, and how much it tries. */
export interface Round {
  problem: string;
  tries: number;
}
export interface SoughtRounds<Found> {
  rounds: readonly Round[];
  /** How many are listed. */
  most: number;
  read(entries: readonly Ranked[]): Found[];
  /** False: it would find what nobody wants any more. */
  is_wanted(): boolean;
  /** Said with {reason} where the engine refuses. */
  refused: TextKey;
}

/** Each found linkage comes with the problem on whose map it lies. */
export class RoundSearch<Found extends LinkageOf = LinkageOf> {
  /** Of all tries, as far as they have rounds behind them. */
  tried = $state(0);
  to_try = $state(0);
  seconds = $state(0);
  /** How the last one ended. */
  end = $state.raw<"done" | "stopped" | "failed" | null>(null);
  protected found = $state.raw<readonly Found[]>([]);
  private readonly linkages: Linkages; // for their pictures
  private readonly question: Question<object, Replies["search"]>;

  constructor(protected readonly workbench: Workbench) {
    this.linkages = each_linkage(workbench);
    this.question = new Question(workbench.questions);
  }

  get running(): boolean {
    return this.question.busy;
  }
  linkage_of(found: Found): Linkage | null {
    return this.linkages.value_of(found);
  }
  protected async look(sought: SoughtRounds<Found>): Promise<void> {
    const {start_engine} = this.workbench;
    if (this.running || !start_engine) return;
    [this.seconds, this.tried, this.to_try, this.end, this.found] = [0, 0, tries_of(sought.rounds), null, []];
    const request = (signal: AbortSignal) => this.search(start_engine(), sought, signal),
      reply = await this.question.ask(sought, request, {
        at_leisure: true,
        refused: ({message}) => this.workbench.say(sought.refused, {reason: message}),
      });
    this.end ??= reply ? "done" : "failed";
  }
  private async search(
    client: EngineClient,
    {rounds, most, read, is_wanted}: SoughtRounds<Found>,
    signal: AbortSignal,
  ): Promise<Replies["search"]> {
    const begin = performance.now(),
      timer = setInterval(() => (this.seconds = Math.round((performance.now() - begin) / 1000)), 250);
    let fetched = Promise.resolve();
    const progress = (tidings: Tidings["search"]) => {
      this.found = read(tidings.found.linkages);
      this.tried = tries_of(rounds.slice(0, tidings.rounds));
      fetched = this.linkages.want(this.found);
      if (!is_wanted()) this.stop();
    };
    try {
      const texts = rounds.map(({problem}) => problem),
        reply = await client.run({kind: "search", rounds: texts, most}, {signal, progress});
      await fetched;
      return reply;
    } finally {
      clearInterval(timer);
      client.close();
    }
  }
  /** What was found so far is kept. */
  stop(): void {
    if (!this.running) return;
    this.end = "stopped";
    this.question.drop();
  }
}
function tries_of(rounds: readonly Round[]): number {
  return rounds.reduce((total, {tries}) => total + tries, 0);
}
