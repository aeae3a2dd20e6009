// What can be taken hold of on the drawing: where each thing lies on the screen and how near a pointer must come.
import type {Box, Linkage, Point, Side} from "../contract/messages";
import type {End, Ends} from "../figure/figure";
import {placed, type Problem} from "../state/problem";
import {poses_of, type Pose} from "../state/task";
import {bend_of, travel_of} from "../task_panel/travel";
import type {Spot} from "./curve_samples";
import type {Drag} from "./drags/drag";
import type {Plane} from "./space";

/** Of the requirements, and where a search puts its pivots. */
export const box_names = ["ground", "moving", "search"] as const;
export type BoxName = (typeof box_names)[number];
/** Which edges of a box move: −1 the lesser, 1 the greater, 0 neither; both 0 moves the box. */
export interface Edges {
  x: -1 | 0 | 1;
  y: -1 | 0 | 1;
}
export type Target =
  | {kind: "disc" | "knob" | "body" | "velocity" | "curvature"; pose: number}
  | {kind: "pivot"; side: Side; end: End; home: boolean}
  | {kind: "corner" | "midpoint"; index: number}
  | {kind: "box"; box: BoxName; edges: Edges}
  | {kind: "traced"; index: number}
  | TaskPart
  | {kind: "curve"; spot: Spot};
/** A part of the task that its kind brings (kinds/view.ts), and what it does. */
export interface TaskPart {
  kind: "task";
  part: string;
  label(): string;
  drag(from: Point): Drag;
  /** Arrow keys: steps to the right and up. */
  nudge(dx: number, dy: number, step: number): void;
}
export interface Handle {
  id: string;
  target: Target;
  at: Point; // screen
  rank: number;
  reach: readonly [mouse: number, touch: number];
  cursor: string;
  tab: boolean;
  /** Where it is more than a point: how far it lies from a point of the screen. */
  distance?(at: Point): number;
}

/** Priority where targets overlap. Then come the curves, thin as they are, and the insides of bodies. */
export const ranks = {selected: 0, disc: 1, knob: 2, pivot: 3, corner: 4, box: 5} as const;
export const arm_length = 58,
  arrow_length = 46,
  curvature_reach = 74;

export function target_id(target: Target): string {
  switch (target.kind) {
    case "pivot":
      return `pivot_${target.side}_${target.end}${target.home ? "_home" : ""}`;
    case "corner":
    case "midpoint":
    case "traced":
      return `${target.kind}_${target.index + 1}`;
    case "box":
      return `box_${target.box}_${target.edges.x}_${target.edges.y}`;
    case "curve":
      return `curve_${target.spot.curve}`;
    case "task":
      return target.part;
    default:
      return `${target.kind}_${target.pose + 1}`;
  }
}
function handle(
  target: Target,
  at: Point,
  rank: number,
  reach: readonly [number, number],
  cursor: string,
  tab = true,
): Handle {
  return {id: target_id(target), target, at, rank, reach, cursor, tab};
}

/** A unit vector on the screen in the direction of travel; nothing where the body turns about its origin. */
export function travel_direction(pose: Pose): Point | null {
  const travel = travel_of(pose),
    angle = ((travel?.direction_deg ?? 0) * Math.PI) / 180;
  return travel && [Math.cos(angle), -Math.sin(angle)];
}
/** The handle of the curvature lies on the osculating parabola, a fixed way along the tangent. */
export function curvature_place(pose: Pose, space: Plane): Point | null {
  const along = travel_direction(pose),
    bend = bend_of(pose);
  if (!along || !bend) return null;
  const [x, y] = space.project([pose.x, pose.y]),
    reach = curvature_reach;
  const rise = (bend.curvature * reach * reach) / 2 / space.scale;
  return [x + along[0] * reach + along[1] * rise, y + along[1] * reach - along[0] * rise];
}
export function knob_place(pose: Pose, space: Plane, length: number): Point {
  const [x, y] = space.project([pose.x, pose.y]),
    angle = (pose.theta_deg * Math.PI) / 180;
  return [x + length * Math.cos(angle), y - length * Math.sin(angle)];
}

export function task_handle(part: Omit<TaskPart, "kind">, at: Point, cursor = "grab"): Handle {
  return handle({kind: "task", ...part}, at, ranks.knob, [14, 24], cursor);
}
/** Handles of the poses; on a phone only the selected pose has its knob. */
export function pose_handles(problem: Problem, space: Plane, selected: number | null, phone: boolean): Handle[] {
  return poses_of(problem.task).flatMap((pose, i) => {
    const rank = (usual: number) => (i === selected ? ranks.selected : usual);
    const at = space.project([pose.x, pose.y]);
    const handles = [handle({kind: "disc", pose: i}, at, rank(ranks.disc), [14, 24], "move")];
    if (!phone || i === selected)
      handles.push(
        handle({kind: "knob", pose: i}, knob_place(pose, space, arm_length), rank(ranks.knob), [12, 24], "grab"),
      );
    const along = travel_direction(pose),
      bend = curvature_place(pose, space);
    if (along)
      handles.push(
        handle(
          {kind: "velocity", pose: i},
          [at[0] + along[0] * arrow_length, at[1] + along[1] * arrow_length],
          rank(ranks.knob),
          [14, 24],
          "grab",
        ),
      );
    if (bend) handles.push(handle({kind: "curvature", pose: i}, bend, rank(ranks.knob), [14, 24], "grab"));
    return handles;
  });
}

