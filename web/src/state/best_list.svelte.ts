// The ranked list: the best linkages of the task, by the program's own search and in its order.
import type {EngineClient} from "../engine/client";
import type {Notice, Ranked} from "../engine/protocol";
import {map_of} from "../tasks/kinds";
import {engine_text, type Problem} from "./problem";

interface Listed {
  readonly engine: EngineClient | null;
  readonly problem: Problem;
  /** Why the engine is not asked, where it is not. */
  readonly incomplete: object | null;
  /** They count the tasks opened, and the ways through the history. */
  readonly opened: number;
  readonly moves: number;
}
interface Found {
  text: string;
  /** Of which task it is, however that is changed. */
  task: string;
  linkages: Ranked[];
  notices: Notice[];
}
const most = 10; // as `linkwright solve` prints where nothing else is asked

export class BestList {
  private last = $state.raw<Found | null>(null);
  private asked = $state.raw<{text: string; stop: AbortController} | null>(null);

  constructor(private readonly listed: Listed) {}

  /** The last list of the task on screen, perhaps as it was a moment ago. */
  get found(): Found | null {
    return this.last?.task === this.task && !this.listed.incomplete ? this.last : null;
  }
  private get task(): string {
    const {opened, moves, problem} = this.listed;
    return `${opened} ${moves} ${map_of(problem.task)}`;
  }
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
      {task} = this,
      text = engine_text(problem);
    if (!engine || incomplete || text === this.asked?.text || text === this.found?.text) return;
    this.let_go();
    const asked = (this.asked = {text, stop: new AbortController()});
    const reply = await engine.run({kind: "best", problem: text, most}, {signal: asked.stop.signal}).catch(() => null);
    if (this.asked !== asked) return;
    this.asked = null;
    if (reply) this.last = {text, task, linkages: reply.linkages, notices: reply.notices};
  }
}
