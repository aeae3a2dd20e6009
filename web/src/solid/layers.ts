// In which layer each link's plate lies, so that nothing collides as the linkage moves: the first order without a
// collision over the drive table. Plates are straight with round ends; pins reach from the layer of one of their links
// to that of the other, and block what lies between.
import type {Drive, Point} from "../engine/protocol";
import {row_count, row_state, type State} from "../state/drive";
import {task_span} from "../transport/play";

export interface Order {
  input: number;
  coupler: number;
  output: number;
}
export type Link = keyof Order;
/** What a plate can run into: another plate, or a pin by the link it holds. */
export type Obstacle = Link | "input_ground_pin" | "output_ground_pin" | "input_coupler_pin" | "output_coupler_pin";
export interface Crossing {
  link: Link;
  obstacle: Obstacle;
  from_deg: number;
  to_deg: number;
}
export interface LayerPlan {
  order: Order;
  /** Over which stretch: the travel; or the task only, where no order lasts the travel. */
  over: "travel" | "task";
  /** None where the order is free of collisions. */
  crossings: Crossing[];
}
/** Of the longest link. */
export const plate_width = 0.12,
  plate_thickness = 0.06,
  pin_diameter = 0.05;

/** Ground is 0. Simple orders first; then those in which the ground pins end below the coupler. */
export const orders: readonly Order[] = [
  {input: 1, coupler: 2, output: 1},
  {input: 1, coupler: 2, output: 3},
  {input: 3, coupler: 2, output: 1},
  {input: 1, coupler: 3, output: 2},
  {input: 2, coupler: 3, output: 1},
];

export function plan_layers(drive: Drive, input_center: Point, output_center: Point, longest: number): LayerPlan {
  const states = Array.from({length: row_count(drive)}, (_, row) => row_state(drive, row));
  const crossings_of = (order: Order, within: State[]) =>
    crossings(order, within, input_center, output_center, longest);
  const over_travel = orders.map((order) => ({order, over: "travel" as const, crossings: crossings_of(order, states)}));
  const free = over_travel.find((plan) => plan.crossings.length === 0);
  if (free) return free;
  const task = task_span(drive);
  if (!task) return least(over_travel);
  const in_task = states.filter((s) => s.input_deg >= task[0] && s.input_deg <= task[1]);
  const over_task = orders.map((order) => ({order, over: "task" as const, crossings: crossings_of(order, in_task)}));
  const free_in_task = over_task.find((plan) => plan.crossings.length === 0);
  return free_in_task ?? least(over_travel);
}
function least<Plan extends LayerPlan>(plans: Plan[]): Plan {
  const angle = (plan: Plan) => plan.crossings.reduce((sum, c) => sum + c.to_deg - c.from_deg, 0);
  return plans.reduce((best, plan) => (angle(plan) < angle(best) ? plan : best));
}

type Segment = readonly [Point, Point];
interface Place {
  plates: Record<Link, Segment>;
  pins: Record<Exclude<Obstacle, Link>, Point>;
}
function place_at(state: State, input_center: Point, output_center: Point): Place {
  const a: Point = [state.ax, state.ay],
    b: Point = [state.bx, state.by];
  return {
    plates: {input: [input_center, a], coupler: [a, b], output: [output_center, b]},
    pins: {
      input_ground_pin: input_center,
      output_ground_pin: output_center,
      input_coupler_pin: a,
      output_coupler_pin: b,
    },
  };
}

interface Check {
  link: Link;
  obstacle: Obstacle;
}
/** What can meet at all in this order. Links joined by a pin are never in one layer. */
function checks_of(order: Order): Check[] {
  const checks: Check[] = [];
  const pairs: [Link, Link][] = [
    ["input", "output"],
    ["input", "coupler"],
    ["coupler", "output"],
  ];
  for (const [link, obstacle] of pairs) if (order[link] === order[obstacle]) checks.push({link, obstacle});
  const pins: [Exclude<Obstacle, Link>, number, number][] = [
    ["input_ground_pin", 0, order.input],
    ["output_ground_pin", 0, order.output],
    ["input_coupler_pin", order.input, order.coupler],
    ["output_coupler_pin", order.output, order.coupler],
  ];
  for (const [obstacle, one, other] of pins) {
    for (const link of Object.keys(order) as Link[]) {
      if (order[link] > Math.min(one, other) && order[link] < Math.max(one, other)) checks.push({link, obstacle});
    }
  }
  return checks;
}
export function crossings(
  order: Order,
  states: State[],
  input_center: Point,
  output_center: Point,
  longest: number,
): Crossing[] {
  const half = (plate_width * longest) / 2,
    pin = (pin_diameter * longest) / 2;
  const found: Crossing[] = [];
  for (const {link, obstacle} of checks_of(order)) {
    let open: Crossing | null = null;
    for (const state of states) {
      const {plates, pins} = place_at(state, input_center, output_center);
      const meets =
        obstacle in plates
          ? segment_distance(plates[link], plates[obstacle as Link]) < 2 * half
          : point_distance(plates[link], pins[obstacle as keyof Place["pins"]]) < half + pin;
      if (!meets) open = null;
      else if (open) open.to_deg = state.input_deg;
      else found.push((open = {link, obstacle, from_deg: state.input_deg, to_deg: state.input_deg}));
    }
  }
  return found;
}

export function point_distance([a, b]: Segment, p: Point): number {
  const dx = b[0] - a[0],
    dy = b[1] - a[1],
    square = dx * dx + dy * dy;
  const along = square > 0 ? Math.min(Math.max(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / square, 0), 1) : 0;
  return Math.hypot(a[0] + along * dx - p[0], a[1] + along * dy - p[1]);
}
export function segment_distance(one: Segment, other: Segment): number {
  if (side(one, other[0]) * side(one, other[1]) < 0 && side(other, one[0]) * side(other, one[1]) < 0) return 0;
  return Math.min(
    point_distance(one, other[0]),
    point_distance(one, other[1]),
    point_distance(other, one[0]),
    point_distance(other, one[1]),
  );
}
function side([a, b]: Segment, p: Point): number {
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}
