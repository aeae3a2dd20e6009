// The picture behind the drawing: it is dragged as a whole, and turned by its knob.
import type {Point} from "../../contract/messages";
import {placed, with_view, type Background} from "../../state/problem";
import {t} from "../../texts/texts.svelte";
import {center_of, turned} from "../background";
import type {Bench} from "../bench";
import {task_handle, type Handle} from "../handles";
import {wrapped_deg} from "../snapping";
import {Way, type Drag} from "./drag";

const knob_reach = 34; // pixels above the picture's upper edge
export const turning_part = "picture_turn";

function movable({workbench}: Bench): Background | null {
  const background = workbench.problem.view?.background;
  return background && !background.hidden && !background.locked ? background : null;
}
export function picture_drag(bench: Bench, from: Point): Drag | null {
  const {workbench, scene} = bench,
    background = movable(bench),
    way = new Way(scene, from);
  if (!background) return null;
  workbench.begin_gesture();
  return {
    cursor: "move",
    move(at, keys) {
      const [x, y] = way.to(at, keys).from([background.x, background.y]);
      scene.marks = [];
      workbench.drag((problem) => with_view(problem, {background: {...background, x, y}}));
    },
    end: () => scene.finish(true),
    cancel: () => scene.finish(false),
  };
}

/** The knob above the middle of the picture's upper edge; none while it is locked or hidden. */
export function picture_handles(bench: Bench): Handle[] {
  const background = movable(bench);
  if (!background) return [];
  const {width, aspect, angle_deg = 0, x, y} = background,
    {space} = bench.scene;
  const knob = placed([width / 2, width * aspect + knob_reach / space.scale], {x, y, theta_deg: angle_deg});
  const handle = task_handle(
    {
      part: turning_part,
      label: () => `${t("picture.angle")}, ${angle_text(angle_deg)}`,
      drag: (from) => turn_drag(bench, background, from),
      nudge: (dx, dy) => turn(bench, background, angle_deg + dy - dx),
    },
    space.project(knob),
  );
  return [handle];
}
const angle_text = (angle: number) => `${Number(angle.toFixed(1))}°`;

function turn({workbench, scene}: Bench, background: Background, angle: number): void {
  scene.marks = [];
  const change = turned(background, Number(wrapped_deg(angle).toPrecision(9)));
  workbench.edit((problem) => with_view(problem, {background: change}), "picture turn");
}
function turn_drag({workbench, scene}: Bench, start: Background, from: Point): Drag {
  const middle = scene.space.project(center_of(start)),
    direction = ([x, y]: Point) => (Math.atan2(middle[1] - y, x - middle[0]) * 180) / Math.PI;
  const {angle_deg = 0} = start,
    first = direction(from);
  workbench.begin_gesture();
  return {
    cursor: "grabbing",
    move(at, keys) {
      const step = keys.shift ? 15 : keys.fine ? 0.1 : 0.5,
        angle = wrapped_deg(Math.round((angle_deg + direction(at) - first) / step) * step);
      scene.marks = [];
      workbench.drag((problem) => with_view(problem, {background: turned(start, Number(angle.toFixed(1)))}));
      scene.tell(at, angle_text(angle));
    },
    end: () => scene.finish(true),
    cancel: () => scene.finish(false),
  };
}
