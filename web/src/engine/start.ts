/** Starts a worker with an engine in it (worker.ts): an EngineClient talks to it. */
export const start_worker = (): Worker => new Worker(new URL("./worker.ts", import.meta.url), {type: "module"});

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
  page.connect(start_worker, navigator.hardwareConcurrency || 2);
}
