// What the table does to the list of poses.
import {with_moved_blocks} from "../analyses/analysis_dispatch";
import {in_plane} from "../figure/mechanism";
import type {Box, Point} from "../contract/messages";
import type {FitStart} from "../contract/problem";
import {body_point, with_task, type Pin} from "../state/problem";
import type {TaskDocument} from "../state/document";
import {poses_of, same_task, type Pose, type Task} from "../state/task";
import {kind_of, with_task_poses} from "../kinds/kind_dispatch";
import {least_of, most_of} from "../state/ends";

export function moved(poses: readonly Pose[], from: number, to: number): Pose[] {
  const list = [...poses],
    pose = list.splice(from, 1);
  list.splice(to, 0, ...pose);
  return list;
}
export const pose_keys = ["x", "y", "theta_deg"] as const;
/** With a block of numbers from this row and column on; rows that are new begin as the last one. */
export function filled_in(old: readonly Pose[], first: number, column: number, rows: readonly number[][]): Pose[] {
  const list = [...old];
  rows.forEach((numbers, r) => {
    const {derivatives: _, ...last} = list.at(-1) ?? {x: 0, y: 0, theta_deg: 0};
    const change = Object.fromEntries(numbers.map((value, c) => [pose_keys[column + c], value]));
    list[first + r] = {...(list[first + r] ?? last), ...change};
  });
  return list;
}
/** A copy beside it: a step further, since equal positions are refused. */
export function duplicated(poses: readonly Pose[], index: number, step: number): Pose[] {
  const pose = poses[index];
  if (!pose) return [...poses];
  const {x, y, theta_deg} = pose;
  return [
    ...poses.slice(0, index + 1),
    {x: tidy(x + 10 * step), y: tidy(y + 10 * step), theta_deg},
    ...poses.slice(index + 1),
  ];
}
function tidy(value: number): number {
  return Number(value.toPrecision(12));
}

/** The next position: on from the last two, in whole steps. */
export function proposed(poses: readonly Pose[], step: number): Pose {
  const last = poses.at(-1),
    before = poses.at(-2);
  if (!last) return {x: 0, y: 0, theta_deg: 0};
  if (!before) return {x: tidy(last.x + 100 * step), y: last.y, theta_deg: last.theta_deg};
  const turn = last.theta_deg - before.theta_deg,
    wound = turn - 360 * Math.round(turn / 360);
  const on = (a: number, b: number) => tidy(Math.round((2 * a - b) / step) * step);
  return {x: on(last.x, before.x), y: on(last.y, before.y), theta_deg: Math.round(last.theta_deg + wound)};
}

/** One step of the arrow keys for lengths: a power of ten, about a hundredth of the points' box or less. */
export function length_step(points: readonly Point[]): number {
  const size = (k: 0 | 1) => most_of(points.map((p) => p[k])) - least_of(points.map((p) => p[k]));
  const extent = points.length > 1 ? Math.max(size(0), size(1)) : 0;
  return extent > 0 ? 10 ** (Math.floor(Math.log10(extent)) - 2) : 1;
}
/** A value some steps on, without the dust of binary fractions. */
export function stepped(value: number, steps: number, step: number): number {
  const result = tidy(value + steps * step),
    decimals = Math.max(0, Math.min(12, 2 - Math.floor(Math.log10(step))));
  return Math.abs(result - Number(result.toFixed(decimals))) < 1e-9 * step ? Number(result.toFixed(decimals)) : result;
}

/** Everything as seen from pose `index`: it becomes (0, 0, 0°). What stands in the fixed frame follows; outline and
 *  traced points belong to the body and stay as they are. */
export function referred(document: TaskDocument, index: number): TaskDocument {
  const {problem} = document,
    origin = poses_of(problem.task)[index];
  if (!origin) return document;
  const pose = (p: Pose) => referred_pose(p, origin);
  const point = (p: Point) => body_point(p, origin);
  const task = referred_task(problem.task, pose, point, index);
  const pins = document.pins.map((pin) => (same_task(pin.task, problem.task) ? referred_pin(pin, task, point) : pin));
  const changed = with_moved_blocks(with_task(problem, task), point);
  const {requirements, view} = changed;
  if (requirements?.ground_pivots_within)
    changed.requirements = {
      ...changed.requirements,
      ground_pivots_within: referred_box(requirements.ground_pivots_within, origin),
    };
  if (requirements?.moving_pivots_within)
    changed.requirements = {
      ...changed.requirements,
      moving_pivots_within: referred_box(requirements.moving_pivots_within, origin),
    };
  const {fit} = changed.options ?? {};
  if (fit?.starts)
    changed.options = {...changed.options, fit: {...fit, starts: fit.starts.map((of) => moved_start(of, point, pose))}};
  if (view?.background) {
    const {angle_deg = 0} = view.background,
      [x, y] = body_point([view.background.x, view.background.y], origin);
    const turned = angle_deg - origin.theta_deg,
      within_a_turn = clean(turned - 360 * Math.round(turned / 360));
    changed.view = {...view, background: {...view.background, x, y, angle_deg: within_a_turn}};
  }
  return {...document, problem: changed, pins};
}
function moved_start(
  {input, output, point, pose}: FitStart,
  move: (p: Point) => Point,
  turned: (p: Pose) => Pose,
): FitStart {
  const link = ({center_point, circle_point}: FitStart["input"]) => ({
    center_point: move(center_point),
    circle_point: move(circle_point),
  });
  return {
    input: link(input),
    output: link(output),
    ...(point ? {point: move(point)} : {}),
    ...(pose ? {pose: turned(pose)} : {}),
  };
}
function referred_task(task: Task, pose: (p: Pose) => Pose, point: (p: Point) => Point, index: number): Task {
  const poses = poses_of(task).map((p, i) => (i === index ? {...pose(p), x: 0, y: 0, theta_deg: 0} : pose(p)));
  return with_task_poses(
    kind_of(task).moved(task, ([x, y]) => point([x, y]).map(clean) as unknown as Point),
    poses,
  );
}
function referred_pose(pose: Pose, origin: Pose): Pose {
  const [x, y] = body_point([pose.x, pose.y], origin);
  const turned = {...pose, x: clean(x), y: clean(y), theta_deg: clean(pose.theta_deg - origin.theta_deg)};
  if (!pose.derivatives) return turned;
  const turn = {x: 0, y: 0, theta_deg: origin.theta_deg};
  return {
    ...turned,
    derivatives: pose.derivatives.map((d) => {
      const [dx, dy] = body_point([d.x, d.y], turn);
      return {x: clean(dx), y: clean(dy), theta: d.theta};
    }),
  };
}
function referred_pin(pin: Pin, task: Task, point: (p: Point) => Point): Pin {
  const pivots = Object.entries(pin.pivots).map(([name, pivot]) => {
    const at = in_plane(pivot);
    return [name, at ? point(at) : pivot];
  });
  return {...pin, task, pivots: Object.fromEntries(pivots)};
}
/** A turned box is no box: the smallest one around it. */
function referred_box(box: Box, origin: Pose): Box {
  const corners = box.x.flatMap((x) => box.y.map((y) => body_point([x, y], origin)));
  const xs = corners.map((c) => clean(c[0])),
    ys = corners.map((c) => clean(c[1]));
  return {x: [least_of(xs), most_of(xs)], y: [least_of(ys), most_of(ys)]};
}
function clean(value: number): number {
  const rounded = Number(value.toPrecision(13));
  return rounded === 0 ? 0 : rounded;
}
