// What the drawing shows when a task is opened, and when one asks for everything.
import type {Drive, Linkage, Point} from "../engine/protocol";
import {row_joints, row_state} from "../state/drive";
import {placed, type Problem} from "../state/problem";
import type {Pose} from "../state/task";
import {bounds, fitted, type Margins, type Viewport} from "./viewport";

/** Where the task lies, with the body in its positions. */
export function task_points(
  anchors: readonly Point[],
  poses: readonly Pose[],
  outline: readonly Point[],
  has_body: boolean,
): Point[] {
  return [...anchors, ...(has_body ? poses.flatMap((pose) => outline.map((p) => placed(p, pose))) : [])];
}
/** How far from the rest, in its sizes, a pivot is shown with it: unasked, and when one asks to see all. */
export const near = 1.5,
  far = 20;
/** Pivots that lie near enough to the rest to be shown with it, the moving ones in every position. */
export function useful_pivots(
  linkage: Linkage | null,
  around: readonly Point[],
  poses: readonly Pose[],
  sizes = near,
): Point[] {
  const box = bounds(around);
  if (!linkage || !box) return [];
  const reach = sizes * Math.max(box.x[1] - box.x[0], box.y[1] - box.y[0]);
  const visits =
      linkage.drive && (poses.length === 0 || sizes > near)
        ? visited(linkage.drive, linkage.six_bar !== undefined)
        : [],
    joints = linkage.six_bar?.joints.map(({at}) => at) ?? [];
  return [
    linkage.input.center,
    linkage.output.center,
    linkage.input.circle,
    linkage.output.circle,
    ...visits,
    ...joints,
  ].filter(
    (p): p is Point =>
      p !== null &&
      p[0] > box.x[0] - reach &&
      p[0] < box.x[1] + reach &&
      p[1] > box.y[0] - reach &&
      p[1] < box.y[1] + reach,
  );
}
function visited(drive: Drive, six_bar: boolean): Point[] {
  return drive.ticks
    .filter(({reached}) => reached)
    .flatMap(({state}): Point[] => {
      if (six_bar) return row_joints(drive, state);
      const {ax, ay, bx, by} = row_state(drive, state);
      return [
        [ax, ay],
        [bx, by],
      ];
    });
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
