// What a click or a key does to the thing under it.
import type {Point} from "../contract/messages";
import {coordinate_of, with_side} from "../engine/axis";
import {body_point, outline_of, placed, round_step, with_view} from "../state/problem";
import {poses_of, type Pose} from "../state/task";
import {bend_of, travel_of, with_bend, with_travel} from "../task_panel/travel";
import {point_at, spot_of_tau, type Spot} from "./curve_samples";
import {nudged_box, with_box} from "./drags/box_drags";
import type {Bench} from "./bench";
import {add_corner, corner_at, remove_corner, with_outline, without_corner} from "./drags/outline_drags";
import {inside, target_id, type Target} from "./handles";
import {multiple, wrapped_deg} from "./snapping";
import {stepped} from "./sliding";
import {with_poses} from "../kinds/kind_dispatch";

export function focus_handle(svg: SVGSVGElement, target: Target): void {
  svg.querySelector<SVGElement>(`[data-testid="drawing.${target_id(target)}"]`)?.focus({preventScroll: true});
}

/** A click on a target. */
export function click_target(bench: Bench, target: Target, shift: boolean): void {
  const {workbench, scene} = bench;
  if ("pose" in target) workbench.selected_pose = target.pose;
  else if (target.kind === "curve") put_grounded_link(bench, target.spot, shift);
  else if (target.kind === "midpoint") add_corner(bench, target.index);
  else if (target.kind === "corner") scene.corner = target.index;
}

/** The nearer grounded link of the picked linkage goes to the place; with Shift the other one. */
export function put_grounded_link({workbench, scene}: Bench, spot: Spot, other: boolean): void {
  const picked = workbench.picked,
    linkage = workbench.picked_linkage,
    samples = scene.samples[spot.sides[0]];
  const place = samples && point_at(samples, spot.curve, spot);
  if (!picked || !place || !workbench.task) return;
  const away = (point: Point | null | undefined) =>
    point ? Math.hypot(point[0] - place[0], point[1] - place[1]) : Infinity;
  const input_nearer = away(linkage?.input[spot.curve]) <= away(linkage?.output[spot.curve]);
  const side = spot.sides.length > 1 ? (input_nearer !== other ? "input" : "output") : spot.sides[0];
  workbench.pick(with_side(workbench.task, picked.tau, side, spot.tau));
}

/** Whether a click on the canvas adds a position: the task lacks some. */
export function poses_are_wanted({incomplete, problem}: Bench["workbench"]): boolean {
  return (
    "poses" in problem.task &&
    (incomplete?.state === "empty" || incomplete?.state === "too_few" || incomplete?.state === "no_given")
  );
}
/** A click on the canvas of such a task. */
export function add_position({workbench, scene}: Bench, at: Point): void {
  const [x, y] = clicked_place(scene, at),
    last = scene.poses.at(-1);
  scene.touched = true;
  workbench.edit((problem) =>
    with_poses(problem, [...poses_of(problem.task), {x, y, theta_deg: last?.theta_deg ?? 0}]),
  );
  workbench.selected_pose = scene.poses.length - 1;
}

/** What else a task can be given by a click on the canvas; false: it lacks nothing of that. */
export function add_clicked({workbench, scene}: Bench, at: Point): boolean {
  const changed = scene.with_clicked(clicked_place(scene, at));
  if (!changed) return false;
  scene.touched = true;
  workbench.edit(() => changed);
  return true;
}
function clicked_place(scene: Bench["scene"], at: Point): Point {
  const [x, y] = scene.space.unproject(at),
    step = scene.snap_step ?? 10 ** Math.floor(Math.log10(scene.space.step / 8));
  return [multiple(x, step), multiple(y, step)];
}

/** Traces the body point under the pointer, or ends tracing the one that is there. */
export function toggle_traced({workbench, scene}: Bench, at: Point): void {
  const pose = body_under(scene, at),
    traced = workbench.problem.view?.traced ?? [];
  if (!pose) return;
  const near = traced.findIndex((p) => {
    const [x, y] = scene.space.project(placed(p, pose));
    return Math.hypot(x - at[0], y - at[1]) < 10;
  });
  const fine = 10 ** Math.floor(Math.log10(scene.space.step / 8)),
    [x, y] = body_point(scene.space.unproject(at), pose);
  const point: Point = [multiple(x, fine), multiple(y, fine)];
  workbench.edit((problem) =>
    with_view(problem, {traced: near >= 0 ? traced.filter((_, i) => i !== near) : [...traced, point]}),
  );
}
function body_under(scene: Bench["scene"], at: Point): Pick<Pose, "x" | "y" | "theta_deg"> | null {
  const covers = (pose: Pick<Pose, "x" | "y" | "theta_deg">) =>
    inside(
      scene.outline.map((p) => scene.space.project(placed(p, pose))),
      at,
    );
  const now = scene.now?.pose ?? null;
  if (now && covers(now)) return now;
  return scene.poses.find(covers) ?? now ?? scene.poses[0] ?? null;
}

