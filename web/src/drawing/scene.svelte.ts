// The drawing's own state: what part it shows, what the pointer is over, what is being drawn. Not part of the task.
import {getContext, setContext, untrack} from "svelte";
import type {Box, Linkage, Point, Side} from "../engine/protocol";
import {joints_at, state_at} from "../state/drive";
import {preferences} from "../state/preferences.svelte";
import {body_point, outline_of, placed} from "../state/problem";
import {screen_size} from "../state/screen.svelte";
import {poses_of, served_poses, type Pose} from "../state/task";
import type {Workbench} from "../state/workbench.svelte";
import {carrier_of, joint_of, type Carrier} from "./carrier";
import {curves_of, nearest, point_at, samples_of_sides, type CurveSamples, type Spot} from "./curve_samples";
import {
  border_hit,
  box_handles,
  box_names,
  corner_handles,
  edge_cursor,
  inside,
  pivot_handles,
  pose_handles,
  ranks,
  target_id,
  within_reach,
  type BoxName,
  type End,
  type Ends,
  type Handle,
  type Target,
} from "./handles";
import {anchors_of, kind_of} from "../tasks/kinds";
import {task_view} from "../tasks/views";
import {task_points} from "./fit";
import {grid_step, to_screen, type Viewport} from "./viewport";
import type {Guide} from "./snapping";

export interface Note {
  at: Point;
  text: string;
  /** Why it does not work here. */
  reason?: string | null;
}
/** The linkage as it stands: at the drive's angle, or, without a drive, at the nearest position. */
export interface Now {
  pose: {x: number; y: number; theta_deg: number};
  ends: Ends;
  /** All hinges of a six-bar. */
  joints: readonly Point[];
}
const curve_reach = [8, 20] as const;

export class Scene {
  view = $state.raw<Viewport>({x: 0, y: 0, scale: 1, width: 0, height: 0});
  /** The user has zoomed, panned or edited: the view is his. */
  touched = $state(false);
  hovered = $state.raw<Target | null>(null);
  /** What is being dragged. */
  held = $state.raw<Target | null>(null);
  note = $state.raw<Note | null>(null);
  guides = $state.raw<readonly Guide[]>([]);
  spot = $state.raw<Spot | null>(null);
  /** A held pose as it was pressed: the halo lies about it. */
  pressed_pose = $state.raw<Pose | null>(null);
  /** Where a part of the task stood when it was pressed, if it stays there while it is dragged. */
  anchor = $state.raw<Point | null>(null);
  /** Pixels from the origin to the pointer that turns a pose. */
  arm = $state<number | null>(null);
  rubber = $state.raw<{box: BoxName; shape: Box} | null>(null);
  /** Corners clicked so far, body coordinates; null: the outline there is is being edited. */
  draft = $state.raw<readonly Point[] | null>(null);
  corner = $state<number | null>(null);
  pointer = $state.raw<Point | null>(null);
  /** Two points of the background picture whose distance is known. */
  marks = $state.raw<readonly Point[]>([]);
  focused = $state<string | null>(null);

  constructor(readonly workbench: Workbench) {}

  // ---- what there is ------------------------------------------------------------------------------------------

  readonly poses = $derived.by(() => poses_of(this.workbench.problem.task));
  /** Those that a linkage passes exactly. */
  readonly served = $derived.by(() => served_poses(this.workbench.problem.task));
  readonly outline = $derived.by(() => outline_of(this.workbench.problem));
  /** Without an outline of its own, the body is sized from the poses, so it takes two. */
  readonly has_body = $derived.by(
    () =>
      this.poses.length > 1 || (this.poses.length === 1 && (this.workbench.problem.view?.outline?.length ?? 0) >= 3),
  );
  readonly boxes = $derived.by((): Record<BoxName, Box | null> => {
    const {problem, search_box} = this.workbench,
      {requirements} = problem;
    return {
      ground: requirements?.ground_pivots_within ?? null,
      moving: requirements?.moving_pivots_within ?? null,
      search: search_box,
    };
  });

  readonly samples = $derived.by(() => {
    const task = this.workbench.task;
    if (!task) return {input: null, output: null};
    const points = untrack(() => anchors_of(this.workbench.problem.task)),
      count = points.length || 1;
    return samples_of_sides(task, [
      points.reduce((sum, p) => sum + p[0], 0) / count,
      points.reduce((sum, p) => sum + p[1], 0) / count,
    ]);
  });
  /** One for both sides where they are the same. */
  readonly distinct_samples = $derived.by((): CurveSamples[] => {
    const {input, output} = this.samples;
    return [input, output === input ? null : output].filter((samples) => samples !== null);
  });

  readonly now = $derived.by((): Now | null => {
    const {hand} = this.workbench;
    if (!hand) return null;
    if (hand.drive) {
      const s = state_at(hand.drive, this.workbench.angle),
        joints = joints_at(hand.drive, this.workbench.angle);
      return {pose: s, joints, ends: hand.six_bar ? added_ends(joints) : ends_of(hand, [s.ax, s.ay], [s.bx, s.by])};
    }
    if (hand.six_bar || this.poses.length === 0) {
      const pose = this.poses[0] ?? {x: 0, y: 0, theta_deg: 0};
      return {
        pose,
        joints: hand.six_bar?.joints.map(({at}) => at) ?? [],
        ends: ends_of(hand, hand.input.circle, hand.output.circle),
      };
    }
    const pose = this.nearest_pose;
    const carried = (point: Point | null) => point && placed(body_point(point, this.served[0]), pose);
    return {pose, joints: [], ends: ends_of(hand, carried(hand.input.circle), carried(hand.output.circle))};
  });
  /** What carries an end of a side link; nothing on the ground. */
  carrier(side: Side, end: End): Carrier | null {
    const {hand} = this.workbench;
    return hand && this.now && carrier_of(hand, side, end, this.now, this.served[0]);
  }
  /** The position nearest to where the drive stands. */
  get nearest_pose(): Pose {
    return this.served[Math.min(Math.max(Math.round(this.workbench.stage), 0), this.served.length - 1)];
  }
  /** There are curves of ground pivots, not of moving ones only. */
  readonly has_center_curves = $derived.by(() =>
    this.distinct_samples.some((samples) => curves_of(samples).includes("center")),
  );
  /** The pose on which the outline is edited. */
  readonly outline_pose = $derived.by(() => this.poses[this.workbench.selected_pose ?? 0] ?? this.poses[0] ?? null);

