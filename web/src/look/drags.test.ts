import {afterEach, beforeEach, describe, expect, it, vi} from "vitest";
import {drags} from "./drags";

class Place extends EventTarget {
  captured: number | null = null;
  setPointerCapture(pointer: number): void {
    this.captured = pointer;
  }
}
function pointer(type: string, {at = [0, 0], id = 1, button = 0} = {}): Event {
  return Object.assign(new Event(type), {pointerId: id, clientX: at[0], clientY: at[1], button});
}
const key = (name: string) => Object.assign(new Event("keydown", {cancelable: true}), {key: name});

describe("a drag", () => {
  let place: Place, told: string[], leave: () => void;
  const attach = (more: object = {cancel: () => told.push("cancel")}) => {
    const given = {
      move: (_: unknown, {x, y}: {x: number; y: number}) => told.push(`${x} ${y}`),
      end: () => told.push("end"),
      ...more,
    };
    leave = drags(given)(place as unknown as HTMLElement) as () => void;
  };
  const send = (...events: Event[]) => events.forEach((event) => place.dispatchEvent(event));

  beforeEach(() => {
    vi.stubGlobal("window", new EventTarget());
    place = new Place();
    told = [];
  });
  afterEach(() => vi.unstubAllGlobals());

  it("keeps its pointer, says how far it is from where it began, and ends", () => {
    attach();
    send(pointer("pointermove", {at: [9, 9]}), pointer("pointerdown", {at: [10, 20]}));
    expect(place.captured).toBe(1);
    send(pointer("pointermove", {at: [13, 18]}), pointer("pointermove", {at: [0, 0], id: 2}), pointer("pointerup"));
    send(pointer("pointermove", {at: [50, 50]}));
    expect(told).toEqual(["3 -2", "end"]);
  });
  it("is called off by Escape, which then means nothing else, and by the browser", () => {
    attach();
    const escape = key("Escape");
    send(pointer("pointerdown"));
    window.dispatchEvent(key("a"));
    window.dispatchEvent(escape);
    expect(escape.defaultPrevented).toBe(true);
    window.dispatchEvent(key("Escape"));
    send(pointer("pointerup"), pointer("pointerdown"), pointer("pointercancel"));
    expect(told).toEqual(["cancel", "cancel"]);
  });
  it("leaves Escape alone where nothing can be taken back", () => {
    attach({});
    const escape = key("Escape");
    send(pointer("pointerdown"));
    window.dispatchEvent(escape);
    expect(escape.defaultPrevented).toBe(false);
    send(pointer("pointercancel"));
    expect(told).toEqual(["end"]);
  });
  it("does not begin by another button, nor against its start, nor once it has left", () => {
    attach({start: () => false});
    send(pointer("pointerdown"), pointer("pointermove"));
    leave();
    attach();
    send(pointer("pointerdown", {button: 2}), pointer("pointermove"), pointer("pointerdown"));
    leave();
    send(pointer("pointermove"), pointer("pointerup"));
    window.dispatchEvent(key("Escape"));
    expect(told).toEqual([]);
  });
});
