// Shows where a part of the task may go with linkages left, while it is held or before it is touched.
import type {EngineClient} from "../engine/client";
import {null_if_refused, Question} from "../questions/question.svelte";
import type {Questions} from "../questions/questions";
import type {Answers, Halo} from "./answers.svelte";
import type {TaskDocument} from "./document";
import {most_of} from "./ends";
import {engine_text, poses_extent, round_step} from "./problem";
import type {Pose} from "./task";

interface Held {
  readonly questions: Questions;
  readonly driver_client: EngineClient | null;
  readonly answers: Answers;
  readonly document: TaskDocument;
  readonly gesture: boolean;
}

const first_steps = 13,
  turn_steps = 61,
  fine_steps = 25, // once the hand rests
  samples = 60; // of the map behind each place
const at_rest_ms = 300,
  longest_ms = 400; // what is finer must not keep the linkage in hand waiting

/** Thirteen squares side by side, of a round size, make about an eighth of the poses' extent to each side. */
export function halo_reach(poses: readonly Pose[]): number {
  const step = poses_extent(poses) / 48,
    up = round_step(step);
  const down = round_step((step / 2.5) * 1.0001);
  return 6 * (up / step < step / down ? up : down);
}

export class HaloFollower {
  private readonly question: Question<object, Halo>;

  constructor(private readonly held: Held) {
    this.question = new Question(held.questions);
  }

  private async ask(part: number, mode: Halo["mode"], reach: number, steps: number): Promise<Halo | null> {
    const problem = engine_text(this.held.document.problem);
    const reply = await this.held.driver_client?.follow("halo", {problem, part, mode, reach, steps, samples});
    return reply ? {...reply, part, mode} : null;
  }
  /** The position which has the most room: a newcomer is to drag it. Nothing where it is not `wanted` any more. */
  async offer(poses: number, reach: number, wanted: () => boolean): Promise<void> {
    await this.question.ask({}, (signal) => this.roomiest(poses, reach, () => !signal.aborted && wanted()), {
      at_leisure: true,
    });
  }
  private async roomiest(poses: number, reach: number, wanted: () => boolean): Promise<Halo | null> {
    const {problem} = this.held.document;
    let best: {room: number; halo: Halo | null} = {room: 0, halo: null};
    for (let pose = 0; pose < poses && this.held.document.problem === problem; ++pose) {
      const halo = await this.ask(pose, "move", reach, first_steps).catch(null_if_refused),
        room = halo ? roomy_squares(halo.counts) : 0;
      if (room > best.room) best = {room, halo};
    }
    if (this.held.document.problem === problem && !this.held.gesture && wanted()) this.held.answers.halo = best.halo;
    return best.halo;
  }
  /** Nothing is held any more. */
  release(): void {
    this.question.drop();
    this.held.answers.halo = null;
  }
  /** Steps² cells of a square, or steps of an arc. Closer where the room that is left is near, finer once the hand rests. */
  async follow(part: number, mode: Halo["mode"], reach: number): Promise<void> {
    await this.question.ask({}, (signal) => this.look(part, mode, reach, signal), {at_leisure: true});
  }
  private async look(part: number, mode: Halo["mode"], reach: number, signal: AbortSignal): Promise<Halo | null> {
    const {held} = this,
      is_held = () => held.gesture && !signal.aborted;
    const show = async (steps: number) => {
      const halo = await this.ask(part, mode, reach, steps);
      if (halo && is_held()) held.answers.halo = halo;
      return halo;
    };
    let halo = await show(mode === "turn" ? turn_steps : first_steps);
    if (mode === "turn") return halo;
    for (let closer = 0; closer < 2 && halo && is_held() && in_inner_half(halo.counts, first_steps); ++closer) {
      reach /= 2;
      halo = await show(first_steps);
    }
    const finer_ms = (halo?.engine_ms ?? Infinity) * (fine_steps / first_steps) ** 2;
    let seen = held.document;
    while (is_held() && finer_ms < longest_ms) {
      await new Promise((resolve) => setTimeout(resolve, at_rest_ms));
      if (held.document === seen) return is_held() ? show(fine_steps) : null;
      seen = held.document;
    }
    return halo;
  }
}

/** Squares of a halo with so many of its 60² cells: hundreds of the usual map's. */
export function roomy_squares(counts: ArrayLike<number>): number {
  const enough = 5;
  return Array.from(counts).filter((count) => count >= enough).length;
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
