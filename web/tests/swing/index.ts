// A kind of task that is none: a body on one hinge. For the test that the frame takes a kind that it has never heard of,
// with its own stage, what can be required in its own way, and no map.
import type {Linkage, Point} from "../../src/contract/messages";
import type {Problem} from "../../src/state/problem";
import {is_number, is_pair} from "../../src/state/shape";
import type {Task} from "../../src/state/task";
import type {TaskModule} from "../../src/kinds/kind";

declare module "../../src/contract/messages" {
  interface Requirements {
    max_swing_deg?: number | null;
  }
}
export interface SwingTask extends Task {
  kind: "swing";
  mechanism: "hinge";
  hinge: Point;
  radius: number;
  swings_deg: readonly [number, number];
}
/** Where its tip is after a turn. */
export function tip_of({hinge: [x, y], radius}: SwingTask, turned_deg: number): Point {
  const angle = (turned_deg * Math.PI) / 180;
  return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
}
export function new_problem(): Problem {
  const task: SwingTask = {kind: "swing", mechanism: "hinge", hinge: [10, 20], radius: 50, swings_deg: [0, 90]};
  return {linkwright: 1, title: "A gate", length_unit: "mm", task, requirements: {max_swing_deg: 120}};
}
/** What an engine would answer. */
export function swinging(task: SwingTask): Linkage {
  const states = Float64Array.from(
    [0, 90].flatMap((turned) => [turned, ...tip_of(task, turned), ...Array(10).fill(0)]),
  );
  const ticks = [0, 1].map((row) => ({position: row + 1, state: row, reached: true}));
  const drive = {states, width: 13, ticks, full_turn: false, limits: {low: null, high: null}, task: [0, 1]};
  const none = {defects: {order: false, branch: false, circuit: false}, reason: null, lengths: null, swapped: null};
  const measured = {link_ratio: null, longest: null, min_transmission_angle_deg: null};
  const turning = {min_transmission_angle_full_turn_deg: null, driver_sweep_deg: 90};
  const more = {...turning, drive_sense: "ccw", dead_points_deg: [], residual: 0, fails: 0, drive};
  return {tau: [0, 0], type: "crank_rocker", ...none, ...measured, ...more} as unknown as Linkage;
}

export const swing: TaskModule<SwingTask> = {
  name: "task.kind_motion",
  is: (task): task is SwingTask => task.kind === "swing",
  read({kind, hinge, radius, swings_deg}) {
    if (kind !== "swing" || !is_pair(hinge) || !is_number(radius) || !is_pair(swings_deg)) return null;
    return {kind, mechanism: "hinge", hinge, radius, swings_deg};
  },
  incompleteness: () => null,
  stops: () => 2,
  pattern: () => "P-P",
  is_mixed: () => false,
  anchors: (task) => [task.hinge, ...task.swings_deg.map((swing) => tip_of(task, swing))],
  default_max_length: ({task}) => 3 * (task as SwingTask).radius,
  map_of: () => "swing",
  properties: {},
  types: ["crank_rocker"],
  requirements: {
    max_swing_deg: {name: "req.title", short: "req.title", term: null, control: "own", is_value: is_number},
  },
  objectives: {},
  moved: (task, point) => ({...task, hinge: point(task.hinge)}),
  table: ({swings_deg}) => ({head: ["swing °"], rows: swings_deg.map((swing) => [String(swing)])}),
  beginnings: [{id: "swing", name: "new.function", about: "new.function_about", make: new_problem}],
  kept_pivots: () => ({hinge: [10, 20]}),
  lengths: () => [{key: "radius", name: "radius", length: 50, color: null}],
  joints: () => [{key: "hinge", name: "hinge", at: [10, 20], on_ground: true, color: "ink"}],
  view: async () => (await import("./view")).swing_view,
};
