// The engine's worker (src/engine/worker.ts) in the thread of the page.
import {readFileSync} from "node:fs";
import {create_linkwright, type LinkwrightModule} from "../../src/engine/module";
import type {ReplyMessage, RequestMessage} from "../../src/contract/messages";
import {Engine} from "../../src/engine/serve";

/** Nobody sees the finest maps, and nothing waits for them: they are as coarse as those before. */
function coarse_enough(request: RequestMessage): RequestMessage {
  return request.kind === "explore" ? {...request, samples: Math.min(request.samples, 400)} : request;
}

let loaded: Promise<LinkwrightModule> | undefined;

const alive = new Set<Thread>();
/** Nobody waits any more for what is under way. */
export function end_threads(): void {
  for (const thread of alive) thread.terminate();
}

/** All have one module, each a session of its own. */
export class Thread extends EventTarget {
  onmessage: ((event: MessageEvent<ReplyMessage>) => void) | null = null;
  onerror: ((event: ErrorEvent) => void) | null = null;
  private engine: Promise<Engine> | undefined;
  private dead = false;

  constructor() {
    super();
    alive.add(this);
    this.addEventListener("error", (event) => this.onerror?.(event as ErrorEvent));
  }
  postMessage(message: RequestMessage | {first?: WebAssembly.Module}): void {
    if ("kind" in message) setTimeout(() => void this.answer(message));
    else if (message.first) this.engine = this.begun(message.first);
  }
  private async begun(first: WebAssembly.Module): Promise<Engine> {
    const rest = () => new WebAssembly.Module(readFileSync("src/engine/generated/rest.wasm"));
    const module = await (loaded ??= create_linkwright({first, rest}));
    this.say({kind: "ready", version: module.version()});
    return new Engine(module, (message) => this.say(message));
  }
  private async answer(request: RequestMessage): Promise<void> {
    const engine = await this.engine!;
    if (!this.dead) this.say(engine.serve(coarse_enough(request)).message);
  }
  private say(data: ReplyMessage): void {
    if (this.dead) return;
    const event = new MessageEvent("message", {data});
    this.dispatchEvent(event);
    this.onmessage?.(event as MessageEvent<ReplyMessage>);
  }
  terminate(): void {
    this.dead = true;
    alive.delete(this);
  }
}
