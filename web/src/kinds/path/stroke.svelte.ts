// The curve that a mouse or a finger draws: the points of the task follow it while it is drawn.
import type {Point} from "../../contract/messages";
import type {Drag} from "../../drawing/drags/drag";
import {multiple} from "../../drawing/snapping";
import type {Desk, Surface} from "../../drawing/surface";
import {with_problem, type TaskDocument} from "../../state/document";
import {drawn, length_of} from "./curve";
import {with_near_points} from "./points";

const least_step_px = 2, // between places of the pointer that are kept
  least_length_px = 24, // of a stroke that is a curve
  first_answer_px = 80; // until it is so long nothing is asked
/** The first of the four-bars that trace the nearest path. */
const nearest = {tau: [0.5, 0.5], place: null} as const;

/** What has been drawn so far, user's frame. */
export class Stroke {
  trail = $state.raw<readonly Point[]>([]);
}
export function stroke_of(desk: Desk): Stroke {
  return desk.study("path.stroke", () => new Stroke());
}

export function stroke_drag(surface: Surface, from: Point): Drag {
  const {workbench, space} = surface,
    stroke = stroke_of(workbench),
    on_screen: Point[] = [from],
    pixel = 10 ** Math.floor(Math.log10(1 / space.scale / 4));
  const tidy = ([x, y]: Point): Point => [multiple(x, pixel), multiple(y, pixel)],
    with_drawn = (document: TaskDocument): TaskDocument => {
      const {points, closed} = drawn(stroke.trail);
      return {...with_problem(document, with_near_points(document.problem, points.map(tidy), closed)), picked: nearest};
    };
  stroke.trail = [space.unproject(from)];
  workbench.begin_gesture();
  function ended(keep: boolean): void {
    stroke.trail = [];
    surface.finish(keep);
  }
  return {
    cursor: "crosshair",
    move(at) {
      const last = on_screen.at(-1)!;
      if (Math.hypot(at[0] - last[0], at[1] - last[1]) < least_step_px) return;
      on_screen.push(at);
      stroke.trail = [...stroke.trail, space.unproject(at)];
      if (length_of(on_screen) >= first_answer_px) workbench.drag_document(with_drawn);
    },
    end() {
      const is_curve = length_of(on_screen) >= least_length_px && on_screen.length > 3;
      if (is_curve) {
        workbench.drag_document(with_drawn);
        workbench.mode = "point";
      }
      ended(is_curve);
      if (is_curve) surface.touched = false; // its linkage is to be seen
    },
    cancel: () => ended(false),
  };
}
