// Puts better linkages in hand: the best of all, the best of the next type, the best nearby.
import type {EngineClient} from "../engine/client";
import {degenerate} from "../contract/messages";
import type {Linkage, MapAnswer, Picked, Replies, TauPair} from "../contract/messages";
import {Question} from "../questions/question.svelte";
import type {Questions} from "../questions/questions";
import type {TextKey, Values} from "../texts/texts.svelte";
import type {Answers} from "./answers.svelte";
import {same_tau} from "./document";
import {engine_text, type Problem} from "./problem";
import type {Toast} from "./toasts";

interface Sought {
  readonly questions: Questions;
  readonly driver_client: EngineClient | null;
  readonly answers: Answers;
  readonly problem: Problem;
  readonly picked: Picked | null;
  readonly is_current: boolean;
  readonly gesture: boolean;
  just_changed: boolean;
  /** A step. */
  pick(tau: TauPair): void;
  /** In hand without a step. */
  put(tau: TauPair): void;
  say(key: TextKey, values?: Values, action?: Toast["action"]): void;
}

const at_rest_ms = 300; // after the last of several changes
const listed = 20; // among which the best of each type is looked for

export class BestSeeker {
  private met = false; // the picked linkage met all that was required, before the last change
  private readonly best: Question<object, Replies["best"]>;
  private readonly better: Question<object, Replies["improve"]>;
  private readonly next: Question<Problem, Replies["best"]>;
  private readonly left: Question<object, Replies["best"]>;

  constructor(private readonly sought: Sought) {
    this.best = new Question(sought.questions);
    this.next = new Question(sought.questions);
    this.left = new Question(sought.questions);
    this.better = new Question(sought.questions);
  }

  /** The best linkage was asked for; the answer may put it in hand. */
  get seeking(): boolean {
    return this.best.busy;
  }
  /** A better linkage nearby is being looked for. */
  get improving(): boolean {
    return this.better.busy;
  }
  /** Of a task in which nothing was picked yet: no step. */
  start(): void {
    if (!this.seeking) void this.pick_best(true);
  }
  async pick_best(quietly = false): Promise<void> {
    const {sought} = this,
      {problem, answers} = sought,
      client = sought.driver_client;
    if (!client) return;
    const reply = await this.best.ask({}, (signal) =>
      client.run({kind: "best", problem: engine_text(problem), most: 1}, {signal}),
    );
    if (this.seeking) return; // another search goes on in its place
    if (sought.problem !== problem) {
      if (quietly && sought.is_current && !sought.picked) this.start(); // its map came meanwhile
      return;
    }
    if (!reply) return;
    if (reply.linkages.length) this.met = true; // a change that follows at once has cost it
    const tau = reply.linkages[0]?.tau ?? (quietly && answers.map ? least_bad(answers.map) : null);
    if (tau && quietly) sought.put(tau);
    else if (tau) sought.pick(tau);
    else if (!quietly) sought.say("state.nothing_to_go_to");
  }
  /** The next local best of another type, or the one before. */
  async pick_next_best(step: 1 | -1): Promise<void> {
    const {sought} = this,
      {problem, driver_client: client} = sought;
    if (!client) return;
    const reply = await this.next.ask(problem, (signal) =>
      client.run({kind: "best", problem: engine_text(problem), most: listed}, {signal}),
    );
    if (!reply || sought.problem !== problem) return;
    const firsts = reply.linkages.filter((a, i, all) => all.findIndex((b) => b.type === a.type) === i);
    const {picked} = sought, // one step on, perhaps, for each time that it was asked for meanwhile
      picked_now = reply.linkages.find(({tau}) => same_tau(tau, picked?.tau)) ?? sought.answers.picked_linkage;
    const now = firsts.findIndex(({type}) => type === picked_now?.type);
    const next = firsts[(now + step + firsts.length) % firsts.length];
    if (next && !same_tau(picked?.tau, next.tau)) sought.pick(next.tau);
  }
  async improve(): Promise<void> {
    const {sought} = this,
      {problem, picked, driver_client: client} = sought;
    if (!picked || !client) return;
    const reply = await this.better.ask({}, (signal) =>
      client.run({kind: "improve", problem: engine_text(problem), tau: picked.tau}, {signal}),
    );
    if (!reply || sought.problem !== problem) return;
    if (reply.improved) sought.pick(reply.tau);
    else sought.say("state.cannot_improve");
  }

  // ---- after a change ---------------------------------------------------------------------------------------------

  /** The picked linkage of the problem in force is known. */
  weigh({fails}: Linkage): void {
    const {sought} = this;
    if (!sought.just_changed) this.met = fails === 0;
    else if (fails === 0 || !this.met) [sought.just_changed, this.met] = [false, fails === 0];
    else void this.leave_what_fails();
  }
  /** A change that has cost the picked linkage: the best that is left takes its place, in the change's own step. */
  private async leave_what_fails(): Promise<void> {
    const {sought} = this,
      {problem, picked, driver_client: client} = sought;
    const still = () =>
      sought.just_changed && !sought.gesture && sought.problem === problem && same_tau(sought.picked?.tau, picked?.tau);
    const request = async (signal: AbortSignal) =>
      client && still() ? client.run({kind: "best", problem: engine_text(problem), most: 1}, {signal}) : null;
    const reply = await this.left.ask({}, request, {rest_ms: at_rest_ms});
    if (!reply || !still()) return;
    sought.just_changed = this.met = false;
    const best = reply.linkages[0];
    if (!best || !picked) return; // the map says what stands in the way
    sought.put(best.tau);
    sought.say("state.went_to_best", {}, {key: "state.keep_old", run: () => sought.pick(picked.tau)});
  }
}

const few_cells = 16;
/** Of a few linkages one is in hand even where none will do: the one with the least against it. */
function least_bad({type, defects, fails, columns, input_tau, output_tau}: MapAnswer): TauPair | null {
  if (type.length > few_cells) return null;
  const against = (cell: number) =>
    (defects[cell] ? 100 : 0) + [...fails[cell]!.toString(2)].filter((bit) => bit === "1").length;
  const [best] = [...type.keys()].filter((cell) => type[cell]! !== degenerate).sort((a, b) => against(a) - against(b));
  return best === undefined ? null : [input_tau[Math.floor(best / columns)]!, output_tau[best % columns]!];
}
