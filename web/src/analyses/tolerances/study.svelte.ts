// What tolerances do to the linkage in hand, once it rests there: by all samples, some of which are drawn.
import type {EngineClient} from "../../engine/client";
import type {Linkage, Replies, TauPair, ToleranceAnswer, ToleranceFigures} from "../../contract/messages";
import {Question} from "../../questions/question.svelte";
import type {Questions} from "../../questions/questions";
import {same_linkage, same_tau, type LinkageOf} from "../../state/document";
import {engine_text, type Problem} from "../../state/problem";
import type {Workbench} from "../../state/workbench.svelte";
import {tolerances_of} from "./block";

interface Studied {
  readonly questions: Questions;
  readonly driver_client: EngineClient | null;
  readonly problem: Problem;
  readonly hovered: TauPair | null;
  readonly tau_in_hand: TauPair | null;
  readonly hand: Linkage | null;
  readonly answers: {readonly hand_is_of_present: boolean};
}
export const magnifications = [1, 10, 100] as const;
export type Magnification = (typeof magnifications)[number];

const bins = 40,
  drawn = 200;
const shortest_rest_ms = 80,
  longest_rest_ms = 600; // of the pointer, before it is worth the engine's while: as long as the last answer took

/** Of the page. */
export function tolerance_study_of(workbench: Workbench): ToleranceStudy {
  return workbench.study("tolerances", () => new ToleranceStudy(workbench));
}
export class ToleranceStudy {
  /** How much larger than they are the samples' deviations are drawn; nobody is to come upon the page with them so. */
  magnification = $state<Magnification>(1);
  private readonly question: Question<LinkageOf, Replies["tolerance"]>;

  constructor(private readonly studied: Studied) {
    this.question = new Question(studied.questions, {same: same_linkage});
  }

  /** Of the linkage that was studied last. */
  get found(): ToleranceAnswer | null {
    const {value} = this.question;
    return value?.tolerance ? (value as ToleranceAnswer) : null;
  }
  /** It is of the very linkage in hand, made to the tolerances as they are or, for a moment, were. */
  get of_hand(): ToleranceAnswer | null {
    return same_tau(this.question.of?.tau, this.studied.tau_in_hand) ? this.found : null;
  }
  /** Of all samples, or of the few that come with the linkage. */
  get figures(): ToleranceFigures | null {
    const {problem, hand, tau_in_hand} = this.studied;
    if (!tolerances_of(problem)) return null;
    const is_of_hand = tau_in_hand && this.question.is_of({problem, tau: tau_in_hand});
    return (is_of_hand && this.found?.tolerance) || (hand?.tolerance ?? null);
  }

  /** The linkage in hand, or what it is made to, may be another. */
  follow(): void {
    const {problem, hand, hovered, tau_in_hand, answers, driver_client} = this.studied,
      {question} = this;
    if (!tolerances_of(problem)) return question.forget();
    if (!hand || !answers.hand_is_of_present || !same_tau(hand.tau, tau_in_hand)) return question.hold(); // it comes back with it
    const of = {problem, tau: hand.tau};
    if (!driver_client || question.is_of(of)) return question.drop();
    const asked = {problem: engine_text(problem), tau: hand.tau, bins, drawn},
      rest_ms = hovered ? Math.min(Math.max(question.took_ms, shortest_rest_ms), longest_rest_ms) : 0;
    void question.ask(of, () => driver_client.follow("tolerance", asked), {rest_ms});
  }
}
