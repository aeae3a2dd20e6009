// How the map lies on the screen and where it is being pointed at. Nothing here outlives the pointer: what is shown of
// the region, picked and hovered is the workbench's.
import {degenerate} from "../contract/messages";
import type {Axis, Point, Side, TauPair} from "../contract/messages";
import {held_place, is_column, is_ribbon, place_of, places_of, stepped_place, tau_of_places} from "../engine/axis";
import type {Pin} from "../state/problem";
import type {Workbench} from "../state/workbench.svelte";
import {point_of, type Frame} from "./painter";
import {make_scale, place_at} from "./scale";
import {panned, showing, zoomed} from "./zoom";

export const pin_reach = 6; // pixels
export const ribbon_px = 36;
const cells_along = 400; // what a step of the arrow keys is a part of

export class RegionView {
  readonly workbench: Workbench;
  size = $state(412);
  /** Place under the pointer or the keyboard's crosshair. */
  cursor = $state.raw<TauPair | null>(null);
  by_keys = $state(false);
  pin = $state.raw<Pin | null>(null);
  band = $state.raw<readonly [Point, Point] | null>(null);
  panning = $state(false);
  /** τ is shown at the crosshair. */
  alt = $state(false);
  whole_picture = $state.raw<{canvas: HTMLCanvasElement} | null>(null);

  private readonly axes = $derived.by(() => this.workbench.task?.axes);
  /** A map of one column, or of one row, is low: a ribbon. */
  readonly ribbon = $derived.by(() => this.axes !== undefined && is_ribbon(this.axes));
  /** A column lies on its side. */
  readonly on_its_side = $derived.by(() => this.axes !== undefined && is_column(this.axes));
  /** Of the cells, in pixels; the map is as wide as its size. */
  readonly height = $derived(this.ribbon ? ribbon_px : this.size);
  readonly sides: {up: Side; across: Side} = $derived(
    this.on_its_side ? {up: "output", across: "input"} : {up: "input", across: "output"},
  );
  readonly frame: Frame = $derived.by(() => {
    const {axes} = this,
      {window} = this.workbench;
    const scale = (side: Side, size: number) => make_scale(axes?.[side].blocks ?? [], window[side], size);
    return {up: scale(this.sides.up, this.height), across: scale(this.sides.across, this.size)};
  });
  /** Where the picked linkage stands. */
  readonly picked_place = $derived.by(() => {
    const {picked} = this.workbench;
    return picked && (picked.place ?? this.place_of_tau(picked.tau));
  });
  /** Where the linkage in hand stands. */
  readonly hand_place = $derived.by(() => {
    const {hovered} = this.workbench;
    if (!hovered) return this.picked_place;
    return this.cursor ?? this.place_of_tau(hovered);
  });

  constructor(workbench: Workbench) {
    this.workbench = workbench;
  }

  place(point: Point): TauPair {
    const {task} = this.workbench,
      place = this.turned([place_at(this.frame.up, this.height - point[1]), place_at(this.frame.across, point[0])]);
    return task ? [held_place(task.axes.input, place[0]), held_place(task.axes.output, place[1])] : place;
  }
  point(place: TauPair): Point {
    return point_of(this.frame, this.turned(place));
  }
  /** What runs up and across as input and output, and back. */
  private turned<T>(pair: readonly [T, T]): readonly [T, T] {
    return this.on_its_side ? [pair[1], pair[0]] : pair;
  }
  contains([x, y]: Point): boolean {
    return x >= 0 && y >= 0 && x <= this.size && y <= this.height;
  }
  place_of_tau(tau: TauPair): TauPair | null {
    const {task} = this.workbench;
    return task && places_of(task.axes, tau);
  }
  tau_of_place(place: TauPair): TauPair | null {
    const {task} = this.workbench;
    return task && tau_of_places(task.axes, place);
  }
  pin_near(point: Point, reach = pin_reach): Pin | null {
    let nearest: Pin | null = null;
    for (const pin of this.workbench.pins_on_map) {
      if (!pin.place) continue;
      const [x, y] = this.point(pin.place),
        distance = Math.hypot(x - point[0], y - point[1]);
      if (distance <= reach) [nearest, reach] = [pin, distance];
    }
    return nearest;
  }
  /** What is meant by pointing at a pixel: a pin of this task close by, or the very place. */
  target(point: Point): {place: TauPair; tau: TauPair; pin: Pin | null} | null {
    const pin = this.pin_near(point),
      place = pin?.place ?? this.place(point),
      tau = this.tau_of_place(place);
    return tau && {place, tau: pin && !this.workbench.is_stale(pin) ? pin.tau : tau, pin};
  }

