import type {Workbench} from "../state/workbench.svelte";
import EngineWorker from "./worker?worker";

/** Starts the engine's workers, or says that this browser cannot. */
export function start_engine(workbench: Workbench): void {
  if (typeof WebAssembly !== "object") {
    workbench.engine_state = "missing";
    return;
  }
  workbench.connect(() => new EngineWorker(), navigator.hardwareConcurrency || 2);
}
