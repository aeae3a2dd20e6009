import type {Attachment} from "svelte/attachments";

/** What one pointer does to an element, from when it is pressed there. */
export interface Drag {
  /** Whether it begins; it does unless this says false. */
  start?: (event: PointerEvent) => boolean | void;
  /** `by`: from where it began, in pixels. */
  move: (event: PointerEvent, by: {x: number; y: number}) => void;
  end?: () => void;
  /** Without it there is nothing to take back, and Escape is not the drag's. */
  cancel?: () => void;
}

/** The element keeps the pointer that is pressed on it until it is let go, or the drag is called off: by Escape, or by the
 *  browser. */
export function drags({start, move, end, cancel}: Drag): Attachment<HTMLElement | SVGElement> {
  return (element) => {
    const all = new AbortController();
    let held: {pointer: number; x: number; y: number; over: AbortController} | null = null;

    function finish(tell?: () => void): void {
      held?.over.abort();
      held = null;
      tell?.();
    }
    function called_off(event: KeyboardEvent): void {
      if (event.key !== "Escape") return;
      event.preventDefault();
      event.stopImmediatePropagation();
      finish(cancel);
    }
    function pressed(event: PointerEvent): void {
      if (held || event.button !== 0 || start?.(event) === false) return;
      element.setPointerCapture(event.pointerId);
      const over = new AbortController();
      held = {pointer: event.pointerId, x: event.clientX, y: event.clientY, over};
      if (cancel) window.addEventListener("keydown", called_off, {capture: true, signal: over.signal});
    }
    const of_held = (react: (event: PointerEvent) => void) => (event: Event) => {
      if (held && (event as PointerEvent).pointerId === held.pointer) react(event as PointerEvent);
    };
    const moved = (event: PointerEvent) => move(event, {x: event.clientX - held!.x, y: event.clientY - held!.y});
    const listen = (name: string, react: (event: Event) => void) =>
      element.addEventListener(name, react, {signal: all.signal});
    listen("pointerdown", pressed as (event: Event) => void);
    listen("pointermove", of_held(moved));
    listen(
      "pointerup",
      of_held(() => finish(end)),
    );
    listen(
      "pointercancel",
      of_held(() => finish(cancel ?? end)),
    );
    return () => {
      held?.over.abort();
      all.abort();
    };
  };
}
