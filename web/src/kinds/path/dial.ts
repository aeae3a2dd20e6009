// The dial about the crank's ground pivot: a mark to each point, in the direction that the crank has there.
import type {Point} from "../../contract/messages";
import type {Surface} from "../../drawing/surface";
import {path_task, points_of} from "./points";

export interface Dial {
  center: Point; // screen
  radius: number; // px
  /** Direction of the angle 0. */
  zero_deg: number;
  marks: {at: Point; angle_deg: number}[];
}
const radius = 44;

/** While a mark is dragged the dial keeps still. */
const held = new WeakMap<Surface, Pick<Dial, "center" | "zero_deg">>();
export function hold_dial(surface: Surface): void {
  const dial = dial_of(surface);
  if (dial) held.set(surface, dial);
}
export function release_dial(surface: Surface): void {
  held.delete(surface);
}

export function on_dial([x, y]: Point, reach: number, direction_deg: number): Point {
  const angle = (direction_deg * Math.PI) / 180;
  return [x + reach * Math.cos(angle), y - reach * Math.sin(angle)];
}
/** Of the linkage in hand; null where its crank has no two pivots, or no angles of it are given. */
function placed({workbench, space}: Surface): Pick<Dial, "center" | "zero_deg"> | null {
  const {center, circle} = workbench.hand?.path ? workbench.hand.input : {center: null, circle: null},
    task = path_task(workbench.problem),
    first = task?.points[0];
  if (!center || !circle || !first || task.given) return null;
  const lies_deg = (Math.atan2(circle[1] - center[1], circle[0] - center[0]) * 180) / Math.PI;
  return {center: space.project(center), zero_deg: lies_deg - (first.input_deg ?? 0)};
}
export function dial_of(surface: Surface): Dial | null {
  const at = held.get(surface) ?? placed(surface);
  if (!at) return null;
  const marks = points_of(surface.workbench.problem).map(({input_deg = 0}) => ({
    angle_deg: input_deg,
    at: on_dial(at.center, radius, at.zero_deg + input_deg),
  }));
  return {...at, radius, marks};
}
