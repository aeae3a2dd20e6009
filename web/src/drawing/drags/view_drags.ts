// Dragging what is not part of the task: the paper itself, and the picture behind it.
import type {Point} from "../../engine/protocol";
import {with_view} from "../../state/problem";
import {panned} from "../viewport";
import type {Bench} from "../bench";
import {Way, type Drag} from "./drag";

export function pan_drag({scene}: Bench, from: Point): Drag {
  const start = scene.view;
  return {
    cursor: "grabbing",
    move(at) {
      scene.touched = true;
      scene.view = panned({...scene.view, x: start.x, y: start.y}, at[0] - from[0], at[1] - from[1]);
    },
    end: () => {},
    cancel: () => (scene.view = {...scene.view, x: start.x, y: start.y}),
  };
}
export function picture_drag({workbench, scene}: Bench, from: Point): Drag | null {
  const background = workbench.problem.view?.background,
    way = new Way(scene, from);
  if (!background) return null;
  workbench.begin_gesture();
  return {
    cursor: "move",
    move(at, keys) {
      const {x, y} = way.to(at, keys);
      scene.marks = [];
      workbench.drag((problem) =>
        with_view(problem, {background: {...background, x: background.x + x, y: background.y + y}}),
      );
    },
    end: () => scene.finish(true),
    cancel: () => scene.finish(false),
  };
}
