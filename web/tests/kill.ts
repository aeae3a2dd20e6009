import type {EngineClient} from "../src/engine/client";

/** Its worker dies, and says so as a browser would. */
export function kill(client: EngineClient): void {
  const {worker} = client as unknown as {worker: Worker | null};
  worker?.terminate();
  worker?.dispatchEvent(new ErrorEvent("error", {message: "killed", cancelable: true}));
}
