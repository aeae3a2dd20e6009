// In which layer each link's plate lies, so that nothing collides as the linkage moves: the first order without a
// collision over its motion. Plates are straight with round ends; pins reach from the layer of one of their links to that
// of the other, and block what lies between.
import type {Drive, Linkage, Point} from "../contract/messages";
import {bar_of, type Body, type Figure, type Joint} from "../figure/figure";
import {at_row, type Mechanism, type PlateOrder} from "../figure/mechanism";
import {angle_of_row, row_count} from "../state/drive";
import {least_of, most_of} from "../state/ends";
import {task_span, type Span} from "../transport/play";

export interface Crossing {
  link: string;
  /** What its plate runs into: another plate by its link's name, or a pin by its joint's, as `input_ground_pin`. */
  obstacle: string;
  from_deg: number;
  to_deg: number;
}
export interface LayerPlan {
  order: PlateOrder;
  /** Over which stretch: the travel; or the task only, where no order lasts the travel. */
  over: "travel" | "task";
  /** None where the order is free of collisions. */
  crossings: Crossing[];
}
/** The linkage at a driver angle. */
export interface Moment {
  input_deg: number;
  figure: Figure;
}
/** Of the longest link. */
export const plate_width = 0.12,
  plate_thickness = 0.06,
  pin_diameter = 0.05;

export function moments_of(mechanism: Mechanism, linkage: Linkage, drive: Drive): Moment[] {
  return Array.from({length: row_count(drive)}, (_, row) => ({
    input_deg: angle_of_row(drive, row),
    figure: mechanism.figure(linkage, at_row(mechanism, linkage, drive, row)),
  }));
}
/** Of the orders, the simplest first, one that lasts the travel, or else the task, or else longest. */
export function plan_layers(
  mechanism: Mechanism,
  linkage: Linkage,
  drive: Drive,
  orders: readonly PlateOrder[],
  longest: number,
): LayerPlan | null {
  const travel = moments_of(mechanism, linkage, drive),
    span = task_span(drive);
  const over_travel = plans_over(travel, "travel", orders, longest),
    over_task = () => (span ? plans_over(within(travel, span), "task", orders, longest) : []);
  return free(over_travel) ?? free(over_task()) ?? least(over_travel);
}
function plans_over(moments: Moment[], over: LayerPlan["over"], orders: readonly PlateOrder[], longest: number) {
  return orders.map((order): LayerPlan => ({order, over, crossings: crossings(order, moments, longest)}));
}
function within(moments: Moment[], [low, high]: Span): Moment[] {
  return moments.filter(({input_deg}) => input_deg >= low && input_deg <= high);
}
function free(plans: LayerPlan[]): LayerPlan | undefined {
  return plans.find((plan) => plan.crossings.length === 0);
}
function least([first, ...others]: LayerPlan[]): LayerPlan | null {
  const angle = (plan: LayerPlan) => plan.crossings.reduce((sum, c) => sum + c.to_deg - c.from_deg, 0);
  return first ? others.reduce((best, plan) => (angle(plan) < angle(best) ? plan : best), first) : null;
}

type Segment = readonly [Point, Point];
/** Layers of what a joint joins, the lower one first. */
export function pin_layers({joins: [one, other]}: Joint, order: PlateOrder): [low: number, high: number] {
  const layers = [order[one] ?? 0, order[other] ?? 0] as const;
  return [least_of(layers), most_of(layers)];
}

interface Check {
  link: string;
  obstacle: string;
  meets(figure: Figure): boolean;
}
/** What can meet at all in this order. Links joined by a pin are never in one layer. */
function checks_of({bodies, joints}: Figure, order: PlateOrder, longest: number): Check[] {
  const half = (plate_width * longest) / 2,
    reach = half + (pin_diameter * longest) / 2;
  const layer = ({name}: Body) => order[name] ?? 0;
  const plates = bodies.flatMap((body, i) =>
    bodies
      .slice(i + 1)
      .filter((other) => layer(other) === layer(body))
      .map(({name}): Check => ({
        link: body.name,
        obstacle: name,
        meets(figure) {
          const one = bar_of(figure, body.name),
            other = bar_of(figure, name);
          return one !== null && other !== null && segment_distance(one, other) < 2 * half;
        },
      })),
  );
  const pins = joints.flatMap((joint, k) => {
    const [low, high] = pin_layers(joint, order);
    return bodies
      .filter((body) => layer(body) > low && layer(body) < high)
      .map(({name}): Check => ({
        link: name,
        obstacle: `${joint.name}_pin`,
        meets(figure) {
          const plate = bar_of(figure, name),
            pin = figure.joints[k];
          return plate !== null && pin !== undefined && point_distance(plate, pin.at) < reach;
        },
      }));
  });
  return [...plates, ...pins];
}
export function crossings(order: PlateOrder, moments: readonly Moment[], longest: number): Crossing[] {
  const [first] = moments,
    found: Crossing[] = [];
  for (const {link, obstacle, meets} of first ? checks_of(first.figure, order, longest) : []) {
    let open: Crossing | null = null;
    for (const {input_deg, figure} of moments) {
      if (!meets(figure)) open = null;
      else if (open) open.to_deg = input_deg;
      else found.push((open = {link, obstacle, from_deg: input_deg, to_deg: input_deg}));
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
