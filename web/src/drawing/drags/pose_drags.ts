// Dragging a position: its place, its angle, its direction and curvature of travel.
import type {Point} from "../../contract/messages";
import type {Problem} from "../../state/problem";
import {poses_of, type Pose} from "../../state/task";
import {with_bend, with_travel} from "../../task_panel/travel";
import {curvature_reach, arm_length, travel_direction, type Target} from "../handles";
import {angle_note, point_note} from "../notes";
import {radius_note} from "../labels";
import {align_px, snapped_angle, wrapped_deg, type Keys} from "../snapping";
import type {Bench} from "../bench";
import {with_pose, with_poses} from "../../kinds/kind_dispatch";
import {Way, type Drag} from "./drag";

type PoseTarget = Extract<Target, {pose: number}>;

function begin(bench: Bench, target: PoseTarget, halo: "move" | "turn" | null): Pose {
  const {workbench, scene} = bench,
    pose = scene.poses[target.pose]!; // the handles are those of the poses there are
  workbench.begin_gesture();
  workbench.held_pose = target.pose;
  scene.held = target;
  if (halo) scene.show_halo(target.pose, pose, halo);
  return pose;
}
/** The same pose, however it was changed meanwhile. */
function changed(problem: Problem, index: number, change: (pose: Pose) => Pose): Problem {
  return with_poses(
    problem,
    poses_of(problem.task).map((pose, i) => (i === index ? change(pose) : pose)),
  );
}

export function move_drag(bench: Bench, target: PoseTarget, from: Point): Drag {
  const {workbench, scene} = bench,
    start = begin(bench, target, "move"),
    way = new Way(scene, from);
  return {
    cursor: "move",
    move(at, keys) {
      const others = scene.origins.filter((_, i) => i !== target.pose),
        origin: Point = [start.x, start.y];
      const {point, guides} = scene.space.snapped(origin, way.to(at, keys).from(origin), keys, others);
      scene.guides = guides;
      workbench.drag((problem) => with_pose(problem, target.pose, {x: point[0], y: point[1]}));
      scene.tell(at, point_note(point, scene.space.step, workbench.unit));
    },
    end: () => scene.finish(true),
    cancel: () => scene.finish(false),
  };
}

/** Follows the pointer's direction from the origin; the farther away, the finer. */
class Turning {
  private last: number;
  turned = 0;
  constructor(
    private readonly origin: Point,
    from: Point,
  ) {
    this.last = this.direction(from);
  }
  private direction(at: Point): number {
    return (Math.atan2(this.origin[1] - at[1], at[0] - this.origin[0]) * 180) / Math.PI;
  }
  to(at: Point, keys: Keys): number {
    const now = this.direction(at);
    this.turned += wrapped_deg(now - this.last) * (keys.fine ? 0.1 : 1);
    this.last = now;
    return this.turned;
  }
  length(at: Point): number {
    return Math.max(Math.hypot(at[0] - this.origin[0], at[1] - this.origin[1]), arm_length);
  }
}
function near_deg(length: number): number {
  return (align_px / length) * (180 / Math.PI);
}

export function turn_drag({workbench, scene}: Bench, target: PoseTarget, from: Point): Drag {
  const bench = {workbench, scene},
    start = begin(bench, target, "turn");
  const turning = new Turning(scene.space.project([start.x, start.y]), from);
  return {
    cursor: "grabbing",
    move(at, keys) {
      const others = scene.poses.filter((_, i) => i !== target.pose).map((p) => p.theta_deg),
        length = turning.length(at);
      const {angle} = snapped_angle(
        start.theta_deg + turning.to(at, keys),
        others,
        near_deg(length),
        scene.space.snaps,
        keys,
      );
      scene.arm = length;
      workbench.drag((problem) => with_pose(problem, target.pose, {theta_deg: angle}));
      scene.tell(at, `θ ${angle_note(angle)}`);
    },
    end: () => scene.finish(true),
    cancel: () => scene.finish(false),
  };
}

export function velocity_drag(bench: Bench, target: PoseTarget, from: Point): Drag {
  const {workbench, scene} = bench,
    start = begin(bench, target, null),
    along = travel_direction(start) ?? [1, 0];
  const turning = new Turning(scene.space.project([start.x, start.y]), from);
  const first = (Math.atan2(-along[1], along[0]) * 180) / Math.PI;
  return {
    cursor: "grabbing",
    move(at, keys) {
      const {angle} = snapped_angle(first + turning.to(at, keys), [], 0, scene.space.snaps, keys);
      workbench.drag((problem) => changed(problem, target.pose, (pose) => with_travel(pose, {direction_deg: angle})));
      scene.tell(at, angle_note(angle));
    },
    end: () => scene.finish(true),
    cancel: () => scene.finish(false),
  };
}

export function curvature_drag(bench: Bench, target: PoseTarget): Drag {
  const {workbench, scene} = bench;
  begin(bench, target, null);
  return {
    cursor: "grabbing",
    move(at) {
      const pose = scene.poses[target.pose],
        along = pose && travel_direction(pose);
      if (!along) return;
      const origin = scene.space.project([pose.x, pose.y]);
      const rise = (at[0] - origin[0]) * along[1] - (at[1] - origin[1]) * along[0];
      const raw = (2 * rise * scene.space.scale) / curvature_reach ** 2;
      const curvature = Math.abs(rise) < 4 ? 0 : Number(raw.toPrecision(3));
      workbench.drag((problem) => changed(problem, target.pose, (p) => with_bend(p, {curvature})));
      scene.tell(at, `r ${radius_note(scene.poses[target.pose] ?? pose, scene)}`);
    },
    end: () => scene.finish(true),
    cancel: () => scene.finish(false),
  };
}
