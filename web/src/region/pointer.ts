// What the pointer does on the map: mouse and pen hover, pick, box and pan; fingers hover with the crosshair above them,
// pick on lifting, and zoom by two.
import {whole, type Picked, type Point} from "../contract/messages";
import {Fingers} from "../look/fingers";
import type {RegionView} from "./view.svelte";
import {boxed, panned, zoomed} from "./zoom";

const drag_px = 4,
  touch_drag_px = 8,
  double_ms = 350,
  double_px = 8,
  double_touch_px = 28,
  least_box_px = 6;
export const finger_px = 56; // the crosshair stands so far above the finger

type Doing =
  | {kind: "press"; from: Point}
  | {kind: "band"; from: Point}
  | {kind: "pan"; from: Point; last: Point; button: number; moved: boolean}
  | {kind: "touch"; from: Point; dragging: boolean}
  | {kind: "pinch"};

export class MapPointer {
  private doing: Doing | null = null;
  private readonly fingers = new Fingers();
  private waiting: (() => void) | null = null;
  private frame = 0;
  private last_click: {at: Point; time: number; label: string; before: Picked | null} | null = null;
  private clicks = 0;

  constructor(
    private readonly view: RegionView,
    private readonly open_menu: (at: Point) => void,
  ) {}

  down(event: PointerEvent, at: Point): void {
    if (event.pointerType === "touch") return this.touch_down(event.pointerId, at);
    this.flush();
    if (event.button === 0) this.doing = {kind: "press", from: at};
    else if (event.button === 1 || event.button === 2)
      this.doing = {kind: "pan", from: at, last: at, button: event.button, moved: false};
  }
  move(event: PointerEvent, at: Point): void {
    if (event.pointerType === "touch") return this.touch_move(event.pointerId, at);
    const doing = this.doing;
    if (doing?.kind === "press" && apart(doing.from, at) > drag_px) this.doing = {kind: "band", from: doing.from};
    if (this.doing?.kind === "band") this.view.band = [this.doing.from, this.held(at)];
    else if (doing?.kind === "pan") this.pan(doing, at);
    else this.later(() => this.view.hover(at));
  }
  up(event: PointerEvent, at: Point): void {
    if (event.pointerType === "touch") return this.touch_up(event.pointerId, at);
    this.flush();
    const doing = this.doing;
    this.end();
    if (doing?.kind === "press") this.click(doing.from, event.timeStamp, double_px);
    else if (doing?.kind === "band") this.zoom_to_box(doing.from, this.held(at));
    else if (doing?.kind === "pan" && doing.button === 2 && !doing.moved) this.open_menu(at);
  }
  /** Everything under way is given up. True if there was something. */
  cancel(): boolean {
    const busy = this.doing !== null && this.doing.kind !== "press";
    this.fingers.clear();
    this.end();
    return busy;
  }
  wheel(event: WheelEvent, at: Point): void {
    const pixels = event.deltaY * (event.deltaMode === 1 ? 16 : event.deltaMode === 2 ? 400 : 1);
    const place = this.view.place(at),
      factor = Math.exp(Math.min(Math.max(pixels, -400), 400) * (event.ctrlKey ? 0.01 : 0.002));
    this.zooming *= factor;
    this.later(() => {
      this.view.zoom_at(place, this.zooming);
      this.zooming = 1;
    });
  }
  private zooming = 1;

  leave(): void {
    if (this.doing) return;
    this.drop();
    this.view.leave();
  }

  // ---- mouse and pen ------------------------------------------------------------------------------------------

