// A pivot of the picked linkage slides along its curve; the engine's answer puts it exactly there.
import type {Point} from "../../contract/messages";
import {coordinate_of, with_side} from "../../engine/axis";
import {body_point, placed} from "../../state/problem";
import type {Spot} from "../curve_samples";
import {spot_of_tau} from "../curve_samples";
import type {Target} from "../handles";
import {reason_of} from "../labels";
import {beyond_edge, beyond_spot, overshoot, slid, type Beyond} from "../sliding";
import {to_screen, to_user, type Viewport} from "../viewport";
import type {Bench} from "../bench";
import type {Drag} from "./drag";

/** `view` is what the pointer's pixels are of: the drawing's, or the 3-D view's. */
export function pivot_drag(
  bench: Bench,
  target: Extract<Target, {kind: "pivot"}>,
  view: () => Viewport = () => bench.scene.view,
): Drag | null {
  const {workbench, scene} = bench,
    {picked, task} = workbench;
  const samples = scene.samples[target.side];
  if (!picked || !samples || !task) return null;
  let spot: Spot | null = spot_of_tau(samples, target.end, coordinate_of(task, picked.tau, target.side));
  if (!spot) return null;
  let beyond: Beyond | null = null;
  // A pivot that moves is taken where it is now; its curve lies in position 1.
  const carrier = target.home ? null : scene.carrier(target.side, target.end);
  const on_curve = (at: Point): Point =>
    carrier ? to_screen(view(), placed(body_point(to_user(view(), at), carrier.now), carrier.first)) : at;
  workbench.begin_gesture();
  scene.held = target;
  return {
    cursor: "grabbing",
    move(at) {
      const samples = scene.samples[target.side];
      if (!samples || !spot) return;
      const over = overshoot(view(), at);
      if (over === 0) beyond = null;
      else beyond ??= beyond_edge(samples, target.end, view(), on_curve(at), spot);
      spot = beyond
        ? beyond_spot(samples, target.end, beyond, over)
        : slid(samples, target.end, view(), on_curve(at), spot);
      workbench.curve_hover = {sides: spot.sides, tau: spot.tau};
      workbench.slide(with_side(workbench.task ?? task, workbench.picked?.tau ?? picked.tau, target.side, spot.tau));
      scene.tell(at, `τ ${spot.tau.toFixed(4)}`, reason_of(workbench));
    },
    end() {
      workbench.curve_hover = null;
      scene.finish(true);
    },
    cancel() {
      workbench.curve_hover = null;
      scene.finish(false);
    },
  };
}
