// Requirement boxes: drawn with a rubber band, moved and resized at their borders.
import type {Box, Point} from "../../contract/messages";
import {with_options, with_requirements, type Problem} from "../../state/problem";
import type {BoxName, Edges, Target} from "../handles";
import {edge_cursor} from "../handles";
import {length_note} from "../notes";
import {multiple, type Keys} from "../snapping";
import type {Bench} from "../bench";
import {Way, type Drag} from "./drag";

export function with_box(problem: Problem, name: BoxName, box: Box | null | undefined): Problem {
  if (name === "search") return with_options(problem, {box: box ?? undefined});
  return with_requirements(problem, name === "ground" ? {ground_pivots_within: box} : {moving_pivots_within: box});
}
export function ordered(a: number, b: number): [number, number] {
  return a <= b ? [a, b] : [b, a];
}
function snapped(value: number, bench: Bench, keys: Keys): number {
  const {step, snaps} = bench.scene.space;
  return multiple(value, keys.alt || !snaps ? 10 ** Math.floor(Math.log10(step / 80)) : keys.fine ? step / 10 : step);
}
function size_note(box: Box, bench: Bench): string {
  const {step} = bench.scene.space;
  return `${length_note(box.x[1] - box.x[0], step, "")} × ${length_note(box.y[1] - box.y[0], step, bench.workbench.unit)}`;
}
/** A box whose edges follow a pointer's way; an edge dragged across the other turns the box over. */
export function moved_box(box: Box, edges: Edges, x: number, y: number, snap: (value: number) => number): Box {
  if (edges.x === 0 && edges.y === 0) {
    const left = snap(box.x[0] + x),
      low = snap(box.y[0] + y);
    const tidy = (value: number) => Number(value.toPrecision(12));
    return {x: [left, tidy(left + box.x[1] - box.x[0])], y: [low, tidy(low + box.y[1] - box.y[0])]};
  }
  const along = (values: readonly [number, number], edge: number, by: number): [number, number] =>
    edge < 0
      ? ordered(snap(values[0] + by), values[1])
      : edge > 0
        ? ordered(values[0], snap(values[1] + by))
        : [values[0], values[1]];
  return {x: along(box.x, edges.x, x), y: along(box.y, edges.y, y)};
}
/** By arrow keys an edge stops before the other: no box turns over. */
export function nudged_box(box: Box, edges: Edges, dx: number, dy: number): Box | null {
  const whole = edges.x === 0 && edges.y === 0,
    add = (value: number, by: number) => Number((value + by).toPrecision(12));
  const along = ([low, high]: readonly [number, number], edge: number, by: number): [number, number] => [
    whole || edge < 0 ? add(low, by) : low,
    whole || edge > 0 ? add(high, by) : high,
  ];
  const moved = {x: along(box.x, edges.x, dx), y: along(box.y, edges.y, dy)};
  return has_area(moved) ? moved : null;
}
function has_area(box: Box): boolean {
  return box.x[1] > box.x[0] && box.y[1] > box.y[0];
}

export function box_drag(bench: Bench, target: Extract<Target, {kind: "box"}>, from: Point): Drag {
  const {workbench, scene} = bench,
    way = new Way(scene, from);
  const start = scene.boxes[target.box]!;
  workbench.begin_gesture();
  scene.held = target;
  return {
    cursor: edge_cursor(target.edges),
    move(at, keys) {
      const {x, y} = way.to(at, keys),
        box = moved_box(start, target.edges, x, y, (value) => snapped(value, bench, keys));
      if (!has_area(box)) return;
      workbench.drag((problem) => with_box(problem, target.box, box));
      scene.tell(at, size_note(box, bench), null);
    },
    end: () => scene.finish(true),
    cancel: () => scene.finish(false),
  };
}

/** The rubber band: what it spans is the requirement at once, so that the map follows. */
export function rubber_drag(bench: Bench, name: BoxName, from: Point): Drag {
  const {workbench, scene} = bench,
    start = scene.space.unproject(from);
  workbench.begin_gesture();
  return {
    cursor: "crosshair",
    move(at, keys) {
      const here = scene.space.unproject(at),
        snap = (value: number) => snapped(value, bench, keys);
      const box: Box = {x: ordered(snap(start[0]), snap(here[0])), y: ordered(snap(start[1]), snap(here[1]))};
      scene.rubber = {box: name, shape: box};
      if (!has_area(box)) return;
      workbench.drag((problem) => with_box(problem, name, box));
      scene.tell(at, size_note(box, bench), null);
    },
    end() {
      scene.finish(true);
      workbench.mode = "point";
    },
    cancel: () => scene.finish(false),
  };
}
