// The ranked list: the best linkages of the task, by the program's own search and in its order.
import type {EngineClient} from "../engine/client";
import type {Notice, Ranked} from "../engine/protocol";
import {engine_text, type Problem} from "./problem";

interface Listed {
  readonly engine: EngineClient | null;
  readonly problem: Problem;
  /** Why the engine is not asked, where it is not. */
  readonly incomplete: object | null;
}
const most = 10; // as `linkwright solve` prints where nothing else is asked

export class BestList {
  found = $state.raw<{text: string; linkages: Ranked[]; notices: Notice[]} | null>(null);
  private asked = $state.raw<{text: string; stop: AbortController} | null>(null);

  constructor(private readonly listed: Listed) {}

  /** What is listed belongs to the task on screen. */
  get is_current(): boolean {
    return this.found?.text === engine_text(this.listed.problem);
  }
  /** The engine is at it. */
  get busy(): boolean {
    return this.asked !== null;
  }
  /** Stops what is under way for another task: the map of this one would wait for it. */
  let_go(): void {
    if (!this.asked || this.asked.text === engine_text(this.listed.problem)) return;
    this.asked.stop.abort();
    this.asked = null;
  }
  /** Fetches the list of the task as it is, unless it is there or on its way. */
  async fetch(): Promise<void> {
    const {engine, incomplete, problem} = this.listed,
      text = engine_text(problem);
    if (!engine || incomplete || text === this.asked?.text || text === this.found?.text) return;
    this.let_go();
    const asked = (this.asked = {text, stop: new AbortController()});
    const reply = await engine.run({kind: "best", problem: text, most}, {signal: asked.stop.signal}).catch(() => null);
    if (this.asked !== asked) return;
    this.asked = null;
    if (reply) this.found = {text, linkages: reply.linkages, notices: reply.notices};
  }
}
