// One engine in one worker: loads it, then answers one request after the other.
import {create_linkwright} from "./module";
import type {ReplyMessage, RequestMessage} from "./protocol";
import {Engine} from "./serve";

const scope = self as unknown as {
  postMessage(message: ReplyMessage, transfer?: Transferable[]): void;
  onmessage: ((event: MessageEvent<RequestMessage>) => void) | null;
};

function crashed(error: unknown): void {
  scope.postMessage({kind: "crashed", message: error instanceof Error ? error.message : String(error)});
}

try {
  const module = await create_linkwright();
  const engine = new Engine(module, (message) => scope.postMessage(message));
  scope.onmessage = (event) => {
    try {
      const {message, transfer} = engine.serve(event.data);
      scope.postMessage(message, transfer);
    } catch (error) {
      // The engine's memory is of no use after an abort; the page starts another worker.
      scope.onmessage = null;
      crashed(error);
    }
  };
  scope.postMessage({kind: "ready", version: module.version()});
} catch (error) {
  crashed(error);
}
