// One engine in one worker: takes its code, then answers one request after the other.
import {code_urls, type CodePart} from "./code";
import {create_linkwright} from "./module";
import type {ReplyMessage, RequestMessage} from "../contract/messages";
import {Engine} from "./serve";

const scope = self as unknown as {
  postMessage(message: ReplyMessage, transfer?: Transferable[]): void;
  onmessage: ((event: MessageEvent<RequestMessage | Partial<Record<CodePart, WebAssembly.Module>>>) => void) | null;
};
let engine: Engine;
let rest: WebAssembly.Module | null = null;

function crashed(error: unknown): void {
  scope.postMessage({kind: "crashed", message: error instanceof Error ? error.message : String(error)});
}

/** Without leaving the call that needs it. */
function fetched_now(url: URL): WebAssembly.Module {
  const request = new XMLHttpRequest();
  request.open("GET", url, false);
  request.responseType = "arraybuffer";
  request.send();
  if (request.status !== 200) throw new Error(`${url.pathname}: ${request.status} ${request.statusText}`);
  return new WebAssembly.Module(request.response as ArrayBuffer);
}

async function begin(first: WebAssembly.Module): Promise<void> {
  const module = await create_linkwright({first, rest: () => (rest ??= fetched_now(code_urls.rest))});
  engine = new Engine(module, (message) => scope.postMessage(message));
  scope.postMessage({kind: "ready", version: module.version()});
}

function answer(request: RequestMessage): void {
  try {
    const {message, transfer} = engine.serve(request);
    scope.postMessage(message, transfer);
  } catch (error) {
    // The engine's memory is of no use after an abort; the page starts another worker.
    scope.onmessage = null;
    crashed(error);
  }
}

scope.onmessage = ({data}) => {
  if ("kind" in data) answer(data);
  else if (data.first) void begin(data.first).catch(crashed);
  else rest = data.rest!;
};