/** Pivots where they are now; one that moves can be taken at its home on its curve as well. */
export function pivot_handles(linkage: Linkage, now: Ends, space: Plane): Handle[] {
  const handles: Handle[] = [];
  for (const side of ["input", "output"] as const) {
    const ends = (["center", "circle"] as const).flatMap((end) =>
      now[side][end] ? [{end, at: space.project(now[side][end])}] : [],
    );
    for (const {end, at} of ends)
      handles.push(handle({kind: "pivot", side, end, home: false}, at, ranks.pivot, [14, 24], "pointer"));
    for (const {end, at} of ends) {
      const place = linkage[side][end],
        home = place && space.project(place);
      if (home && Math.hypot(home[0] - at[0], home[1] - at[1]) > 12) {
        handles.push(
          handle({kind: "pivot", side, end, home: true}, home, ranks.pivot + 0.5, [10, 20], "pointer", false),
        );
      }
    }
  }
  return handles;
}

const corner_edges: Edges[] = [
  {x: -1, y: 1},
  {x: 1, y: 1},
  {x: 1, y: -1},
  {x: -1, y: -1},
];
export function box_handles(name: BoxName, box: Box, space: Plane): Handle[] {
  const along = (values: readonly [number, number], edge: number) =>
    edge < 0 ? values[0] : edge > 0 ? values[1] : (values[0] + values[1]) / 2;
  return [{x: 0, y: 0} as Edges, ...corner_edges].map((edges) => {
    const at = space.project([along(box.x, edges.x), edges.y === 0 ? box.y[1] : along(box.y, edges.y)]);
    return handle({kind: "box", box: name, edges}, at, ranks.box, [8, 20], edge_cursor(edges));
  });
}
export function edge_cursor(edges: Edges): string {
  if (edges.x === 0 && edges.y === 0) return "move";
  if (edges.x === 0) return "ns-resize";
  if (edges.y === 0) return "ew-resize";
  return edges.x === edges.y ? "nesw-resize" : "nwse-resize";
}
/** Which part of a box's border is under the pointer: its edges, or just inside of them the whole box. */
export function border_hit(box: Box, space: Plane, at: Point, reach: number): {edges: Edges; distance: number} | null {
  const [left, top] = space.project([box.x[0], box.y[1]]),
    [right, bottom] = space.project([box.x[1], box.y[0]]);
  if (at[0] < left - reach || at[0] > right + reach || at[1] < top - reach || at[1] > bottom + reach) return null;
  const near = (value: number, low: number, high: number): -1 | 0 | 1 =>
    Math.abs(value - low) <= reach && Math.abs(value - low) <= Math.abs(value - high)
      ? -1
      : Math.abs(value - high) <= reach
        ? 1
        : 0;
  const x = near(at[0], left, right),
    y = near(at[1], bottom, top);
  const distance = Math.min(
    Math.abs(at[0] - left),
    Math.abs(at[0] - right),
    Math.abs(at[1] - top),
    Math.abs(at[1] - bottom),
  );
  if (x !== 0 || y !== 0) return {edges: {x, y}, distance};
  return distance <= reach + 12 ? {edges: {x: 0, y: 0}, distance} : null;
}

/** Corners, and the middles of edges that are long enough to leave room for a corner. */
export function corner_handles(outline: readonly Point[], pose: Pose, space: Plane): Handle[] {
  const corners = outline.map((p) => space.project(placed(p, pose)));
  return corners.flatMap((at, index) => {
    const next = corners[(index + 1) % corners.length] ?? at,
      middle: Point = [(at[0] + next[0]) / 2, (at[1] + next[1]) / 2],
      long = Math.hypot(next[0] - at[0], next[1] - at[1]) >= 24;
    const corner = handle({kind: "corner", index}, at, ranks.selected - 1, [12, 24], "crosshair");
    return long
      ? [corner, handle({kind: "midpoint", index}, middle, ranks.selected - 1, [12, 24], "crosshair")]
      : [corner];
  });
}

export function inside(polygon: readonly Point[], at: Point): boolean {
  let within = false;
  for (const [i, [xi, yi]] of polygon.entries()) {
    const [xj, yj] = polygon.at(i - 1)!; // the last one before the first
    if (yi > at[1] !== yj > at[1] && at[0] < ((xj - xi) * (at[1] - yi)) / (yj - yi) + xi) within = !within;
  }
  return within;
}

const seen = 0.75; // of a handle's reach: what is drawn; the rest helps who aims beside it

/** Handles within reach, the first to be taken first: of those under the pointer, then of those beside it. */
export function within_reach(handles: readonly Handle[], at: Point, touch: boolean): Handle[] {
  return handles
    .map((h) => {
      const distance = h.distance?.(at) ?? Math.hypot(h.at[0] - at[0], h.at[1] - at[1]),
        reach = h.reach[touch ? 1 : 0];
      return {h, distance, reach, beside: Number(distance > seen * reach)};
    })
    .filter(({distance, reach}) => distance <= reach)
    .sort((a, b) => a.beside - b.beside || a.h.rank - b.h.rank || a.distance - b.distance)
    .map(({h}) => h);
}
