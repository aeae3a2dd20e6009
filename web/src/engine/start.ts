import {compile, type CodePart} from "./code";

/** Starts a worker with an engine in it (worker.ts): an EngineClient talks to it. The rest of its code follows once it runs. */
export function start_worker(): Worker {
  const worker = new Worker(new URL("./worker.ts", import.meta.url), {type: "module"});
  const hand_in = async (part: CodePart) => worker.postMessage({[part]: await compile(part)});
  hand_in("first").catch(({message}: Error) => {
    worker.dispatchEvent(new ErrorEvent("error", {message, cancelable: true}));
  });
  // Where it cannot be had the worker asks for it itself, when it needs it.
  worker.addEventListener("message", () => void hand_in("rest").catch(() => {}), {once: true});
  return worker;
}

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
