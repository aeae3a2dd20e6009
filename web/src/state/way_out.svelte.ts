// Where nothing is left: the smallest move of one position that leaves something. The halos of all positions say where
// that could be, a map of the task moved so has the last word.
import type {EngineClient} from "../engine/client";
import {whole, type Point, type Property} from "../contract/messages";
import {null_if_refused, Question} from "../questions/question.svelte";
import type {Questions} from "../questions/questions";
import {poses_of, type Pose} from "./task";
import type {Answers, Halo} from "./answers.svelte";
import {halo_reach} from "./halo_follower";
import {engine_text, type Problem} from "./problem";

export interface WayOut {
  /** From 0. */
  pose: number;
  by: Point;
  /** Linkages that meet all requirements then, on a map of 400². */
  meeting: number;
}
interface Stuck {
  readonly questions: Questions;
  readonly driver_client: EngineClient | null;
  readonly answers: Answers;
  readonly problem: Problem;
  readonly property: Property;
}
interface Found {
  way: WayOut;
  halo: Halo;
}
interface Search {
  client: EngineClient;
  signal: AbortSignal;
}
interface Move {
  by: Point;
  halo: Halo;
}
const reaches = [0.2, 1, 5], // of the usual halo: near first
  steps = 13,
  halo_samples = 60, // of the map behind each square
  enough = 5, // of its cells: fewer may be a chance
  samples = 400;

export class WayOutSeeker {
  private readonly question: Question<Problem, Found | "none">;

  /** `moved`: the problem with a pose of its own elsewhere. */
  constructor(
    private readonly stuck: Stuck,
    private readonly moved: (problem: Problem, pose: number, by: Point) => Problem,
  ) {
    this.question = new Question(stuck.questions);
  }

  private get answer(): Found | null {
    const {value} = this.question;
    return value === "none" ? null : value;
  }
  get found(): WayOut | null {
    return this.answer?.way ?? null;
  }
  /** Once for a problem. */
  seek(): void {
    const {problem, answers, driver_client: client} = this.stuck;
    if (!client || this.question.is_of(problem) || this.question.is_asked(problem)) return;
    this.forget();
    const request = async (signal: AbortSignal) => {
      const found = await this.look(problem, {client, signal});
      if (found !== "none" && !signal.aborted) answers.halo = found.halo;
      return found;
    };
    void this.question.ask(problem, request, {at_leisure: true});
  }
  /** There is something left, or the user is at work himself. */
  forget(): void {
    const {answers} = this.stuck;
    if (this.answer && answers.halo === this.answer.halo) answers.halo = null;
    this.question.forget();
  }
  private async look(problem: Problem, search: Search): Promise<Found | "none"> {
    const poses = poses_of(problem.task);
    for (const times of reaches)
      for (const {by, halo} of await this.moves(problem, poses, times * halo_reach(poses), search)) {
        const meeting = await this.count(this.moved(problem, halo.part, by), search);
        if (meeting === 0) continue;
        const way = {pose: halo.part, by, meeting};
        return {way, halo: times < 1 ? await this.wider(problem, halo, search) : halo};
      }
    return "none";
  }
  /** What is near is hidden by the position itself: the halo shows what lies about it, too. */
  private async wider(problem: Problem, halo: Halo, search: Search): Promise<Halo> {
    const usual = await this.halo_of(problem, halo.part, halo_reach(poses_of(problem.task)), search);
    return usual && nearest(usual, 1) ? usual : halo;
  }
  /** Of each position the nearest place with something left, the smallest move first. */
  private async moves(problem: Problem, poses: readonly Pose[], reach: number, search: Search): Promise<Move[]> {
    const found: Move[] = [];
    for (const pose of poses.keys()) {
      const halo = await this.halo_of(problem, pose, reach, search),
        by = halo && (nearest(halo, enough) ?? nearest(halo, 1));
      if (by) found.push({by, halo});
    }
    return found.sort((a, b) => size_of(a.by) - size_of(b.by));
  }
  private async halo_of(problem: Problem, part: number, reach: number, search: Search): Promise<Halo | null> {
    const asked = {kind: "halo", problem: engine_text(problem), part, mode: "move", reach, steps} as const;
    const reply = await search.client.run({...asked, samples: halo_samples}, search).catch(null_if_refused);
    return reply && {...reply, part, mode: "move"};
  }
  private async count(problem: Problem, search: Search): Promise<number> {
    const {property} = this.stuck;
    const asked = {kind: "explore", problem: engine_text(problem), samples, window: whole, property} as const;
    const reply = search.client.run({...asked, order: "fresh"}, search);
    return (await reply.catch(null_if_refused))?.map?.census.meeting ?? 0;
  }
}

export function size_of([x, y]: Point): number {
  return Math.hypot(x, y);
}
/** The nearest offset of a halo of squares with so many cells left. */
export function nearest({counts, steps, reach}: Pick<Halo, "counts" | "steps" | "reach">, least: number): Point | null {
  const at = (k: number) => Number((-reach + (k * 2 * reach) / (steps - 1)).toPrecision(10));
  let best: Point | null = null;
  for (const [i, count] of counts.entries()) {
    const offset: Point = [at(i % steps), at(Math.floor(i / steps))];
    if (count >= least && (!best || size_of(offset) < size_of(best))) best = offset;
  }
  return best;
}
