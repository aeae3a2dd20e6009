// What the engine has answered, each answer with the problem that it answers. Nothing is shown of a task that has no
// linkage; what belongs to an earlier problem than the one in force is outdated once it has been so for a moment.
import {gives_linkage, kind_of} from "../tasks/kinds";
import type {Census, Linkage, Live, MapAnswer, Replies, TaskAnswer, TauPair} from "../engine/protocol";
import {same_tau} from "./document";
import {same_question, type Problem} from "./problem";

/** So long the last answer stands for the next one: in a drag each comes a few frames late. */
export const patience_ms = 400;

interface Answer<T> {
  is: T;
  of: Problem;
}
/** Where a part of the task may go with linkages left. */
export type Halo = Replies["halo"] & {part: number; mode: "move" | "turn"};

/** Whether the answer on screen has been waiting for its successor for too long. */
class Wait {
  over = $state(false);
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly behind: () => boolean) {}
  /** Something else is asked. */
  begin(): void {
    if (!this.behind()) return this.end();
    this.timer ??= setTimeout(() => {
      this.timer = undefined;
      this.over = this.behind();
    }, patience_ms);
  }
  /** Something has been answered, perhaps not the last that was asked. */
  answered(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.begin();
  }
  private end(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.over = false;
  }
}

export class Answers {
  private explored = $state.raw<Answer<{task: TaskAnswer; map: MapAnswer | null}> | null>(null);
  private counted = $state.raw<Answer<Census> | null>(null);
  private held = $state.raw<Answer<Linkage> | null>(null);
  private picked = $state.raw<Answer<Linkage> | null>(null);
  private along = $state.raw<Live | null>(null);

  halo = $state.raw<Halo | null>(null);
  /** A better linkage nearby is being looked for. */
  improving = $state(false);
  /** How far the yields of the map on screen are sampled; null: they are not, or not yet. */
  yields = $state.raw<Replies["yields"] | null>(null);
  /** What the last map took the engine. */
  engine_ms = $state(0);

  private readonly map_wait: Wait;
  private readonly census_wait: Wait;
  private readonly hand_wait: Wait;

  /** `asked`: the problem in force and the linkage that is to be in hand. */
  constructor(private readonly asked: () => {problem: Problem; tau: TauPair | null}) {
    this.map_wait = new Wait(() => this.explored !== null && !this.answers(this.explored));
    this.census_wait = new Wait(() => this.census !== null && !this.answers(this.counted!));
    this.hand_wait = new Wait(
      () => this.hand !== null && !(this.hand_is_of_present && same_tau(this.held!.is.tau, this.asked().tau)),
    );
  }

  // ---- what there is ------------------------------------------------------------------------------------------

  get task(): TaskAnswer | null {
    return this.explored?.is.task ?? null;
  }
  get map(): MapAnswer | null {
    return this.explored?.is.map ?? null;
  }
  get census(): Census | null {
    return this.map && this.counted ? this.counted.is : null;
  }
  get hand(): Linkage | null {
    return this.shown(this.held);
  }
  get picked_linkage(): Linkage | null {
    return this.shown(this.picked);
  }
  /** A linkage of another kind is put together otherwise: it cannot stand for the one that is to come. */
  private shown(linkage: Answer<Linkage> | null): Linkage | null {
    const fits = linkage && this.has_linkages && kind_of(linkage.of.task) === kind_of(this.asked().problem.task);
    return fits ? linkage.is : null;
  }
  get live(): Live | null {
    return this.hand ? this.along : null;
  }
  get map_is_of_present(): boolean {
    return this.explored !== null && this.answers(this.explored);
  }
  get hand_is_of_present(): boolean {
    return this.hand !== null && this.answers(this.held!);
  }
  get map_outdated(): boolean {
    return this.map_wait.over && this.explored !== null;
  }
  get census_outdated(): boolean {
    return this.census_wait.over && this.census !== null;
  }
  get hand_outdated(): boolean {
    return this.hand_wait.over && this.hand !== null;
  }
  /** Whether the linkage in hand is this one of the problem. */
  hand_is(tau: TauPair | null, problem: Problem): boolean {
    return this.held !== null && same_tau(this.held.is.tau, tau) && same_question(this.held.of, problem);
  }
  /** Whether the picked linkage is that of the problem: it may still be of the one before. */
  picked_is_of(problem: Problem): boolean {
    return this.picked !== null && same_question(this.picked.of, problem);
  }
  private get has_linkages(): boolean {
    const {task} = this.asked().problem;
    if (!gives_linkage(task)) return this.explored?.is.task.status === "solved";
    return this.held !== null && kind_of(this.held.of.task) === kind_of(task); // not that of the task before
  }
  private answers({of}: Answer<unknown>): boolean {
    return same_question(of, this.asked().problem);
  }

  // ---- what comes ---------------------------------------------------------------------------------------------

  /** The problem in force, or the linkage asked for, is another. */
  asked_anew(): void {
    for (const wait of [this.map_wait, this.census_wait, this.hand_wait]) wait.begin();
  }
  take_map(task: TaskAnswer, map: MapAnswer | null, of: Problem): void {
    this.explored = {is: {task, map}, of};
    if (!map) this.counted = this.held = this.picked = this.along = null;
    this.map_wait.answered();
  }
  take_census(census: Census, of: Problem): void {
    this.counted = {is: census, of};
    this.census_wait.answered();
  }
  take_hand(linkage: Linkage | null, of: Problem): void {
    this.held = linkage && {is: linkage, of};
    if (!linkage) this.along = null;
    this.hand_wait.answered();
  }
  take_picked(linkage: Linkage, of: Problem): void {
    this.picked = {is: linkage, of};
  }
  take_live(live: Live | null): void {
    this.along = live;
  }
  /** The problem has no map. */
  forget_map(): void {
    this.explored = this.counted = this.along = null;
  }
  /** The problem is not one that can be asked. */
  forget(): void {
    this.explored = this.counted = this.held = this.picked = this.along = null;
    this.asked_anew();
  }
}
