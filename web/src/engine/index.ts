// What the npm package offers (web/npm); the page imports the parts.
import {EngineClient} from "./client";
import {compile} from "./code";
import {create_linkwright, type Code} from "./module";
import {Engine} from "./serve";
import {start_worker} from "./start";

export {Cancelled, Crashed, EngineClient, Refusal, Superseded, type Job, type Run} from "./client";
export * from "../contract/messages";
export {Engine, start_worker, type Code};

/** The engine in this thread; `code` where it is not to be fetched from beside the script. */
export async function load_engine(code?: Code): Promise<Engine> {
  const {first, rest} = code ?? {first: await compile("first"), rest: await compile("rest")};
  return new Engine(await create_linkwright({first, rest}));
}

/** An engine in a worker of its own, started again where it dies. */
export function connect_engine(
  on_crash: (reason: string, resting: boolean) => void = () => {},
  on_ready: (version: string) => void = () => {},
): EngineClient {
  return new EngineClient(start_worker, on_crash, on_ready);
}
