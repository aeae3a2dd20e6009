// A longer search for linkages that are fitted, in an engine of its own: what it finds becomes what the usual search
// begins with.
import type {EngineClient} from "../../engine/client";
import type {Replies, Tidings} from "../../contract/messages";
import {Question} from "../../questions/question.svelte";
import {engine_text, same_question, type Problem} from "../../state/problem";
import type {Workbench} from "../../state/workbench.svelte";
import {with_starts} from "./near";

type Found = Replies["search_fits"];

/** What is searched: the same with whatever linkages it begins with. */
const sought = (problem: Problem): Problem => with_starts(problem, []);

export class DeepSearch {
  /** Of 1. */
  done = $state(0);
  private end = $state.raw<"done" | "stopped" | "failed" | null>(null);
  private asked = $state.raw<Problem | null>(null);
  private readonly question: Question<Problem, Found>;

  constructor(private readonly workbench: Workbench) {
    this.question = new Question(workbench.questions, {same: same_question});
  }

  get running(): boolean {
    return this.question.busy;
  }
  /** What it found for the problem that there is. */
  get found(): Found | null {
    return this.question.is_of(sought(this.workbench.problem)) ? this.question.value : null;
  }
  /** How it ended, where that was for the problem that there is. */
  get ended(): "done" | "stopped" | "failed" | null {
    return this.asked && this.is_for(this.asked) ? this.end : null;
  }
  async start(): Promise<void> {
    const {start_engine, problem} = this.workbench;
    if (this.running || !start_engine) return;
    const of = sought(problem);
    [this.asked, this.done, this.end] = [of, 0, null];
    const found = await this.question.ask(of, (signal) => this.look(start_engine(), of, signal), {at_leisure: true});
    this.end ??= found ? "done" : "failed";
    if (found?.linkages.length && this.is_for(of))
      this.workbench.edit((problem) => with_starts(problem, found.linkages));
  }
  private is_for(of: Problem): boolean {
    return same_question(sought(this.workbench.problem), of);
  }
  private async look(client: EngineClient, of: Problem, signal: AbortSignal): Promise<Found> {
    const progress = ({done}: Tidings["search_fits"]) => {
      this.done = done;
      if (!this.is_for(of)) this.stop(); // nobody wants it any more
    };
    try {
      return await client.run({kind: "search_fits", problem: engine_text(of)}, {signal, progress});
    } finally {
      client.close();
    }
  }
  stop(): void {
    if (!this.running) return;
    this.end = "stopped";
    this.question.drop();
  }
}

const searches = new WeakMap<Workbench, DeepSearch>();
export function deep_search_of(workbench: Workbench): DeepSearch {
  const search = searches.get(workbench) ?? new DeepSearch(workbench);
  searches.set(workbench, search);
  return search;
}
