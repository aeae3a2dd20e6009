// Has the yields of the map on screen sampled, some cells at a time, and what is known shown between.
import type {EngineClient} from "../engine/client";
import type {Replies} from "../engine/protocol";

export type YieldProgress = Replies["yields"];

const first_cells = 200,
  most_cells = 20_000,
  step_ms = 120; // so often the map shows more

export class YieldSampler {
  private job = new AbortController();

  /** `show` has what is known shown; false: nobody wants more. */
  constructor(
    private readonly engine: () => EngineClient | null,
    private readonly show: (progress: YieldProgress) => Promise<boolean>,
  ) {}

  stop(): void {
    this.job.abort();
  }
  /** Of the map that the engine has explored last, for this problem. */
  async follow(problem: string): Promise<void> {
    this.stop();
    const {signal} = (this.job = new AbortController());
    for (let cells = first_cells; ;) {
      const start = performance.now(),
        progress = await this.engine()
          ?.run({kind: "yields", problem, cells}, {signal})
          .catch(() => null);
      if (!progress || signal.aborted) return;
      const took_ms = performance.now() - start,
        goes_on = await this.show(progress);
      if (!goes_on || signal.aborted || progress.done >= progress.total) return;
      cells = Math.ceil(Math.min(Math.max((cells * step_ms) / Math.max(took_ms, 1), first_cells), most_cells));
    }
  }
}
