// Keeps the linkage in hand and the picked one up to the document and the pointer.
import type {EngineClient, Refusal} from "../engine/client";
import type {Linkage, Mistake, Picked, Replies, TauPair} from "../contract/messages";
import {Question} from "../questions/question.svelte";
import type {Questions} from "../questions/questions";
import type {Answers} from "./answers.svelte";
import {gives_linkage, hurried} from "../kinds/kind_dispatch";
import {same_linkage, same_tau, type TaskDocument, type LinkageOf} from "./document";
import {engine_text, same_question, type Problem} from "./problem";
import {sharing} from "./sharing";

interface Followed {
  readonly questions: Questions;
  readonly driver_client: EngineClient | null;
  readonly answers: Answers;
  readonly problem: Problem;
  readonly document: TaskDocument;
  /** What the engine says of the problem where that is a linkage: nothing else asks it then. */
  accept(document: TaskDocument): void;
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
  /** What driving has found. */
  readonly verdict: Question<LinkageOf, Replies["verify"]>;
  private live_ms = 0; // what the last live part took the engine

  /** `weigh` hears of the picked linkage of the problem in force. */
  constructor(
    private readonly followed: Followed,
    private readonly weigh: (linkage: Linkage) => void,
  ) {
    this.verdict = new Question(followed.questions, {same: same_linkage});
  }

  /** Something else is hovered, or nothing. */
  hover(): void {
    const {hovered, picked, answers} = this.followed,
      known = answers.picked_linkage,
      of = this.on_screen;
    if (hovered) void this.fetch_hand(of);
    else if (known && answers.picked_is_of(of) && same_tau(known.tau, picked?.tau)) {
      answers.take_hand(known, of);
      void this.fetch_live(of);
    } else this.follow(of);
  }
  /** The task whose map is on screen, which a new one's is on its way to: τ is a place on that. */
  private get on_screen(): Problem {
    const {answers, problem} = this.followed;
    return answers.map_is_of_present ? problem : (answers.explored.of?.problem ?? problem);
  }
  /** Fetches what the linkage in hand is now; in a drag, of the task whose map is on screen: τ is a place on that. */
  follow(of = this.followed.problem): void {
    const {answers} = this.followed;
    answers.asked_anew();
    if (answers.task?.status === "solved" || gives_linkage(of.task)) void this.fetch_hand(of);
  }
  /** What a map on its way is to bring of it: where the map on screen is of the task, it is asked for without one. */
  get wanted(): {picked: Picked | null; live: boolean} {
    const {answers, hovered, picked} = this.followed,
      wanted = hovered ? {tau: hovered, place: null} : picked;
    return {picked: answers.map_is_of_present ? null : wanted, live: this.wants_live};
  }
  /** What a map has brought; what has come in hand meanwhile is still to be fetched. */
  take({linkage: found, live}: Replies["explore"], of: Problem): void {
    const {answers, tau_in_hand} = this.followed,
      linkage = found && sharing(found, answers.hand);
    if (linkage && same_tau(linkage.tau, tau_in_hand)) {
      answers.take_hand(linkage, of);
      this.take_live(live, {problem: of, tau: linkage.tau});
      this.note_hand(linkage, of);
    } else if (!tau_in_hand || !answers.held.is_of({problem: of, tau: tau_in_hand})) this.follow(of);
  }
  private async fetch_hand(problem = this.followed.problem): Promise<void> {
    const {tau_in_hand: tau, document, answers, driver_client} = this.followed;
    if (!tau || !driver_client) return answers.forget_hand();
    const request = async () => {
      const asked = this.followed.gesture ? hurried(problem) : problem,
        {linkage} = await driver_client.follow("linkage", {problem: engine_text(asked), tau});
      return same_tau(this.followed.tau_in_hand, tau) ? linkage : null;
    };
    await answers.held.ask({problem, tau}, request, {
      refused: (refusal) => this.not_held({problem, tau}, refusal),
      taken: (linkage) => {
        if (gives_linkage(problem.task)) {
          answers.take_picked(linkage, problem);
          return this.followed.accept(document);
        }
        void this.fetch_live(problem);
        this.note_hand(linkage, problem);
      },
    });
  }
  private not_held({problem, tau}: LinkageOf, {mistakes}: Refusal): void {
    const {followed} = this;
    if (gives_linkage(problem.task)) {
      if (followed.refuse(problem, mistakes) && followed.problem !== problem) followed.refresh(); // to what was good
    } else if (same_question(followed.problem, problem) && same_tau(followed.tau_in_hand, tau))
      followed.answers.forget_hand();
  }
  private async fetch_live(problem = this.followed.problem): Promise<void> {
    const {
      tau_in_hand: tau,
      driver_client,
      answers: {along},
    } = this.followed;
    if (!tau || !driver_client) return;
    if (!this.wants_live) return along.forget();
    const of = {problem, tau};
    await along.ask(of, async () => {
      const asked = this.followed.gesture ? hurried(problem) : problem,
        live = await driver_client.follow("live", {problem: engine_text(asked), tau});
      this.live_ms = live.engine_ms;
      return live;
    });
  }
  /** What comes next would wait for it. */
  private get wants_live(): boolean {
    return this.live_ms <= slow_ms || !(this.followed.hovered || this.followed.gesture);
  }
  private take_live(live: Replies["live"] | null, of: LinkageOf): void {
    const {along} = this.followed.answers;
    if (!live) return along.forget();
    this.live_ms = live.engine_ms;
    along.put(of, live);
  }
  private note_hand(linkage: Linkage, problem: Problem): void {
    if (same_tau(linkage.tau, this.followed.picked?.tau)) this.take_picked(linkage, problem);
  }
  private take_picked(linkage: Linkage, problem: Problem): void {
    const {followed} = this;
    followed.answers.take_picked(linkage, problem);
    if (followed.gesture) return;
    this.verify({problem, tau: linkage.tau});
    if (same_question(followed.problem, problem)) this.weigh(linkage); // else the change was made meanwhile: this is of before
  }
  private verify(of: LinkageOf): void {
    const {driver_client} = this.followed;
    if (!driver_client || this.verdict.is_of(of)) return;
    void this.verdict.ask(of, () => driver_client.follow("verify", {problem: engine_text(of.problem), tau: of.tau}));
  }
  /** The linkage at τ; nothing where the task has changed meanwhile or the engine does not answer. */
  async fetch(tau: TauPair): Promise<Linkage | null> {
    const {followed} = this,
      {problem, answers, driver_client} = followed;
    const {hand} = answers;
    if (hand && same_tau(hand.tau, tau) && answers.hand_is_of_present) return hand;
    if (!driver_client) return null;
    const pointed = new Question<TauPair, Linkage>(followed.questions), // each is wanted, whatever is pointed at next
      asked = {kind: "linkage", problem: engine_text(problem), tau} as const,
      linkage = await pointed.ask(tau, async (signal) => (await driver_client.run(asked, {signal})).linkage);
    return followed.problem === problem ? linkage : null;
  }
}
