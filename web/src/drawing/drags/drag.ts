import type {Point} from "../../engine/protocol";
import {preferences} from "../../state/preferences.svelte";
import type {Workbench} from "../../state/workbench.svelte";
import type {Scene} from "../scene.svelte";
import {to_user, type Viewport} from "../viewport";
import type {Grid, Keys} from "../snapping";

/** What follows a pressed pointer. `move` comes after the pointer has moved by a few pixels; a press without a move
 *  ends in `cancel` and is a click. */
export interface Drag {
  cursor: string;
  move(at: Point, keys: Keys): void;
  end(): void;
  cancel(): void;
}
export interface Bench {
  workbench: Workbench;
  scene: Scene;
}

export const align_px = 6;

export function grid(scene: Scene, others: readonly {x: number; y: number}[] = []): Grid {
  return {
    step: scene.step,
    xs: others.map((o) => o.x),
    ys: others.map((o) => o.y),
    near: align_px / scene.view.scale,
    on: preferences.snap,
  };
}
export function pixel(view: Viewport): number {
  return 1 / view.scale;
}

/** The way of the pointer in user units, a tenth of it while Ctrl is down. */
export class Way {
  private last: Point;
  x = 0;
  y = 0;
  constructor(
    private readonly scene: Scene,
    from: Point,
  ) {
    this.last = from;
  }
  to(at: Point, keys: Keys): this {
    const a = to_user(this.scene.view, this.last),
      b = to_user(this.scene.view, at),
      share = keys.fine ? 0.1 : 1;
    this.x += (b[0] - a[0]) * share;
    this.y += (b[1] - a[1]) * share;
    this.last = at;
    return this;
  }
}

/** Ends or cancels one gesture, and takes away what only a drag shows. */
export function finish({workbench, scene}: Bench, keep: boolean): void {
  scene.held = scene.note = scene.pressed_pose = scene.anchor = scene.arm = scene.rubber = null;
  scene.guides = [];
  workbench.held_pose = null;
  if (keep) workbench.end_gesture();
  else workbench.cancel_gesture();
}
