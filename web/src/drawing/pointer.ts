// The pointer on the drawing: hovering, pressing, dragging, two fingers, the wheel.
import {tick} from "svelte";
import type {Attachment} from "svelte/attachments";
import type {Point} from "../contract/messages";
import {Fingers} from "../look/fingers";
import {
  add_clicked,
  add_draft_corner,
  add_position,
  click_target,
  focus_handle,
  poses_are_wanted,
  toggle_traced,
} from "./actions";
import {box_drag, rubber_drag} from "./drags/box_drags";
import type {Bench} from "./bench";
import type {Drag} from "./drags/drag";
import {corner_drag, remove_corner} from "./drags/outline_drags";
import {pivot_drag} from "./drags/pivot_drag";
import {curvature_drag, move_drag, turn_drag, velocity_drag} from "./drags/pose_drags";
import {picture_drag, turning_part} from "./drags/picture_drags";
import {pan_drag} from "./drags/view_drags";
import {box_names, target_id, type Target} from "./handles";
import {comes_along, pick_under, tau_under} from "./plane_map";
import {keys_of, type Keys} from "./snapping";
import {panned, zoomed} from "./viewport";

interface Press {
  id: number;
  from: Point;
  at: Point;
  keys: Keys;
  touch: boolean;
  targets: Target[];
  /** What a drag takes. */
  taken: Target | null;
  drag: Drag | null;
  in_gesture: boolean;
  moved: boolean;
}
const slack = {mouse: 3, touch: 7}; // pixels that a click may move
const same_place = {mouse: 4, touch: 14};

export function follow_pointer(bench: Bench): Attachment<SVGSVGElement> {
  return (svg) => {
    const pointer = new Pointer(bench, svg),
      stop = new AbortController(),
      options = {signal: stop.signal};
    svg.addEventListener("pointerdown", (event) => pointer.down(event), options);
    svg.addEventListener("pointermove", (event) => pointer.move(event), options);
    svg.addEventListener("pointerup", (event) => pointer.up(event), options);
    svg.addEventListener("pointercancel", (event) => pointer.lost(event), options);
    svg.addEventListener("pointerleave", () => pointer.leave(), options);
    svg.addEventListener("wheel", (event) => pointer.wheel(event), {...options, passive: false});
    svg.addEventListener(
      "contextmenu",
      (event) => {
        if (event.pointerType === "touch") event.preventDefault();
      },
      options,
    );
    window.addEventListener("keydown", (event) => pointer.key(event), {...options, capture: true});
    window.addEventListener("keyup", (event) => pointer.key(event), {...options, capture: true});
    window.addEventListener("blur", () => pointer.abort(), options);
    return () => {
      pointer.abort();
      stop.abort();
    };
  };
}

class Pointer {
  private press: Press | null = null;
  private readonly fingers = new Fingers();
  private last_click: {at: Point; time: number; visited: string[]} | null = null;

  constructor(
    private readonly bench: Bench,
    private readonly svg: SVGSVGElement,
  ) {}

