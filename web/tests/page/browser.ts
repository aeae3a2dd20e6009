// What a browser has and the DOM of these tests has not. Nothing is laid out or painted in it: every element has the same
// place, and canvases forget what is drawn on them.
import {readFile} from "node:fs/promises";
import {readFileSync} from "node:fs";
import {join} from "node:path";
import {create_linkwright, type LinkwrightModule} from "../../src/engine/module";
import type {ReplyMessage, RequestMessage} from "../../src/engine/protocol";
import {Engine} from "../../src/engine/serve";
import "fake-indexeddb/auto";

const place = {x: 0, y: 0, width: 800, height: 600};
const served = (url: URL | string) => join(process.cwd(), new URL(url, location.href).pathname);

// ---- the engine -----------------------------------------------------------------------------------------------------

/** Nobody sees the finest maps, and nothing waits for them: they are as coarse as those before. */
function coarse_enough(request: RequestMessage): RequestMessage {
  return request.kind === "explore" ? {...request, samples: Math.min(request.samples, 400)} : request;
}

let loaded: Promise<LinkwrightModule> | undefined;

/** A worker of the engine (src/engine/worker.ts) in this thread. All have one module: each has a session of its own. */
class Thread extends EventTarget {
  onmessage: ((event: MessageEvent<ReplyMessage>) => void) | null = null;
  onerror: ((event: ErrorEvent) => void) | null = null;
  private engine: Promise<Engine> | undefined;
  private dead = false;

  constructor() {
    super();
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
  }
}

// ---- pictures -------------------------------------------------------------------------------------------------------

class Pixels {
  readonly data: Uint8ClampedArray;
  constructor(
    readonly width: number,
    readonly height: number,
  ) {
    this.data = new Uint8ClampedArray(4 * width * height);
  }
}
/** Takes whatever is called and set, and draws nothing. */
function pen(canvas: HTMLCanvasElement): object {
  const made: Record<string, unknown> = {
    canvas,
    getTransform: () => ({a: 1, b: 0, c: 0, d: 1, e: 0, f: 0}),
    measureText: (text: string) => ({width: 6 * text.length}),
    createImageData: (width: number, height: number) => new Pixels(width, height),
    getImageData: (_x: number, _y: number, width: number, height: number) => new Pixels(width, height),
  };
  return new Proxy(made, {get: (_, name: string) => made[name] ?? (() => null), set: () => true});
}
class NoPath {
  moveTo(): void {}
  lineTo(): void {}
  closePath(): void {}
  arc(): void {}
  rect(): void {}
  addPath(): void {}
}

// ---- what opens above the page --------------------------------------------------------------------------------------

function toggle(list: HTMLElement, newState: "open" | "closed"): void {
  if ((list.dataset.popover === "open") === (newState === "open")) return;
  list.dataset.popover = newState;
  list.dispatchEvent(Object.assign(new Event("toggle"), {newState}));
}

Object.assign(globalThis, {
  Worker: Thread,
  ImageData: Pixels,
  Path2D: NoPath,
  fetch: async (url: URL) => new Response(new Uint8Array(await readFile(served(url)))),
  ResizeObserver: class {
    observe(): void {}
    unobserve(): void {}
    disconnect(): void {}
  },
});
HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, kind: string) {
  return kind === "2d" ? pen(this) : null;
} as HTMLCanvasElement["getContext"];
Object.assign(HTMLElement.prototype, {
  showPopover(this: HTMLElement) {
    toggle(this, "open");
  },
  hidePopover(this: HTMLElement) {
    toggle(this, "closed");
  },
});
Object.assign(Element.prototype, {
  setPointerCapture() {},
  releasePointerCapture() {},
  getBoundingClientRect: () => new DOMRect(place.x, place.y, place.width, place.height),
});
for (const name of ["width", "height"] as const)
  for (const kind of ["client", "offset"])
    Object.defineProperty(HTMLElement.prototype, `${kind}${name[0]!.toUpperCase()}${name.slice(1)}`, {
      configurable: true,
      get: () => place[name],
    });
