import type {Workbench} from "../state/workbench.svelte";
import type {Scene} from "./scene.svelte";

/** What the drawing's own drags and actions work on. */
export interface Bench {
  workbench: Workbench;
  scene: Scene;
}
