// What the table does to the list of poses.
import type {Box, Point} from "../engine/protocol";
import {body_point, same_poses, with_poses, type Pin, type Pose} from "../state/problem";
import type {Document} from "../state/document";

export function moved(poses: readonly Pose[], from: number, to: number): Pose[] {
  const list = [...poses], [pose] = list.splice(from, 1);
  list.splice(to, 0, pose);
  return list;
}
/** A copy beside it: a step further, since equal positions are refused. */
export function duplicated(poses: readonly Pose[], index: number, step: number): Pose[] {
  const {x, y, theta_deg} = poses[index];
  return [...poses.slice(0, index + 1), {x: tidy(x + 10 * step), y: tidy(y + 10 * step), theta_deg}, ...poses.slice(index + 1)];
}
function tidy(value: number): number {
  return Number(value.toPrecision(12));
}

/** The next position: on from the last two, in whole steps. */
export function proposed(poses: readonly Pose[], step: number): Pose {
  const last = poses.at(-1), before = poses.at(-2);
  if (!last) return {x: 0, y: 0, theta_deg: 0};
  if (!before) return {x: tidy(last.x + 100 * step), y: last.y, theta_deg: last.theta_deg};
  const turn = last.theta_deg - before.theta_deg, wound = turn - 360 * Math.round(turn / 360);
  const on = (a: number, b: number) => tidy(Math.round((2 * a - b) / step) * step);
  return {x: on(last.x, before.x), y: on(last.y, before.y), theta_deg: Math.round(last.theta_deg + wound)};
}

/** One step of the arrow keys for lengths: a power of ten, about a hundredth of the poses' box or less. */
export function length_step(poses: readonly Pose[]): number {
  const size = (key: "x" | "y") => Math.max(...poses.map((p) => p[key])) - Math.min(...poses.map((p) => p[key]));
  const extent = poses.length > 1 ? Math.max(size("x"), size("y")) : 0;
  return extent > 0 ? 10 ** (Math.floor(Math.log10(extent)) - 2) : 1;
}
/** A value some steps on, without the dust of binary fractions. */
export function stepped(value: number, steps: number, step: number): number {
  const result = tidy(value + steps * step), decimals = Math.max(0, Math.min(12, 2 - Math.floor(Math.log10(step))));
  return Math.abs(result - Number(result.toFixed(decimals))) < 1e-9 * step ? Number(result.toFixed(decimals)) : result;
}

/** "PP-P-P": positions, those infinitely close together written without a stroke. */
export function pattern_of(poses: readonly Pose[]): string {
  return poses.map((pose) => "P".repeat(1 + (pose.derivatives?.length ?? 0))).join("-");
}

/** Everything as seen from pose `index`: it becomes (0, 0, 0°). What stands in the fixed frame follows; outline and
 *  traced points belong to the body and stay as they are. */
export function referred(document: Document, index: number): Document {
  const {problem} = document, {poses} = problem.task, origin = poses[index];
  const pose = (p: Pose) => referred_pose(p, origin);
  const point = (p: Point | null) => p && body_point(p, origin);
  const pins = document.pins.map((pin) => (same_poses(pin.poses, poses) ? referred_pin(pin, pose, point) : pin));
  const changed = with_poses(problem, poses.map((p, i) => (i === index ? {...pose(p), x: 0, y: 0, theta_deg: 0} : pose(p))));
  const {requirements, view} = changed;
  if (requirements?.ground_pivots_within) changed.requirements = {...changed.requirements, ground_pivots_within: referred_box(requirements.ground_pivots_within, origin)};
  if (requirements?.moving_pivots_within) changed.requirements = {...changed.requirements, moving_pivots_within: referred_box(requirements.moving_pivots_within, origin)};
  if (view?.background) {
    const {x, y, width, aspect} = view.background;
    const center = body_point([x + width / 2, y + (width * aspect) / 2], origin); // a picture cannot turn: it keeps its centre
    changed.view = {...view, background: {...view.background, x: center[0] - width / 2, y: center[1] - (width * aspect) / 2}};
  }
  return {...document, problem: changed, pins};
}
function referred_pose(pose: Pose, origin: Pose): Pose {
  const [x, y] = body_point([pose.x, pose.y], origin);
  const turned = {...pose, x: clean(x), y: clean(y), theta_deg: clean(pose.theta_deg - origin.theta_deg)};
  if (!pose.derivatives) return turned;
  const turn = {x: 0, y: 0, theta_deg: origin.theta_deg};
  return {...turned, derivatives: pose.derivatives.map((d) => {
    const [dx, dy] = body_point([d.x, d.y], turn);
    return {x: clean(dx), y: clean(dy), theta: d.theta};
  })};
}
function referred_pin(pin: Pin, pose: (p: Pose) => Pose, point: (p: Point | null) => Point | null): Pin {
  const {input_center, input_circle, output_center, output_circle} = pin.pivots;
  return {...pin, poses: pin.poses.map(pose), pivots: {
    input_center: point(input_center), input_circle: point(input_circle),
    output_center: point(output_center), output_circle: point(output_circle),
  }};
}
/** A turned box is no box: the smallest one around it. */
function referred_box(box: Box, origin: Pose): Box {
  const corners = box.x.flatMap((x) => box.y.map((y) => body_point([x, y], origin)));
  const xs = corners.map((c) => clean(c[0])), ys = corners.map((c) => clean(c[1]));
  return {x: [Math.min(...xs), Math.max(...xs)], y: [Math.min(...ys), Math.max(...ys)]};
}
function clean(value: number): number {
  const rounded = Number(value.toPrecision(13));
  return rounded === 0 ? 0 : rounded;
}
