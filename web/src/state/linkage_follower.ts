// Keeps the linkage in hand and the picked one up to the document and the pointer.
import {Crashed, Refusal, type EngineClient} from "../engine/client";
import type {Linkage, Mistake, TauPair} from "../engine/protocol";
import type {Answers} from "./answers.svelte";
import {gives_linkage} from "../tasks/kinds";
import {same_tau, type Document, type Picked} from "./document";
import {engine_text, same_question, type Problem} from "./problem";

interface Followed {
  readonly driver_client: EngineClient | null;
  readonly answers: Answers;
  readonly problem: Problem;
  readonly document: Document;
  /** What the engine says of the problem where that is a linkage: nothing else asks it then. */
  accept(document: Document): void;
  refuse(problem: Problem, mistakes: Mistake[]): boolean;
  refresh(): void;
  /** Why the engine is not asked, where it is not. */
  readonly incomplete: object | null;
  readonly gesture: boolean;
  readonly hovered: TauPair | null;
  readonly picked: Picked | null;
  readonly tau_in_hand: TauPair | null;
}

const slow_ms = 100;

export class LinkageFollower {
  private verified_for = "";
  private live_ms = 0; // what the last live part took

  /** `weigh` hears of the picked linkage of the problem in force. */
  constructor(
    private readonly followed: Followed,
    private readonly weigh: (linkage: Linkage) => void,
  ) {}

  /** Something else is hovered, or nothing. */
  hover(): void {
    const {hovered, picked, problem, answers} = this.followed,
      known = answers.picked_linkage;
    if (hovered) void this.fetch_hand();
    else if (known && answers.picked_is_of(problem) && same_tau(known.tau, picked?.tau)) {
      answers.take_hand(known, problem);
      void this.fetch_live();
    } else this.follow();
  }
  /** Fetches what the linkage in hand is now; in a drag, of the task whose map is on screen: τ is a place on that. */
  follow(of = this.followed.problem): void {
    const {answers} = this.followed;
    answers.asked_anew();
    if (answers.task?.status === "solved" || gives_linkage(of.task)) void this.fetch_hand(of);
  }
  private async fetch_hand(problem = this.followed.problem): Promise<void> {
    const {followed} = this,
      {tau_in_hand: tau, document, answers, driver_client} = followed,
      is_given = gives_linkage(problem.task);
    if (!tau || !driver_client) return answers.take_hand(null, problem);
    try {
      const {linkage} = await driver_client.follow("linkage", {problem: engine_text(problem), tau});
      if (followed.incomplete || !same_tau(followed.tau_in_hand, tau)) return;
      answers.take_hand(linkage, problem);
      if (is_given) {
        answers.take_picked(linkage, problem);
        return followed.accept(document);
      }
      void this.fetch_live(problem);
      if (same_tau(tau, followed.picked?.tau)) this.take_picked(linkage, problem);
    } catch (error) {
      if (error instanceof Crashed) setTimeout(() => this.follow(), 50);
      else if (error instanceof Refusal && is_given) {
        if (followed.refuse(problem, error.mistakes) && followed.problem !== problem) followed.refresh(); // to what was good
      } else if (
        error instanceof Refusal &&
        same_question(followed.problem, problem) &&
        same_tau(followed.tau_in_hand, tau)
      )
        answers.take_hand(null, problem);
    }
  }
  private async fetch_live(problem = this.followed.problem): Promise<void> {
    const {tau_in_hand: tau, hovered, gesture, answers, driver_client} = this.followed;
    if (!tau || !driver_client) return;
    if (this.live_ms > slow_ms && (hovered || gesture)) return answers.take_live(null); // the next linkage would wait for it
    const start = performance.now(),
      reply = await driver_client.follow("live", {problem: engine_text(problem), tau}).catch(() => null);
    this.live_ms = performance.now() - start;
    if (reply) answers.take_live(reply);
  }
  private take_picked(linkage: Linkage, problem: Problem): void {
    const {followed} = this;
    followed.answers.take_picked(linkage, problem);
    if (followed.gesture) return;
    void this.fetch_verified(linkage.tau, problem);
    if (same_question(followed.problem, problem)) this.weigh(linkage); // else the change was made meanwhile: this is of before
  }
  private async fetch_verified(tau: TauPair, problem: Problem): Promise<void> {
    const {answers, driver_client} = this.followed,
      text = engine_text(problem),
      asked = text + tau.join();
    if (asked === this.verified_for && answers.verified) return;
    this.verified_for = asked;
    const reply = await driver_client?.follow("verify", {problem: text, tau}).catch(() => null);
    if (reply) answers.take_verdict(reply, tau, problem);
  }
  /** The linkage at τ; nothing where the task has changed meanwhile or the engine does not answer. */
  async fetch(tau: TauPair): Promise<Linkage | null> {
    const {followed} = this,
      {problem, answers, driver_client} = followed;
    const {hand} = answers;
    if (hand && same_tau(hand.tau, tau) && answers.hand_is_of_present) return hand;
    const reply = await driver_client?.run({kind: "linkage", problem: engine_text(problem), tau}).catch(() => null);
    return reply && followed.problem === problem ? reply.linkage : null;
  }
}
