// What the npm package offers (web/npm); the page imports the parts.
import {EngineClient} from "./client";
import {create_linkwright} from "./module";
import {Engine} from "./serve";
import {start_worker} from "./start";

export {Cancelled, Crashed, EngineClient, Refusal, Superseded, type Job, type Run} from "./client";
export * from "./protocol";
export {Engine, start_worker};

/** The engine in this thread; `wasmBinary` where its module is not to be fetched from beside the script. */
export async function load_engine(options: {wasmBinary?: Uint8Array} = {}): Promise<Engine> {
  return new Engine(await create_linkwright(options));
}

/** An engine in a worker of its own, started again where it dies. */
export function connect_engine(
  on_crash: (reason: string, resting: boolean) => void = () => {},
  on_ready: (version: string) => void = () => {},
): EngineClient {
  return new EngineClient(start_worker, on_crash, on_ready);
}