  private pan(doing: Doing & {kind: "pan"}, at: Point): void {
    if (!doing.moved && apart(doing.from, at) <= drag_px) return;
    doing.moved = this.view.panning = true;
    this.later(() => {
      this.view.pan(at[0] - doing.last[0], at[1] - doing.last[1]);
      doing.last = at;
    });
  }
  private zoom_to_box(from: Point, to: Point): void {
    if (Math.min(Math.abs(from[0] - to[0]), Math.abs(from[1] - to[1])) < least_box_px) return;
    this.view.workbench.zoom(boxed(this.view.place(from), this.view.place(to)));
  }
  private held([x, y]: Point): Point {
    const {size} = this.view;
    return [Math.min(Math.max(x, 0), size), Math.min(Math.max(y, 0), size)];
  }
  private click(at: Point, time: number, reach: number): void {
    const last = this.last_click;
    this.last_click = null;
    if (last && time - last.time < double_ms && apart(last.at, at) < reach)
      this.second_click(last.at, last.label, last.before);
    else this.first_click(at, time);
  }
  private first_click(at: Point, time: number): void {
    const {workbench} = this.view,
      target = this.view.target(at),
      label = `map ${++this.clicks}`;
    this.last_click = {at, time, label, before: workbench.picked};
    if (!target) return;
    if (target.pin && !workbench.is_stale(target.pin)) workbench.pick_pin(target.pin);
    else workbench.pick(target.tau, label);
  }
  /** Pins what was picked; where there is nothing to pin, the whole map comes back and the pick is undone. */
  private second_click(at: Point, label: string, before: Picked | null): void {
    const {workbench} = this.view,
      target = this.view.target(at);
    if (!target) return;
    if (!this.view.is_empty(target.place)) return void workbench.pin_at(target.tau);
    workbench.edit_document((document) => ({...document, picked: before}), label);
    workbench.zoom(whole);
  }

  // ---- fingers ------------------------------------------------------------------------------------------------

  private touch_down(id: number, at: Point): void {
    this.fingers.down(id, at);
    if (this.fingers.count === 1) {
      this.doing = {kind: "touch", from: at, dragging: false};
      return;
    }
    this.view.leave();
    this.doing = {kind: "pinch"};
  }
  private touch_move(id: number, at: Point): void {
    if (!this.fingers.has(id)) return;
    this.fingers.move(id, at);
    const doing = this.doing;
    if (doing?.kind === "pinch") this.later(() => this.pinch());
    if (doing?.kind !== "touch") return;
    doing.dragging ||= apart(doing.from, at) > touch_drag_px;
    if (doing.dragging) this.later(() => this.view.hover(above(at)));
  }
  private pinch(): void {
    const pinch = this.fingers.pinched();
    if (!pinch) return;
    const {from, to, spread} = pinch,
      {workbench, size} = this.view;
    const around = zoomed(workbench.window, this.view.place(from), 1 / spread);
    workbench.zoom(panned(around, (to[1] - from[1]) / size, (from[0] - to[0]) / size));
  }
  private touch_up(id: number, at: Point): void {
    this.flush();
    if (!this.fingers.up(id)) return;
    const doing = this.doing;
    if (doing?.kind === "touch") {
      const target = doing.dragging ? this.view.target(above(at)) : null;
      if (doing.dragging && target) this.view.workbench.pick(target.tau);
      else if (!doing.dragging) this.click(at, performance.now(), double_touch_px);
      this.view.leave();
    }
    if (this.fingers.count === 0) this.end();
  }

  // ---- one thing a frame --------------------------------------------------------------------------------------

  private later(what: () => void): void {
    this.waiting = what;
    this.frame ||= requestAnimationFrame(() => this.flush());
  }
  private flush(): void {
    if (this.frame) cancelAnimationFrame(this.frame);
    this.frame = 0;
    const waiting = this.waiting;
    this.waiting = null;
    waiting?.();
  }
  private drop(): void {
    this.waiting = null;
    this.flush();
  }
  private end(): void {
    this.doing = null;
    this.view.band = null;
    this.view.panning = false;
  }
}

function apart(a: Point, b: Point): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
}
function above([x, y]: Point): Point {
  return [x, y - finger_px];
}
