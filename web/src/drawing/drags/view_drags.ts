// Dragging the paper itself.
import type {Point} from "../../contract/messages";
import {panned} from "../viewport";
import type {Bench} from "../bench";
import type {Drag} from "./drag";

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
