// Words and numbers that stand on the drawing.
import {unmet_text} from "../requirements/requirements";
import type {Pose} from "../state/task";
import type {Workbench} from "../state/workbench.svelte";
import {told} from "../kinds/kind_dispatch";
import {t} from "../texts/texts.svelte";
import {bend_of, travel_of} from "../task_panel/travel";
import type {Handle, Target} from "./handles";
import {angle_note, length_note, point_note} from "./notes";
import type {Scene} from "./scene.svelte";

/** Why the linkage in hand does not do, or nothing. */
export function reason_of(workbench: Workbench): string | null {
  const {hand} = workbench;
  if (!hand) return null;
  return hand.reason ? told(workbench.problem.task, hand.reason) : unmet_text(hand, workbench);
}

export function target_label(target: Target, scene: Scene): string {
  const unit = scene.workbench.unit,
    pose = "pose" in target ? scene.poses[target.pose] : null;
  const n = "pose" in target ? target.pose + 1 : 0;
  switch (target.kind) {
    case "disc":
    case "body":
      return t("drawing.position", {n, place: pose ? point_note([pose.x, pose.y], scene.space.step, unit) : ""});
    case "knob":
      return t("drawing.turn", {n, angle: pose ? angle_note(pose.theta_deg) : ""});
    case "velocity":
      return t("drawing.travel", {n, angle: pose ? angle_note(travel_of(pose)?.direction_deg ?? 0) : ""});
    case "curvature":
      return t("drawing.bend", {n, radius: pose ? radius_note(pose, scene) : ""});
    case "pivot":
      return t(`drawing.pivot_${target.side}_${target.end}`);
    case "corner":
      return t("drawing.corner", {n: target.index + 1});
    case "midpoint":
      return t("drawing.midpoint", {n: target.index + 1});
    case "box":
      return t(
        target.edges.x === 0 && target.edges.y === 0 ? `drawing.box_${target.box}` : `drawing.box_corner_${target.box}`,
      );
    case "traced":
      return t("drawing.traced", {n: target.index + 1});
    case "task":
      return target.label();
    case "curve":
      return t(`curve.${target.spot.curve}`);
  }
}
export function handle_label(handle: Handle, scene: Scene): string {
  return target_label(handle.target, scene);
}
export function radius_note(pose: Pose, scene: Scene): string {
  const curvature = bend_of(pose)?.curvature ?? 0;
  return Math.abs(curvature) * scene.space.width < 1e-3 * scene.space.scale
    ? "∞"
    : length_note(1 / curvature, scene.space.step, scene.workbench.unit);
}
