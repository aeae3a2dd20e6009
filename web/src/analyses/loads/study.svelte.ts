// The forces in the linkage in hand, while its card is looked at.
import type {EngineClient} from "../../engine/client";
import type {Linkage, Replies, TauPair} from "../../contract/messages";
import type {LoadsReply} from "../../contract/replies";
import {Question} from "../../questions/question.svelte";
import type {Questions} from "../../questions/questions";
import {same_linkage, same_tau, type LinkageOf} from "../../state/document";
import {engine_text, type Problem} from "../../state/problem";
import type {Workbench} from "../../state/workbench.svelte";
import {cases_of, loads_of} from "./block";
import type {EffortChoice} from "./effort";

interface Studied {
  readonly questions: Questions;
  readonly driver_client: EngineClient | null;
  readonly problem: Problem;
  readonly tau_in_hand: TauPair | null;
  readonly hand: Linkage | null;
  readonly answers: {readonly held: {readonly of: LinkageOf | null}};
}

/** Of the page. */
export function load_study_of(workbench: Workbench): LoadStudy {
  return workbench.study("loads", () => new LoadStudy(workbench));
}
export class LoadStudy {
  /** The case that stands out in the plot, by its name. */
  private chosen = $state<string | null>(null);
  /** What the plot shows, and over what. */
  choice = $state.raw<EffortChoice>({});
  private readonly question: Question<LinkageOf, Replies["loads"]>;

  constructor(private readonly studied: Studied) {
    this.question = new Question(studied.questions, {same: same_linkage, follows: true});
  }

  /** Of the linkage that was asked of last; null: there is none yet, or it does not get through its positions in order. */
  get found(): LoadsReply | null {
    const {value} = this.question;
    return value?.loads ? (value as LoadsReply) : null;
  }
  get is_answered(): boolean {
    return this.question.value !== null;
  }
  /** It is of the very linkage in hand. */
  get is_of_hand(): boolean {
    return same_tau(this.question.of?.tau, this.studied.tau_in_hand);
  }
  /** By its place in the list of cases. */
  get case_index(): number {
    const loads = loads_of(this.studied.problem),
      at = loads ? cases_of(loads).findIndex(({name}) => name === this.chosen) : -1;
    return Math.max(at, 0);
  }
  choose(name: string): void {
    this.chosen = name;
  }

  /** The linkage in hand, or what acts on it, may be another. */
  follow(): void {
    const {problem, hand, tau_in_hand, answers, driver_client} = this.studied,
      {question} = this;
    if (!loads_of(problem)) return question.forget();
    const of_task = answers.held.of?.problem.task === problem.task; // loads move no linkage
    if (!hand || !of_task || !same_tau(hand.tau, tau_in_hand)) return question.hold();
    const of = {problem, tau: hand.tau};
    if (!driver_client || question.is_of(of)) return question.drop();
    void question.ask(of, () => driver_client.follow("loads", {problem: engine_text(problem), tau: hand.tau}));
  }
  /** Nobody looks any more. */
  rest(): void {
    this.question.hold();
  }
}