// ---- outline by clicks ----------------------------------------------------------------------------------------

export function add_draft_corner(bench: Bench, at: Point): void {
  const {scene} = bench,
    draft = scene.draft ?? [],
    first = draft[0];
  if (first && draft.length >= 3) {
    const [x, y] = scene.space.project(placed(first, scene.outline_pose!));
    if (Math.hypot(x - at[0], y - at[1]) <= 12) return close_draft(bench);
  }
  const corner = corner_at(bench, at),
    last = draft.at(-1);
  if (last?.[0] === corner[0] && last[1] === corner[1]) return close_draft(bench); // a double click
  scene.draft = [...draft, corner];
}
export function close_draft({workbench, scene}: Bench): void {
  const {draft} = scene;
  if (draft && draft.length >= 3) workbench.edit((problem) => with_outline(problem, draft));
  if (draft && (draft.length >= 3 || draft.length === 0)) scene.draft = null;
}

// ---- keys -----------------------------------------------------------------------------------------------------

/** Arrow keys on a handle: one step, with Shift ten, with Alt a tenth. */
export function nudge(bench: Bench, target: Target, dx: number, dy: number, times: number): void {
  const {workbench, scene} = bench,
    step = scene.space.step * times,
    merge = `nudge ${target_id(target)}`;
  const add = (value: number, by: number) => Number((value + by).toPrecision(12)) + 0;
  const change_pose = (index: number, change: (pose: Pose) => Pose) =>
    workbench.edit(
      (problem) =>
        with_poses(
          problem,
          poses_of(problem.task).map((p, i) => (i === index ? change(p) : p)),
        ),
      merge,
    );
  scene.touched = true;
  if ("pose" in target) workbench.selected_pose = target.pose;
  const turn = (dy || -dx) * times;
  switch (target.kind) {
    case "disc":
    case "body":
      return change_pose(target.pose, (p) => ({...p, x: add(p.x, dx * step), y: add(p.y, dy * step)}));
    case "knob":
      return change_pose(target.pose, (p) => ({...p, theta_deg: wrapped_deg(add(p.theta_deg, turn))}));
    case "velocity":
      return change_pose(target.pose, (p) =>
        with_travel(p, {direction_deg: wrapped_deg(add(travel_of(p)?.direction_deg ?? 0, turn))}),
      );
    case "curvature":
      return change_pose(target.pose, (p) =>
        with_bend(p, {curvature: add(bend_of(p)?.curvature ?? 0, turn * bend_step(scene.space.scale))}),
      );
    case "corner": {
      const moved = ([x, y]: Point): Point => [add(x, dx * step), add(y, dy * step)],
        outline = scene.outline.map((p, i) => (i === target.index ? moved(p) : p));
      return workbench.edit((problem) => with_outline(problem, outline), merge);
    }
    case "box":
      return nudge_box(bench, target, dx * step, dy * step, merge);
    case "task":
      return target.nudge(dx, dy, step);
    case "pivot":
      return nudge_pivot(bench, target, (dx || dy) * times, merge);
  }
}
function bend_step(scale: number): number {
  return round_step(scale / 2000);
}
function nudge_box(
  {workbench, scene}: Bench,
  {box, edges}: Extract<Target, {kind: "box"}>,
  dx: number,
  dy: number,
  merge: string,
): void {
  const before = scene.boxes[box];
  if (!before) return;
  const moved = nudged_box(before, edges, dx, dy);
  if (moved) workbench.edit((problem) => with_box(problem, box, moved), merge);
}
function nudge_pivot(
  {workbench, scene}: Bench,
  {side, end}: Extract<Target, {kind: "pivot"}>,
  steps: number,
  merge: string,
): void {
  const {picked, task} = workbench,
    samples = scene.samples[side];
  const spot = picked && task && samples && spot_of_tau(samples, end, coordinate_of(task, picked.tau, side));
  if (!picked || !task || !samples || !spot) return;
  workbench.pick(
    with_side(
      task,
      picked.tau,
      side,
      stepped(samples, end, scene.view, spot, steps * scene.space.step * scene.space.scale).tau,
    ),
    merge,
  );
}

/** Del on a handle. */
export function remove_target({workbench, scene}: Bench, target: Target): boolean {
  const bench = {workbench, scene};
  switch (target.kind) {
    case "corner":
      if (without_corner(outline_of(workbench.problem), target.index) === outline_of(workbench.problem)) return false;
      remove_corner(bench, target.index);
      return true;
    case "box":
      workbench.edit((problem) => with_box(problem, target.box, undefined));
      return true;
    case "disc":
      workbench.edit((problem) =>
        with_poses(
          problem,
          poses_of(problem.task).filter((_, i) => i !== target.pose),
        ),
      );
      workbench.selected_pose = null;
      return true;
    default:
      return false;
  }
}
