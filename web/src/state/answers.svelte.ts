// What the engine has answered, each answer with the problem that it answers. Nothing is shown of a task that has no
// linkage; what belongs to an earlier problem than the one in force is outdated once it has been so for a moment.
import {gives_linkage, kind_of} from "../kinds/kind_dispatch";
import type {Census, Linkage, Live, MapAnswer, Replies, TaskAnswer, TauPair} from "../contract/messages";
import {Question} from "../questions/question.svelte";
import type {Questions} from "../questions/questions";
import {same_linkage, same_tau, type LinkageOf} from "./document";
import {same_question, type Problem} from "./problem";

/** Where a part of the task may go with linkages left. */
export type Halo = Replies["halo"] & {part: number; mode: "move" | "turn"};
interface Of {
  problem: Problem;
}
/** The problem in force, and which linkage is to be in hand. */
interface Asked {
  readonly problem: Problem;
  readonly tau_in_hand: TauPair | null;
}

export class Answers {
  readonly explored: Question<Of, Replies["explore"]>;
  readonly counted: Question<Of, Census>;
  readonly held: Question<LinkageOf, Linkage>;
  readonly picked: Question<LinkageOf, Linkage>;
  readonly along: Question<LinkageOf, Live>;

  halo = $state.raw<Halo | null>(null);
  /** How far the yields of the map on screen are sampled; null: they are not, or not yet. */
  yields = $state.raw<Replies["yields"] | null>(null);
  /** What the last map took the engine. */
  engine_ms = $state(0);

  constructor(
    questions: Questions,
    private readonly asked: Asked,
  ) {
    const is_present = ({problem}: Of) => same_question(problem, asked.problem);
    this.explored = new Question(questions, {follows: true, is_present});
    this.counted = new Question(questions, {is_present});
    this.held = new Question(questions, {
      same: same_linkage,
      is_present: (of) => is_present(of) && same_tau(of.tau, asked.tau_in_hand),
    });
    this.picked = new Question(questions);
    this.along = new Question(questions, {same: same_linkage});
  }

  // ---- what there is ------------------------------------------------------------------------------------------

  get task(): TaskAnswer | null {
    return this.explored.value?.task ?? null;
  }
  get map(): MapAnswer | null {
    return this.explored.value?.map ?? null;
  }
  get census(): Census | null {
    return this.map && this.counted.value;
  }
  // Most of the page is made of the linkage in hand, and is not to be made anew where only the problem is another.
  readonly hand = $derived.by(() => this.shown(this.held));
  readonly picked_linkage = $derived.by(() => this.shown(this.picked));
  /** A linkage of another kind is put together otherwise: it cannot stand for the one that is to come. */
  private shown({of, value}: Question<LinkageOf, Linkage>): Linkage | null {
    return of && this.has_linkages && kind_of(of.problem.task) === kind_of(this.asked.problem.task) ? value : null;
  }
  get live(): Live | null {
    return this.hand && this.along.value;
  }
  get map_is_of_present(): boolean {
    return this.explored.is_of_present;
  }
  /** Of the task in force, if not at the place asked for. */
  get hand_is_of_present(): boolean {
    return this.hand !== null && same_question(this.held.of!.problem, this.asked.problem);
  }
  get map_outdated(): boolean {
    return this.explored.stale;
  }
  get census_outdated(): boolean {
    return this.counted.stale && this.census !== null;
  }
  get hand_outdated(): boolean {
    return this.held.stale && this.hand !== null;
  }
  /** Whether the picked linkage is that of the problem: it may still be of the one before. */
  picked_is_of(problem: Problem): boolean {
    return this.picked.of !== null && same_question(this.picked.of.problem, problem);
  }
  private get has_linkages(): boolean {
    const {task} = this.asked.problem;
    if (!gives_linkage(task)) return this.task?.status === "solved";
    return this.held.of !== null && kind_of(this.held.of.problem.task) === kind_of(task); // not that of the task before
  }

  // ---- what comes ---------------------------------------------------------------------------------------------

  /** The problem in force, or the linkage asked for, is another. */
  asked_anew(): void {
    for (const question of [this.explored, this.counted, this.held]) question.compare();
  }
  take_hand(linkage: Linkage, problem: Problem): void {
    this.held.put({problem, tau: linkage.tau}, linkage);
  }
  take_picked(linkage: Linkage, problem: Problem): void {
    this.picked.put({problem, tau: linkage.tau}, linkage);
  }
  /** There is none. */
  forget_hand(): void {
    this.held.forget();
    this.along.forget();
  }
  /** There are no linkages. */
  forget_linkages(): void {
    this.forget_hand();
    this.counted.forget();
    this.picked.forget();
  }
  /** The problem has no map. */
  forget_map(): void {
    for (const question of [this.explored, this.counted, this.along]) question.forget();
  }
  /** The problem is not one that can be asked. */
  forget(): void {
    this.explored.forget();
    this.forget_linkages();
  }
}
