// What a browser has and the DOM of these tests has not. Nothing is laid out or painted in it: every element has the same
// place, and canvases forget what is drawn on them.
import {readFile} from "node:fs/promises";
import {join} from "node:path";
import {Thread} from "./thread";
import "fake-indexeddb/auto";

const place = {x: 0, y: 0, width: 800, height: 600};
const served = (url: URL | string) => join(process.cwd(), new URL(url, location.href).pathname);

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
  // Node's reaches the tests that run beside these: to a page there, as from another tab.
  BroadcastChannel: class {
    postMessage(): void {}
  },
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
const {querySelector, querySelectorAll} = Element.prototype,
  known = (selector: string) => selector.replaceAll(":enabled", ":not(:disabled)");
Object.assign(Element.prototype, {
  querySelector(this: Element, selector: string) {
    return querySelector.call(this, known(selector));
  },
  querySelectorAll(this: Element, selector: string) {
    return querySelectorAll.call(this, known(selector));
  },
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
