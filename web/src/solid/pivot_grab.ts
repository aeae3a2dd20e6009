// Pivots are taken hold of in 3-D as on the drawing: the pointer's place on the mechanism's plane is what it means.
import type {Attachment} from "svelte/attachments";
import type {Bench} from "../drawing/bench";
import type {Drag} from "../drawing/drags/drag";
import {pivot_drag} from "../drawing/drags/pivot_drag";
import {keys_of} from "../drawing/snapping";
import {to_screen} from "../drawing/viewport";
import type {Point} from "../contract/messages";
import type {SolidPivot, SolidScene} from "./scene";

const reach = {mouse: 12, touch: 24},
  slack = 3; // pixels

interface Grab {
  id: number;
  pivot: SolidPivot;
  from: Point;
  drag: Drag | null;
}

/** Goes onto the canvas before the view's own controls listen there: they never see what is taken here. */
export function grab_pivots(bench: Bench, scene_now: () => SolidScene | null): Attachment<HTMLCanvasElement> {
  return (canvas) => {
    let grab: Grab | null = null;
    const stop = new AbortController(),
      options = {signal: stop.signal, capture: true};
    const place = (event: PointerEvent): Point => {
      const box = canvas.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    const pivot_at = (event: PointerEvent) =>
      scene_now()?.pivot_at(place(event), event.pointerType === "touch" ? reach.touch : reach.mouse) ?? null;
    const release = (keep: boolean) => {
      const drag = grab?.drag;
      grab = null;
      scene_now()?.hold_view(false);
      if (keep) drag?.end();
      else drag?.cancel();
    };
    const follow = (event: PointerEvent, held: Grab) => {
      const at = place(event),
        scene = scene_now(),
        point = scene?.plane_point(at);
      if (!scene || !point) return;
      if (!held.drag && Math.hypot(at[0] - held.from[0], at[1] - held.from[1]) <= slack) return;
      held.drag ??= pivot_drag(bench, {kind: "pivot", ...held.pivot, home: false}, () => scene.flat_view());
      if (!bench.workbench.gesture) return release(false); // Escape has ended it
      held.drag?.move(to_screen(scene.flat_view(), point), keys_of(event));
      if (bench.scene.note) bench.scene.note = {...bench.scene.note, at};
    };
    canvas.addEventListener(
      "pointerdown",
      (event) => {
        const pivot = event.button === 0 && !grab ? pivot_at(event) : null;
        if (!pivot) return;
        event.stopImmediatePropagation();
        canvas.setPointerCapture(event.pointerId);
        scene_now()?.hold_view(true);
        grab = {id: event.pointerId, pivot, from: place(event), drag: null};
      },
      options,
    );
    canvas.addEventListener(
      "pointermove",
      (event) => {
        if (grab?.id === event.pointerId) return follow(event, grab);
        canvas.style.cursor = event.buttons === 0 && pivot_at(event) ? "pointer" : "";
      },
      options,
    );
    canvas.addEventListener("pointerup", (event) => grab?.id === event.pointerId && release(true), options);
    canvas.addEventListener("pointercancel", (event) => grab?.id === event.pointerId && release(false), options);
    return () => {
      release(false);
      stop.abort();
    };
  };
}
