import EngineWorker from "./worker?worker";

interface Started {
  engine_state: "loading" | "ready" | "missing" | "slow";
  connect(start: () => Worker, cores: number): void;
}
/** Starts the engine's workers, or says that this browser cannot. */
export function start_engine(page: Started): void {
  if (typeof WebAssembly !== "object") {
    page.engine_state = "missing";
    return;
  }
  page.connect(() => new EngineWorker(), navigator.hardwareConcurrency || 2);
}
