// What the drawing shows when a task is opened, and when one asks for everything.
import type {Point} from "../contract/messages";
import {placed, type Problem} from "../state/problem";
import type {Pose} from "../state/task";
import {bounds, fitted, to_screen, type Margins, type Viewport} from "./viewport";

/** Where the task lies, with the body in its positions. */
export function task_points(
  anchors: readonly Point[],
  poses: readonly Pose[],
  outline: readonly Point[],
  has_body: boolean,
): Point[] {
  return [...anchors, ...(has_body ? poses.flatMap((pose) => outline.map((p) => placed(p, pose))) : [])];
}
/** How far from the rest, in its sizes, a pivot is shown with it: before there is a linkage in hand, with that one, and when
 *  one asks to see all. */
export const near = 1.5,
  reachable = 6,
  far = 20;
/** Pivots that lie near enough to the rest to be shown with it. */
export function useful_pivots(pivots: readonly Point[], around: readonly Point[], sizes = near): Point[] {
  const box = bounds(around);
  if (!box) return [];
  const reach = sizes * Math.max(box.x[1] - box.x[0], box.y[1] - box.y[0]);
  return pivots.filter(
    ([x, y]) => x > box.x[0] - reach && x < box.x[1] + reach && y > box.y[0] - reach && y < box.y[1] + reach,
  );
}
export function box_points({requirements}: Problem): Point[] {
  return [requirements?.ground_pivots_within, requirements?.moving_pivots_within].flatMap((box) =>
    box ? [[box.x[0], box.y[0]] as Point, [box.x[1], box.y[1]] as Point] : [],
  );
}

/** Room for what floats over the drawing: the tool row above, a sentence or the tour's hint below. */
export function margins(phone: boolean, hint: boolean): Margins {
  return phone ? {left: 16, right: 16, top: 16, bottom: 16} : {left: 20, right: 20, top: 48, bottom: hint ? 100 : 28};
}
export function view_of(points: readonly Point[], width: number, height: number, around: Margins): Viewport {
  return fitted(bounds(points) ?? {x: [-250, 250], y: [-200, 200]}, width, height, around);
}

/** What lies over the drawing, in its pixels. */
export interface Cover {
  left: number;
  top: number;
  right: number;
  bottom: number;
}
export function is_covered(view: Viewport, point: Point, {left, top, right, bottom}: Cover): boolean {
  const [x, y] = to_screen(view, point);
  return x > left && x < right && y > top && y < bottom;
}
/** The same where something lies over a part of it: beside that, if a point would be below. */
export function view_beside(points: readonly Point[], view: Viewport, around: Margins, cover: Cover | null): Viewport {
  if (!cover || !points.some((point) => is_covered(view, point, cover))) return view;
  const {width, height} = view,
    gap = 12;
  const beside: Partial<Margins>[] = [
    {top: cover.bottom + gap},
    {bottom: height - cover.top + gap},
    {left: cover.right + gap},
    {right: width - cover.left + gap},
  ];
  const views = beside.map((margin) => view_of(points, width, height, {...around, ...margin}));
  return views.reduce((best, other) => (other.scale > best.scale ? other : best));
}