  readonly box_handles = $derived.by(() => [
    ...box_names.flatMap((name) => (this.boxes[name] ? box_handles(name, this.boxes[name], this.view) : [])),
  ]);
  readonly pose_handles = $derived.by(() =>
    pose_handles(this.workbench.problem, this.view, this.workbench.selected_pose, screen_size.kind === "phone"),
  );
  readonly task_handles = $derived.by(() => task_view(this.workbench.problem.task).handles?.(this) ?? []);
  readonly pivot_handles = $derived.by(() =>
    this.workbench.hand && this.now ? pivot_handles(this.workbench.hand, this.now.ends, this.view) : [],
  );
  readonly corner_handles = $derived.by(() => {
    const editing = this.workbench.mode === "outline" && this.draft === null && this.outline_pose;
    return editing ? corner_handles(this.outline, this.outline_pose, this.view) : [];
  });
  /** Without those that a handle of the task stands for. */
  private readonly own_pivot_handles = $derived.by(() =>
    this.pivot_handles.filter(({id}) => !this.task_handles.some((handle) => handle.id === id)),
  );
  /** In reading order. */
  readonly handles = $derived.by((): Handle[] => [
    ...this.corner_handles,
    ...this.pose_handles,
    ...this.task_handles,
    ...this.own_pivot_handles,
    ...this.box_handles,
  ]);

  readonly step = $derived(grid_step(this.view));
  /** What the status line says of snapping: step in the user's unit, or nothing while it is off. */
  get snap_step(): number | null {
    return preferences.snap ? this.step : null;
  }

  task_points(): Point[] {
    const {task} = this.workbench.problem;
    return task_points(
      [...anchors_of(task), ...(kind_of(task).around?.(task) ?? [])],
      this.poses,
      this.outline,
      this.has_body,
    );
  }

  // ---- what is under the pointer ------------------------------------------------------------------------------

  /** All targets at a point of the screen, the first to be taken first. */
  targets_at(at: Point, touch: boolean): {target: Target; cursor: string}[] {
    const boxes = this.boxes_at(at, touch),
      near = within_reach(
        [...this.handles.filter((h) => h.target.kind !== "box" || h.cursor !== "move"), ...boxes],
        at,
        touch,
      );
    return [...near.filter(unique), ...this.curves_at(at, touch), ...this.bodies_at(at)];
  }
  private boxes_at(at: Point, touch: boolean): Handle[] {
    const found: Handle[] = [];
    for (const name of box_names) {
      const box = this.boxes[name],
        hit = box && border_hit(box, this.view, at, touch ? 20 : 8);
      if (!hit) continue;
      const target: Target = {kind: "box", box: name, edges: hit.edges};
      found.push({
        id: target_id(target),
        target,
        at,
        rank: ranks.box + hit.distance / 1000,
        reach: [8, 20],
        cursor: edge_cursor(hit.edges),
        tab: false,
      });
    }
    return found;
  }
  private bodies_at(at: Point): {target: Target; cursor: string}[] {
    if (!this.has_body) return [];
    const found = this.poses.flatMap((pose, i) =>
      inside(
        this.outline.map((p) => to_screen(this.view, placed(p, pose))),
        at,
      )
        ? [{target: {kind: "body", pose: i} as Target, cursor: "move"}]
        : [],
    );
    const first = found.findIndex(({target}) => target.kind === "body" && target.pose === this.workbench.selected_pose);
    return first > 0 ? [...found.splice(first, 1), ...found] : found;
  }
  private curves_at(at: Point, touch: boolean): {target: Target; cursor: string}[] {
    return this.distinct_samples
      .flatMap((samples) => curves_of(samples).flatMap((curve) => nearest(samples, curve, this.view, at) ?? []))
      .filter((spot) => spot.distance <= curve_reach[touch ? 1 : 0])
      .sort((a, b) => a.distance - b.distance)
      .map((spot) => ({target: {kind: "curve", spot} as Target, cursor: "pointer"}));
  }

  /** Both ends of the side link at a spot, as in position 1. */
  dyad_at(spot: Spot): {center: Point | null; circle: Point | null} | null {
    const samples = this.samples[spot.sides[0]];
    return samples && {center: point_at(samples, "center", spot), circle: point_at(samples, "circle", spot)};
  }
}

function ends_of({input, output}: Linkage, a: Point | null, b: Point | null): Ends {
  return {input: {center: input.center, circle: a}, output: {center: output.center, circle: b}};
}
function added_ends(joints: readonly Point[]): Ends {
  const link = (side: Side) => ({center: joints[joint_of(side, "center")], circle: joints[joint_of(side, "circle")]});
  return {input: link("input"), output: link("output")};
}
function unique(handle: Handle, index: number, all: readonly Handle[]): boolean {
  return all.findIndex((h) => h.id === handle.id) === index;
}

const key = Symbol("scene");
export function provide_scene(scene: Scene): Scene {
  return setContext(key, scene);
}
export function use_scene(): Scene {
  return getContext<Scene>(key);
}
