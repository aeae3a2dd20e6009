// The ranked list: the best linkages of the task, by the program's own search and in its order.
import type {EngineClient} from "../engine/client";
import type {Replies} from "../contract/messages";
import {Question} from "../questions/question.svelte";
import type {Questions} from "../questions/questions";
import {map_of} from "../kinds/kind_dispatch";
import {engine_text, type Problem} from "./problem";

interface Listed {
  readonly questions: Questions;
  readonly engine: EngineClient | null;
  readonly problem: Problem;
  /** Why the engine is not asked, where it is not. */
  readonly incomplete: object | null;
  /** They count the tasks opened, and the ways through the history. */
  readonly opened: number;
  readonly moves: number;
}
interface Of {
  text: string;
  /** Which task it is, however that is changed. */
  task: string;
}
const most = 10; // as `linkwright solve` prints where nothing else is asked

export class BestList {
  readonly question: Question<Of, Replies["best"]>;

  constructor(private readonly listed: Listed) {
    this.question = new Question(listed.questions, {same: (a, b) => a.text === b.text && a.task === b.task});
  }

  private get of(): Of {
    const {opened, moves, problem} = this.listed;
    return {text: engine_text(problem), task: `${opened} ${moves} ${map_of(problem.task)}`};
  }
  /** The last list of the task on screen, perhaps as it was a moment ago. */
  get found(): Replies["best"] | null {
    const {of, value} = this.question;
    return of?.task === this.of.task && !this.listed.incomplete ? value : null;
  }
  /** What is listed belongs to the task on screen. */
  get is_current(): boolean {
    return this.found !== null && this.question.is_of(this.of);
  }
  /** The engine is at it. */
  get busy(): boolean {
    return this.question.busy;
  }
  /** Stops what is under way for another task: the map of this one would wait for it. */
  let_go(): void {
    if (!this.question.is_asked(this.of)) this.question.drop();
  }
  /** Fetches the list of the task as it is, unless it is there or on its way. */
  async fetch(): Promise<void> {
    const {engine, incomplete} = this.listed,
      {of} = this;
    if (!engine || incomplete || this.is_current) return;
    await this.question.ask(of, (signal) => engine.run({kind: "best", problem: of.text, most}, {signal}));
  }
}
