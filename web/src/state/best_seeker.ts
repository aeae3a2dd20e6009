// Puts better linkages in hand: the best of all, the best of the next type, the best nearby.
import type {EngineClient} from "../engine/client";
import {degenerate} from "../engine/protocol";
import type {Linkage, MapAnswer, Picked, TauPair} from "../engine/protocol";
import type {TextKey, Values} from "../texts/texts.svelte";
import type {Answers} from "./answers.svelte";
import {same_tau} from "./document";
import {engine_text, type Problem} from "./problem";
import type {Toast} from "./toasts";

interface Sought {
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
  /** The best linkage was asked for; the answer may put it in hand. */
  seeking = false;
  private met = false; // the picked linkage met all that was required, before the last change
  private search = new AbortController();

  constructor(private readonly sought: Sought) {}

  /** What the user asks for takes the place of what was asked before. */
  private begin(): {client: EngineClient; signal: AbortSignal} | null {
    const client = this.sought.driver_client;
    this.search.abort();
    this.search = new AbortController();
    return client && {client, signal: this.search.signal};
  }

  /** Of a task in which nothing was picked yet: no step. */
  start(): void {
    if (!this.seeking) void this.pick_best(true);
  }
  async pick_best(quietly = false): Promise<void> {
    const {sought} = this,
      {problem, answers} = sought,
      asked = this.begin();
    if (!asked) return;
    this.seeking = true;
    const reply = await asked.client
      .run({kind: "best", problem: engine_text(problem), most: 1}, asked)
      .catch(() => null);
    if (asked.signal.aborted) return; // another search goes on in its place
    this.seeking = false;
    if (sought.problem !== problem) {
      if (quietly && sought.is_current && !sought.picked) this.start(); // its map came meanwhile
      return;
    }
    if (!reply) return;
    const tau = reply.linkages[0]?.tau ?? (quietly && answers.map ? least_bad(answers.map) : null);
    if (tau && quietly) sought.put(tau);
    else if (tau) sought.pick(tau);
    else if (!quietly) sought.say("state.nothing_to_go_to");
  }
  /** The next local best of another type, or the one before. */
  async pick_next_best(step: 1 | -1): Promise<void> {
    const {sought} = this,
      {problem, picked} = sought,
      client = sought.driver_client;
    const reply = await client?.run({kind: "best", problem: engine_text(problem), most: listed}).catch(() => null);
    if (!reply || sought.problem !== problem) return;
    const firsts = reply.linkages.filter((a, i, all) => all.findIndex((b) => b.type === a.type) === i);
    const now = firsts.findIndex((first) => first.type === sought.answers.picked_linkage?.type);
    const next = firsts[(now + step + firsts.length) % firsts.length];
    if (next && !same_tau(picked?.tau, next.tau)) sought.pick(next.tau);
  }
  async improve(): Promise<void> {
    const {sought} = this,
      {problem, picked, answers} = sought,
      client = sought.driver_client;
    if (!picked || !client) return;
    answers.improving = true;
    const reply = await client.run({kind: "improve", problem: engine_text(problem), tau: picked.tau}).catch(() => null);
    answers.improving = false;
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
      {problem, picked} = sought;
    const still = () =>
      sought.just_changed && !sought.gesture && sought.problem === problem && same_tau(sought.picked?.tau, picked?.tau);
    await new Promise((resolve) => setTimeout(resolve, at_rest_ms));
    if (!still()) return;
    const reply = await sought.driver_client
      ?.run({kind: "best", problem: engine_text(problem), most: 1})
      .catch(() => null);
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