  private place(event: {clientX: number; clientY: number}): Point {
    const box = this.svg.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  // ---- press, move, release -----------------------------------------------------------------------------------

  down(event: PointerEvent): void {
    const at = this.place(event),
      touch = event.pointerType === "touch";
    if (event.button > 1) return;
    if (event.button === 1) event.preventDefault(); // no scrolling by the middle button
    this.svg.setPointerCapture(event.pointerId);
    if (touch) this.fingers.down(event.pointerId, at);
    if (this.press) return touch ? this.drop_press() : undefined;
    if (this.fingers.count > 1) return;
    this.bench.scene.touched = true;
    this.bench.scene.spot = null;
    const targets = event.button === 1 ? [] : this.targets(at, touch);
    const taken = this.taken(targets, at, touch);
    this.press = {
      id: event.pointerId,
      from: at,
      at,
      keys: keys_of(event),
      touch,
      targets,
      taken,
      drag: null,
      in_gesture: false,
      moved: false,
    };
    // A held position shows at once where it may go.
    if (taken?.kind === "disc" || taken?.kind === "knob") this.take(this.press);
    this.svg.style.cursor = this.press.drag?.cursor ?? "";
    if (touch) this.hover(at, touch);
  }
  move(event: PointerEvent): void {
    const at = this.place(event),
      {press} = this;
    this.fingers.move(event.pointerId, at);
    if (this.fingers.count === 2 && this.fingers.has(event.pointerId)) return this.pinch();
    if (!press) return this.hover(at, event.pointerType === "touch");
    if (press.id !== event.pointerId) return;
    press.at = at;
    press.keys = keys_of(event);
    this.dragged(press);
  }
  private dragged(press: Press): void {
    if (!press.moved) {
      if (Math.hypot(press.at[0] - press.from[0], press.at[1] - press.from[1]) < slack[press.touch ? "touch" : "mouse"])
        return;
      press.moved = true;
      this.take(press);
      this.bench.workbench.curve_hover = null;
      this.follow(null);
      this.svg.style.cursor = press.drag?.cursor ?? "";
    }
    if (press.in_gesture && !this.bench.workbench.gesture) return this.drop_press(); // undone meanwhile
    press.drag?.move(press.at, press.keys);
  }
  private take(press: Press): void {
    press.drag ??= this.begin(press);
    press.in_gesture = this.bench.workbench.gesture;
  }
  up(event: PointerEvent): void {
    this.fingers.up(event.pointerId);
    const {press} = this;
    if (!press || press.id !== event.pointerId) return;
    this.press = null;
    if (press.moved) press.drag?.end();
    else {
      press.drag?.cancel();
      if (event.button === 0) this.click(press);
    }
    this.hover(this.place(event), press.touch);
  }
  lost(event: PointerEvent): void {
    this.fingers.up(event.pointerId);
    if (this.press?.id === event.pointerId) this.drop_press();
  }
  abort(): void {
    this.fingers.clear();
    this.drop_press();
  }
  private drop_press(): void {
    const {press} = this;
    this.press = null;
    press?.drag?.cancel();
    this.svg.style.cursor = "";
  }
  key(event: KeyboardEvent): void {
    const {press} = this;
    if (!press) return;
    if (event.key === "Escape" && event.type === "keydown") {
      event.preventDefault();
      event.stopPropagation();
      this.drop_press();
      this.press = {...press, drag: null, targets: [], taken: null, moved: true}; // the rest of this press does nothing
    } else if (press.moved && ["Shift", "Alt", "Control", "Meta"].includes(event.key)) {
      event.preventDefault();
      press.keys = keys_of(event);
      this.dragged(press);
    }
  }

  // ---- what is meant ------------------------------------------------------------------------------------------

  /** Targets of the mode in force. */
  private targets(at: Point, touch: boolean): Target[] {
    const {workbench, scene} = this.bench,
      all = scene.targets_at(at, touch).map(({target}) => target);
    if (workbench.mode === "point") return all.filter((target) => !comes_along(this.bench, target));
    if (workbench.mode === "outline" && scene.draft === null)
      return all.filter((t) => t.kind === "corner" || t.kind === "midpoint");
    if (workbench.mode === "scale") return all.filter((t) => t.kind === "task" && t.part === turning_part);
    return [];
  }
  /** A drag takes the first target, or the one that the last click at this place went down to. */
  private taken(targets: Target[], at: Point, touch: boolean): Target | null {
    const last = this.near_last(at, touch)?.visited.at(-1),
      draggable = targets.filter((t) => t.kind !== "curve");
    return draggable.find((t) => target_id(t) === last) ?? draggable[0] ?? null;
  }
  private near_last(at: Point, touch: boolean): typeof this.last_click {
    const last = this.last_click;
    return last && Math.hypot(last.at[0] - at[0], last.at[1] - at[1]) <= same_place[touch ? "touch" : "mouse"]
      ? last
      : null;
  }
  private begin({from, taken}: Press): Drag | null {
    const {workbench} = this.bench;
    const box = box_names.find((name) => workbench.mode === `${name}_box`);
    if (box) return rubber_drag(this.bench, box, from);
    if (workbench.mode === "draw") return this.bench.scene.stroke(from) ?? pan_drag(this.bench, from);
    if (workbench.mode === "scale" && !taken) return picture_drag(this.bench, from) ?? pan_drag(this.bench, from);
    switch (taken?.kind) {
      case "disc":
      case "body":
        return move_drag(this.bench, taken, from);
      case "knob":
        return turn_drag(this.bench, taken, from);
      case "velocity":
        return velocity_drag(this.bench, taken, from);
      case "curvature":
        return curvature_drag(this.bench, taken);
      case "pivot":
        return pivot_drag(this.bench, taken) ?? pan_drag(this.bench, from);
      case "box":
        return box_drag(this.bench, taken, from);
      case "task":
        return taken.drag(from);
      case "corner":
      case "midpoint":
        return corner_drag(this.bench, taken);
      default:
        return pan_drag(this.bench, from);
    }
  }
  private click(press: Press): void {
    const {workbench, scene} = this.bench,
      {at, touch, keys} = press;
    switch (workbench.mode) {
      case "trace":
        return toggle_traced(this.bench, at);
      case "scale":
        if (!press.taken) scene.marks = [...scene.marks.slice(-1), scene.space.unproject(at)];
        return;
      case "outline":
        if (scene.draft) return add_draft_corner(this.bench, at);
    }
    const last = this.near_last(at, touch),
      time = performance.now();
    const target = this.deeper(press.targets, last?.visited ?? []);
    if (target?.kind === "corner" && last && time - last.time < 400) return remove_corner(this.bench, target.index);
    const visited = target
      ? [...(last?.visited.includes(target_id(target)) ? [] : (last?.visited ?? [])), target_id(target)]
      : [];
    this.last_click = {at, time, visited};
    if (target) {
      click_target(this.bench, target, keys.shift);
      if (target.kind === "midpoint") this.last_click = null; // a corner now
      const kept: Target = target.kind === "midpoint" ? {kind: "corner", index: target.index + 1} : target;
      void tick().then(() => focus_handle(this.svg, kept));
    } else if (workbench.mode === "point") this.click_canvas(at);
  }
  /** Clicking again at the same place goes one deeper; a curve is taken only where it comes first. */
  private deeper(targets: Target[], visited: string[]): Target | null {
    const chain = targets[0]?.kind === "curve" ? targets : targets.filter((t) => t.kind !== "curve");
    if (chain[0]?.kind === "corner" || chain[0]?.kind === "curve") return chain[0];
    return chain.find((t) => !visited.includes(target_id(t))) ?? chain[0] ?? null;
  }
  private click_canvas(at: Point): void {
    const {workbench, scene} = this.bench;
    if (poses_are_wanted(workbench)) return add_position(this.bench, at);
    if (add_clicked(this.bench, at) || pick_under(this.bench, at)) return;
    workbench.selected_pose = null;
    if (document.activeElement instanceof SVGElement && this.svg.contains(document.activeElement))
      document.activeElement.blur();
    scene.corner = null;
  }

  // ---- without a press ----------------------------------------------------------------------------------------

  private hover(at: Point, touch: boolean): void {
    const {workbench, scene} = this.bench;
    scene.pointer = scene.draft ? at : null;
    if (touch && !this.press) return this.leave();
    const drawing = workbench.mode !== "point" && workbench.mode !== "outline";
    const first = drawing ? null : this.first(at, touch);
    scene.hovered = first?.target ?? null;
    this.show_spot(first?.target ?? null);
    this.follow(first || this.press || workbench.mode !== "point" ? null : at);
    if (!this.press)
      this.svg.style.cursor = first?.cursor ?? (drawing || scene.draft || workbench.incomplete ? "crosshair" : "");
  }
  private first(at: Point, touch: boolean): {target: Target; cursor: string} | null {
    const [first] = this.targets(at, touch);
    return first
      ? (this.bench.scene.targets_at(at, touch).find(({target}) => target_id(target) === target_id(first)) ?? null)
      : null;
  }
  private show_spot(target: Target | null): void {
    const {workbench, scene} = this.bench,
      spot = target?.kind === "curve" ? target.spot : null;
    if (!spot && !scene.spot) return;
    scene.spot = spot;
    workbench.curve_hover = spot && {sides: spot.sides, tau: spot.tau};
  }
  /** On a map over the plane the linkage whose pivot lies there comes in hand; null: the picked one comes back. */
  private follow(at: Point | null): void {
    const tau = at && tau_under(this.bench, at);
    if (tau) this.bench.workbench.hover(tau);
    else if (this.follows) this.bench.workbench.hover(null);
    this.follows = tau !== null;
  }
  private follows = false;
  leave(): void {
    if (this.press) return;
    this.follow(null);
    this.bench.scene.hovered = this.bench.scene.pointer = null;
    this.show_spot(null);
  }

  wheel(event: WheelEvent): void {
    event.preventDefault();
    const {scene} = this.bench,
      unit = event.deltaMode === 1 ? 18 : event.deltaMode === 2 ? 300 : 1;
    scene.touched = true;
    scene.view = zoomed(
      scene.view,
      Math.exp(-event.deltaY * unit * (event.ctrlKey ? 0.01 : 0.0016)),
      this.place(event),
    );
  }
  private pinch(): void {
    const {scene} = this.bench,
      pinch = this.fingers.pinched();
    if (!pinch) return;
    const {from, to, spread} = pinch;
    scene.touched = true;
    scene.view = zoomed(panned(scene.view, to[0] - from[0], to[1] - from[1]), spread, to);
  }
}
