// The boxes in which studs are looked for, as one takes hold of them on the drawing: by a corner, or as a whole.
import type {Box, Point, StudEnd} from "../../contract/messages";
import {moved_box, nudged_box} from "../../drawing/drags/box_drags";
import {Way, type Drag} from "../../drawing/drags/drag";
import {task_handle, type Edges, type Handle} from "../../drawing/handles";
import {length_note} from "../../drawing/notes";
import {multiple} from "../../drawing/snapping";
import {part_drag, type Surface} from "../../drawing/surface";
import type {Place} from "../../figure/figure";
import type {Configuration} from "../../figure/mechanism";
import {body_point, placed} from "../../state/problem";
import {t} from "../../texts/texts.svelte";
import {frames_of} from "./places";
import {place_study_of, type PlaceStudy} from "./place_study.svelte";
import {stud_ends} from "./placing";

interface Corner {
  edges: Edges;
  at: Point;
}
const corner_edges = [
  {x: -1, y: 1},
  {x: 1, y: 1},
  {x: 1, y: -1},
  {x: -1, y: -1},
] as const satisfies Edges[];

/** Round about, in the box's own frame. */
export function corners_of({x, y}: Box): Corner[] {
  const along = ([low, high]: readonly [number, number], edge: -1 | 1) => (edge < 0 ? low : high);
  return corner_edges.map((edges) => ({edges, at: [along(x, edges.x), along(y, edges.y)]}));
}
export function box_part(stud: StudEnd, {x, y}: Edges): string {
  const side = (edge: number, names: string) => (edge === 0 ? "" : names[edge < 0 ? 0 : 1]!);
  return `place_${stud}_${side(y, "sn") + side(x, "we") || "all"}`;
}
function size_note({x, y}: Box, {space, workbench}: Surface): string {
  return `${length_note(x[1] - x[0], space.step, "")} × ${length_note(y[1] - y[0], space.step, workbench.unit)}`;
}

function box_handle(
  surface: Surface,
  study: PlaceStudy,
  stud: StudEnd,
  box: Box,
  frame: Place,
  corner: Corner,
): Handle {
  const {edges, at} = corner,
    part = box_part(stud, edges),
    is_whole = edges.x === 0 && edges.y === 0,
    name = () => t(`loads.place_box_${stud}`);
  return task_handle(
    {
      part,
      label: () => t(is_whole ? "loads.place_whole" : "loads.place_corner", {box: name()}),
      drag(from): Drag {
        const way = new Way(surface, from),
          frame_turn = {x: 0, y: 0, theta_deg: frame.theta_deg};
        return part_drag(surface, part, {
          move(pointer, keys) {
            const {x, y} = way.to(pointer, keys),
              [dx, dy] = body_point([x, y], frame_turn),
              {step} = surface.space;
            const moved = moved_box(box, edges, dx, dy, (value) =>
              multiple(value, keys.fine || keys.alt ? step / 10 : step),
            );
            study.put_box(stud, moved);
            surface.tell(pointer, size_note(moved, surface), null);
          },
          ended: (kept) => kept || study.put_box(stud, box),
        });
      },
      nudge(dx, dy, step) {
        const nudged = nudged_box(box, edges, dx * step, dy * step);
        if (nudged) study.put_box(stud, nudged);
      },
    },
    surface.space.project(placed(at, frame)),
    is_whole ? "move" : "crosshair",
  );
}
export function place_handles(surface: Surface, now: Configuration | null): Handle[] {
  const study = place_study_of(surface.workbench),
    wanted = study.shown ? study.wanted : null;
  if (!wanted) return [];
  const frames = frames_of(now, surface.poses[0]);
  return stud_ends.flatMap((stud) => {
    const frame = frames[stud],
      box = wanted[stud];
    if (!frame) return [];
    const whole: Corner = {edges: {x: 0, y: 0}, at: [(box.x[0] + box.x[1]) / 2, box.y[1]]};
    return [...corners_of(box), whole].map((corner) => box_handle(surface, study, stud, box, frame, corner));
  });
}
