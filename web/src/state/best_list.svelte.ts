// The ranked list: the best linkages of the task, by the program's own search and in its order.
import type {Notice, Replies} from "../engine/protocol";
import {engine_text} from "./problem";
import type {Workbench} from "./workbench.svelte";

export type Ranked = Replies["best"]["linkages"][number];
const most = 10; // as `linkwright solve` prints where nothing else is asked
const tries = 3,
  again_ms = 400; // one worker for all drops what it was asked before

export class BestList {
  found = $state.raw<{text: string; linkages: Ranked[]; notices: Notice[]} | null>(null);
  /** It is on screen, in place of the numbers. */
  shown = $state(false);
  private asked = "";

  constructor(private readonly workbench: Workbench) {}

  /** What is listed belongs to the task on screen. */
  get is_current(): boolean {
    return this.found?.text === engine_text(this.workbench.problem);
  }
  /** Fetches the list of the task as it is, unless it is there or on its way. */
  async fetch(): Promise<void> {
    const {engine, incomplete, problem} = this.workbench,
      text = engine_text(problem);
    if (!engine || incomplete || text === this.asked || text === this.found?.text) return;
    this.asked = text;
    for (let turn = 0; turn < tries && this.asked === text; ++turn) {
      const reply = await engine.request("best", {problem: text, most}).catch(() => null);
      if (this.asked !== text) return;
      if (reply) {
        this.found = {text, linkages: reply.linkages, notices: reply.notices};
        break;
      }
      await new Promise((resolve) => setTimeout(resolve, again_ms));
    }
    if (this.asked === text) this.asked = "";
  }
}
