// Where nothing is left: the smallest move of one position that leaves something. The halos of all positions say where
// that could be, a map of the task moved so has the last word.
import type {EngineClient} from "../engine/client";
import {whole, type Point, type Property} from "../engine/protocol";
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
  readonly driver_client: EngineClient | null;
  readonly answers: Answers;
  readonly problem: Problem;
  readonly property: Property;
  readonly gesture: boolean;
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
  found = $state.raw<WayOut | null>(null);
  private sought_for: Problem | null = null;
  private shown: Halo | null = null;
  private search = new AbortController();

  /** `moved`: the problem with a pose of its own elsewhere. */
  constructor(
    private readonly stuck: Stuck,
    private readonly moved: (problem: Problem, pose: number, by: Point) => Problem,
  ) {}

  /** Once for a problem. */
  seek(): void {
    const {problem} = this.stuck;
    if (this.sought_for === problem) return;
    this.forget();
    this.sought_for = problem;
    this.search = new AbortController();
    void this.look(problem);
  }
  /** There is something left, or the user is at work himself. */
  forget(): void {
    this.search.abort();
    this.sought_for = this.found = null;
    if (this.shown && this.stuck.answers.halo === this.shown) this.stuck.answers.halo = null;
    this.shown = null;
  }
  private async look(problem: Problem): Promise<void> {
    const poses = poses_of(problem.task);
    for (const times of reaches)
      for (const move of await this.moves(problem, poses, times * halo_reach(poses))) {
        const meeting = await this.count(this.moved(problem, move.halo.part, move.by));
        if (!this.is_wanted(problem)) return;
        if (meeting === 0) continue;
        this.found = {pose: move.halo.part, by: move.by, meeting};
        const halo = times < 1 ? await this.wider(problem, move.halo) : move.halo;
        if (this.is_wanted(problem)) this.stuck.answers.halo = this.shown = halo;
        return;
      }
  }
  /** What is near is hidden by the position itself: the halo shows what lies about it, too. */
  private async wider(problem: Problem, halo: Halo): Promise<Halo> {
    const usual = await this.halo_of(problem, halo.part, halo_reach(poses_of(problem.task)));
    return usual && nearest(usual, 1) ? usual : halo;
  }
  private is_wanted(problem: Problem): boolean {
    return this.sought_for === problem && this.stuck.problem === problem && !this.stuck.gesture;
  }
  /** Of each position the nearest place with something left, the smallest move first. */
  private async moves(problem: Problem, poses: readonly Pose[], reach: number): Promise<Move[]> {
    const found: Move[] = [];
    for (let pose = 0; pose < poses.length && this.is_wanted(problem); ++pose) {
      const halo = await this.halo_of(problem, pose, reach),
        by = halo && (nearest(halo, enough) ?? nearest(halo, 1));
      if (by) found.push({by, halo});
    }
    return found.sort((a, b) => size_of(a.by) - size_of(b.by));
  }
  private async halo_of(problem: Problem, part: number, reach: number): Promise<Halo | null> {
    const asked = {kind: "halo", problem: engine_text(problem), part, mode: "move", reach, steps} as const;
    const reply = await this.stuck.driver_client?.run({...asked, samples: halo_samples}, this.search).catch(() => null);
    return reply ? {...reply, part, mode: "move"} : null;
  }
  private async count(problem: Problem): Promise<number> {
    const {driver_client, property} = this.stuck;
    const asked = {kind: "explore", problem: engine_text(problem), samples, window: whole, property} as const;
    const reply = await driver_client?.run({...asked, order: "fresh"}, this.search).catch(() => null);
    return reply?.map?.census.meeting ?? 0;
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
