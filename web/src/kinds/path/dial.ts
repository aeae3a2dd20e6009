// The dial about the crank's ground pivot: a mark to each point where its angle is given, in the direction that it has there.
import type {Point} from "../../contract/messages";
import type {Surface} from "../../drawing/surface";
import {points_of} from "./points";

export interface Dial {
  center: Point; // screen
  radius: number; // px
  /** Direction of the angle 0. */
  zero_deg: number;
  marks: {index: number; at: Point; angle_deg: number}[];
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
/** Of the picked linkage, so that it can be reached where one in hand follows the pointer; null where its crank has no two
 *  pivots, or no angles of it are given. */
function placed({workbench, space}: Surface): Pick<Dial, "center" | "zero_deg"> | null {
  const {path, input} = workbench.picked_linkage ?? {},
    points = points_of(workbench.problem),
    first = points.findIndex(({input_deg}) => input_deg !== undefined);
  if (!path || !input?.center || !input.circle || first < 0) return null;
  const [x, y] = input.circle,
    lies_deg = (Math.atan2(y - input.center[1], x - input.center[0]) * 180) / Math.PI,
    turned_deg = path.input_deg_at_points?.[first] ?? 0; // it lies as at the first point of all
  return {center: space.project(input.center), zero_deg: lies_deg + turned_deg - points[first]!.input_deg!};
}
export function dial_of(surface: Surface): Dial | null {
  const at = held.get(surface) ?? placed(surface);
  if (!at) return null;
  const marks = points_of(surface.workbench.problem).flatMap(({input_deg}, index) =>
    input_deg === undefined
      ? []
      : [{index, angle_deg: input_deg, at: on_dial(at.center, radius, at.zero_deg + input_deg)}],
  );
  return {...at, radius, marks};
}
