// Keeps the picked linkage and the one in hand up to the document and the pointer, and asks for better ones.
import {Crashed, Refusal, type EngineClient} from "../engine/client";
import type {Linkage, MapAnswer, TauPair} from "../engine/protocol";
import {places_of} from "./axis";
import {same_tau} from "./document";
import {engine_text, type Problem} from "./problem";
import type {Workbench} from "./workbench.svelte";
import {most_of} from "./ends";

const slow_ms = 100,
  at_rest_ms = 300; // after the last of several changes

export class LinkageFollower {
  private verified_for = "";
  private met = false; // the picked linkage met all that was required, before the last change
  private live_ms = 0; // what the last live part took

  /** The best linkage was asked for; the answer may put it in hand. */
  seeking_best = false;

  constructor(private readonly workbench: Workbench) {}

  private get driver(): EngineClient | null {
    return this.workbench.driver_client;
  }

  // ---- in hand ------------------------------------------------------------------------------------------------

  /** Something else is hovered, or nothing. */
  hover(): void {
    const {hovered, picked, picked_linkage, problem} = this.workbench;
    if (hovered) void this.fetch_hand();
    else if (
      picked_linkage &&
      this.workbench.answers.picked_is_of(problem) &&
      same_tau(picked_linkage.tau, picked?.tau)
    ) {
      this.workbench.answers.take_hand(picked_linkage, problem);
      void this.fetch_live();
    } else this.follow();
  }
  /** Fetches what the linkage in hand is now. */
  follow(): void {
    this.workbench.answers.asked_anew();
    if (this.workbench.task?.status === "solved") void this.fetch_hand();
  }
  private async fetch_hand(): Promise<void> {
    const {workbench} = this,
      {tau_in_hand: tau, problem} = workbench;
    if (!tau || !this.driver) return workbench.answers.take_hand(null, problem);
    try {
      const {linkage} = await this.driver.request("linkage", {problem: engine_text(problem), tau});
      if (workbench.incomplete || !same_tau(workbench.tau_in_hand, tau)) return;
      workbench.answers.take_hand(linkage, problem);
      void this.fetch_live();
      if (same_tau(tau, workbench.picked?.tau)) this.take_picked(linkage, problem);
    } catch (error) {
      if (error instanceof Crashed) setTimeout(() => this.follow(), 50);
      else if (error instanceof Refusal && workbench.problem === problem && same_tau(workbench.tau_in_hand, tau))
        workbench.answers.take_hand(null, problem);
    }
  }
  private async fetch_live(): Promise<void> {
    const {tau_in_hand: tau, problem, hovered, gesture} = this.workbench;
    if (!tau || !this.driver) return;
    if (this.live_ms > slow_ms && (hovered || gesture)) return this.workbench.answers.take_live(null); // the next linkage would wait for it
    const start = performance.now(),
      reply = await this.driver.request("live", {problem: engine_text(problem), tau}).catch(() => null);
    this.live_ms = performance.now() - start;
    if (reply) this.workbench.answers.take_live(reply);
  }
  private take_picked(linkage: Linkage, problem: Problem): void {
    const {workbench} = this;
    workbench.answers.take_picked(linkage, problem);
    if (workbench.gesture) return;
    void this.fetch_verified(linkage.tau, problem);
    if (workbench.problem !== problem) return; // the change was made meanwhile: this is of before
    if (!workbench.just_changed) this.met = linkage.fails === 0;
    else if (linkage.fails === 0 || !this.met) [workbench.just_changed, this.met] = [false, linkage.fails === 0];
    else void this.leave_what_fails();
  }
  private async fetch_verified(tau: TauPair, problem: Problem): Promise<void> {
    const text = engine_text(problem),
      asked = text + tau.join();
    if (asked === this.verified_for && this.workbench.verified) return;
    this.verified_for = asked;
    const reply = await this.driver!.request("verify", {problem: text, tau}).catch(() => null);
    if (reply) this.workbench.answers.take_verdict(reply, tau, problem);
  }
  /** After a change that has cost the picked linkage the best that is left takes its place, in the change's own step. */
  private async leave_what_fails(): Promise<void> {
    const {workbench} = this,
      {problem, picked} = workbench;
    const still = () =>
      workbench.just_changed &&
      !workbench.gesture &&
      workbench.problem === problem &&
      same_tau(workbench.picked?.tau, picked?.tau);
    await new Promise((resolve) => setTimeout(resolve, at_rest_ms));
    if (!still()) return;
    const reply = await this.driver!.request("best", {problem: engine_text(problem), most: 1}).catch(() => null);
    if (!reply || !still()) return;
    workbench.just_changed = this.met = false;
    const best = reply.linkages[0];
    if (!best || !picked) return; // the map says what stands in the way
    this.put(best.tau);
    workbench.say("state.went_to_best", {}, {key: "state.keep_old", run: () => workbench.pick(picked.tau)});
  }
  /** In hand without a step. */
  private put(tau: TauPair): void {
    const {workbench} = this;
    workbench.amend({picked: {tau, place: workbench.task && places_of(workbench.task.axes, tau)}});
    this.follow();
  }

  // ---- better ones --------------------------------------------------------------------------------------------

