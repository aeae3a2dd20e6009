// Has the yields of the map on screen sampled, some cells at a time, and what is known shown between.
import type {EngineClient} from "../engine/client";
import type {Replies} from "../contract/messages";
import {Question} from "../questions/question.svelte";
import type {Questions} from "../questions/questions";

export type YieldProgress = Replies["yields"];

const first_cells = 200,
  most_cells = 20_000,
  step_ms = 120; // so often the map shows more

export class YieldSampler {
  private readonly question: Question<object, YieldProgress>;

  /** `show` has what is known shown; false: nobody wants more. */
  constructor(
    questions: Questions,
    private readonly show: (progress: YieldProgress) => Promise<boolean>,
  ) {
    this.question = new Question(questions);
  }

  stop(): void {
    this.question.drop();
  }
  /** Of the map that the engine has explored last, for this problem. */
  async follow(engine: EngineClient, problem: string): Promise<void> {
    await this.question.ask({}, (signal) => this.sample(engine, problem, signal), {at_leisure: true});
  }
  private async sample(engine: EngineClient, problem: string, signal: AbortSignal): Promise<YieldProgress> {
    for (let cells = first_cells; ;) {
      const start = performance.now(),
        progress = await engine.run({kind: "yields", problem, cells}, {signal});
      const took_ms = performance.now() - start,
        goes_on = await this.show(progress);
      if (!goes_on || signal.aborted || progress.done >= progress.total) return progress;
      cells = Math.ceil(Math.min(Math.max((cells * step_ms) / Math.max(took_ms, 1), first_cells), most_cells));
    }
  }
}