  hover(point: Point): void {
    const target = this.workbench.map ? this.target(point) : null;
    if (!target) return this.leave();
    this.by_keys = false;
    this.pin = target.pin;
    this.cursor = target.place;
    this.workbench.hover(target.tau);
  }
  /** The keyboard's crosshair, by cells of the map as it is shown. */
  step(up: number, across: number): void {
    const [rows, columns] = this.turned([up, across]);
    const from = this.hand_place ?? this.middle(),
      {task} = this.workbench;
    if (!task) return;
    const moved = (side: Side, place: number, by: number) =>
      this.up_to_infinity(
        task.axes[side],
        place,
        by === 0 ? place : stepped_place(task.axes[side], place, by, this.cell_width(side)),
      );
    const to = [moved("input", from[0], rows), moved("output", from[1], columns)] as const;
    const place: TauPair = [to[0].place, to[1].place],
      plain = this.tau_of_place(place);
    if (!plain) return;
    const tau: TauPair = [to[0].tau ?? plain[0], to[1].tau ?? plain[1]];
    this.by_keys = true;
    this.pin = null;
    this.cursor = place;
    this.workbench.hover(tau);
    const window = showing(this.workbench.window, place);
    if (window !== this.workbench.window) this.workbench.zoom(window);
  }
  /** What a step of the arrow keys goes along an axis. */
  cell_width(side: Side): number {
    const [from, to] = this.workbench.window[side];
    return (to - from) / cells_along;
  }
  /** A step across an ∞ mark stops there: one comes upon the slider exactly. */
  private up_to_infinity(axis: Axis, from: number, to: number): {place: number; tau: number | null} {
    const marks = (this.workbench.task?.specials ?? []).filter((special) => special.kind.endsWith("_at_infinity"));
    let stop: {place: number; tau: number | null} = {place: to, tau: null};
    for (const tau of marks.flatMap((mark) => mark.tau)) {
      const place = place_of(axis, tau);
      if (place === null || Math.abs(place - from) < 1e-12 || (place - from) * (stop.place - place) < 0 || from === to)
        continue;
      if (Math.sign(place - from) === Math.sign(to - from)) stop = {place, tau};
    }
    return stop;
  }
  leave(): void {
    this.cursor = this.pin = null;
    this.by_keys = false;
    if (this.workbench.hovered) this.workbench.hover(null);
  }

  middle(): TauPair {
    const {input, output} = this.workbench.window;
    return [(input[0] + input[1]) / 2, (output[0] + output[1]) / 2];
  }
  zoom_at(place: TauPair, factor: number): void {
    this.workbench.zoom(zoomed(this.workbench.window, place, factor));
  }
  /** By pixels, as the pointer drags it. */
  pan(x: number, y: number): void {
    this.workbench.zoom(panned(this.workbench.window, ...this.turned([y / this.height, -x / this.size])));
  }
  /** Index of the map's cell at a place; nothing where the map on screen does not reach. */
  cell(place: TauPair): number | null {
    const map = this.workbench.map;
    if (!map) return null;
    const index = (at: number, [from, to]: readonly [number, number], count: number) =>
      at === to ? count - 1 : Math.floor(((at - from) / (to - from)) * count);
    const row = index(place[0], map.window.input, map.rows),
      column = index(place[1], map.window.output, map.columns);
    return row < 0 || column < 0 || row >= map.rows || column >= map.columns ? null : row * map.columns + column;
  }
  /** Nothing to take hold of here: a defect, or no four-bar. */
  is_empty(place: TauPair): boolean {
    const cell = this.cell(place),
      map = this.workbench.map;
    return cell === null || !map || map.type[cell]! === degenerate || map.defects[cell] !== 0;
  }
}