  /** Of a task in which nothing was picked yet: no step. */
  start_with_best(): void {
    if (!this.seeking_best) void this.pick_best(true);
  }
  async pick_best(quietly = false): Promise<void> {
    if (!this.driver) return;
    const {workbench} = this,
      {problem} = workbench;
    this.seeking_best = true;
    const reply = await this.driver.request("best", {problem: engine_text(problem), most: 1}).catch(() => null);
    this.seeking_best = false;
    if (workbench.problem !== problem) {
      if (quietly && workbench.is_current && !workbench.picked) this.start_with_best(); // its map came meanwhile
      return;
    }
    if (!reply) return;
    const tau = reply.linkages[0]?.tau ?? (quietly && workbench.map ? least_bad(workbench.map) : null);
    if (!tau) {
      if (!quietly) workbench.say("state.nothing_to_go_to");
      return;
    }
    if (!quietly) return workbench.pick(tau);
    this.put(tau);
  }
  async pick_next_best(step: 1 | -1): Promise<void> {
    const {workbench} = this,
      {problem, picked} = workbench;
    const reply = await this.driver?.request("best", {problem: engine_text(problem), most: 20}).catch(() => null);
    if (!reply || reply.linkages.length === 0 || workbench.problem !== problem) return;
    const firsts = reply.linkages.filter((a, i, all) => all.findIndex((b) => b.type === a.type) === i);
    const now = firsts.findIndex((first) => first.type === workbench.picked_linkage?.type);
    const next = firsts[(now + step + firsts.length) % firsts.length];
    if (!same_tau(picked?.tau, next.tau)) workbench.pick(next.tau);
  }
  async improve(): Promise<void> {
    const {workbench} = this,
      {problem, picked} = workbench;
    if (!picked || !this.driver) return;
    workbench.improving = true;
    const reply = await this.driver
      .request("improve", {problem: engine_text(problem), tau: picked.tau})
      .catch(() => null);
    workbench.improving = false;
    if (!reply || workbench.problem !== problem) return;
    if (reply.improved) workbench.pick(reply.tau);
    else workbench.say("state.cannot_improve");
  }
  /** The linkage at τ; nothing where the task has changed meanwhile or the engine does not answer. */
  async fetch(tau: TauPair): Promise<Linkage | null> {
    const {problem} = this.workbench;
    for (let tries = 0; tries < 3 && this.workbench.problem === problem; ++tries) {
      const {hand, answers} = this.workbench;
      if (hand && same_tau(hand.tau, tau) && answers.hand_is_of_present) return hand;
      const reply = await this.driver?.request("linkage", {problem: engine_text(problem), tau}).catch(() => null);
      if (reply) return this.workbench.problem === problem ? reply.linkage : null;
    }
    return null;
  }

  // ---- halo ---------------------------------------------------------------------------------------------------

  /** Shows where that position may go which has the most room with linkages left: a newcomer is to drag it. */
  async offer_halo(poses: number, reach: number): Promise<void> {
    const {workbench} = this,
      {problem} = workbench;
    let best: {room: number; halo: Workbench["halo"]} = {room: 0, halo: null};
    for (let pose = 0; pose < poses; ++pose) {
      const reply = await this.driver
        ?.request("halo", {problem: engine_text(problem), pose, mode: "move", reach, steps: 13, samples: 60})
        .catch(() => null);
      const room = reply ? roomy_squares(reply.counts) : 0;
      if (reply && room > best.room) best = {room, halo: {...reply, pose, mode: "move"}};
    }
    if (workbench.problem === problem && !workbench.gesture && workbench.tour === 0) workbench.halo = best.halo;
  }
  /** Steps² cells of a square, or steps of an arc. Closer where the room that is left is near, finer once the hand rests. */
  async fetch_halo(pose: number, mode: "move" | "turn", reach: number): Promise<void> {
    const {workbench} = this,
      {problem} = workbench,
      held = () => workbench.gesture && workbench.held_pose === pose;
    const ask = async (steps: number) => {
      const reply = await this.driver
        ?.request("halo", {problem: engine_text(problem), pose, mode, reach, steps, samples: 60})
        .catch(() => null);
      if (reply && held()) workbench.halo = {...reply, pose, mode};
      return reply;
    };
    let reply = await ask(mode === "turn" ? 61 : 13);
    if (mode === "turn") return;
    for (let closer = 0; closer < 2 && reply && held() && in_inner_half(reply.counts, 13); ++closer) {
      reach /= 2;
      reply = await ask(13);
    }
    let seen = workbench.document;
    while (held()) {
      await new Promise((resolve) => setTimeout(resolve, 300));
      if (workbench.document === seen) return void (await (held() && ask(25)));
      seen = workbench.document;
    }
  }
}

/** Squares of a halo with so many of its 60² cells: hundreds of the usual map's. */
export function roomy_squares(counts: ArrayLike<number>): number {
  const enough = 5;
  return Array.from(counts).filter((count) => count >= enough).length;
}

const few_cells = 16;
/** Of a few linkages one is in hand even where none will do: the one with the least against it. */
function least_bad({type, defects, fails, columns, input_tau, output_tau}: MapAnswer): TauPair | null {
  if (type.length > few_cells) return null;
  const against = (cell: number) =>
    (defects[cell] ? 100 : 0) + [...fails[cell].toString(2)].filter((bit) => bit === "1").length;
  const [best] = [...type.keys()].filter((cell) => type[cell] < 9).sort((a, b) => against(a) - against(b));
  return best === undefined ? null : [input_tau[Math.floor(best / columns)], output_tau[best % columns]];
}

/** Whether there is something, and nothing of it outside of the inner half of a square of steps² cells. */
function in_inner_half(counts: ArrayLike<number>, steps: number): boolean {
  const middle = (steps - 1) / 2;
  const distances = Array.from(counts, (count, i) =>
    count > 0 ? Math.max(Math.abs((i % steps) - middle), Math.abs(Math.floor(i / steps) - middle)) : -1,
  );
  const farthest = most_of(distances);
  return farthest >= 0 && farthest <= middle / 2;
}
