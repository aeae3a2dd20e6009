// A body that is turned by hand, by a ring about one of its axes: one gesture, and what comes of it when the engine has said.
import type {Rings} from "../sphere/SphereStage.svelte";
import type {Workbench} from "../state/workbench.svelte";
import {t} from "../texts/texts.svelte";

/** `from`: what was held when it began. */
export interface Turn<From> {
  from: From;
  axis: number;
  /** Since then, to a tenth. */
  angle_deg: number;
}
interface Turned<From> {
  /** What is taken hold of now; null: nothing. */
  held(): From | null;
  /** Asks what comes of it. */
  ask(turn: Turn<From>): void;
  /** That what is asked is asked by. */
  readonly question: {readonly underway: Promise<unknown>};
}

/** What `linkwright attitude` and the page's report on an orientation call a turn. */
export function turn_of({axis, angle_deg}: Pick<Turn<unknown>, "axis" | "angle_deg">): {
  axis: number[];
  angle_deg: number;
} {
  return {axis: [0, 1, 2].map((k) => Number(k === axis)), angle_deg};
}

export class Turning<From> {
  now = $state.raw<Turn<From> | null>(null);

  constructor(
    private readonly workbench: Workbench,
    private readonly turned: Turned<From>,
  ) {}

  /** The rings to hold it by. */
  rings(of: Pick<Rings, "frame" | "radius" | "value">): Rings {
    const name = (axis: string) => t("orientation.ring", {axis});
    return {
      ...of,
      names: [name("x"), name("y"), name("z")],
      begin: (axis) => this.begin(axis),
      turn: (angle_deg) => this.turn(angle_deg),
      end: () => void this.end(),
      cancel: () => this.cancel(),
      step: (axis, angle_deg) => void this.step(axis, angle_deg),
    };
  }

  begin(axis: number): void {
    const from = this.turned.held();
    if (from === null) return;
    this.workbench.playing = false;
    this.workbench.begin_gesture();
    this.now = {from, axis, angle_deg: 0};
  }
  turn(angle_deg: number): void {
    if (!this.now) return;
    if (!this.workbench.gesture) return void (this.now = null); // taken back meanwhile
    const rounded = Math.round(angle_deg * 10) / 10;
    if (rounded === this.now.angle_deg) return;
    this.now = {...this.now, angle_deg: rounded};
    this.turned.ask(this.now);
  }
  async end(): Promise<void> {
    await this.turned.question.underway;
    this.now = null;
    this.workbench.end_gesture();
  }
  cancel(): void {
    this.now = null;
    this.workbench.cancel_gesture();
  }
  /** By keys: a turn at once. */
  async step(axis: number, angle_deg: number): Promise<void> {
    if (this.now) return;
    this.begin(axis);
    this.turn(angle_deg);
    await this.end();
  }
}
