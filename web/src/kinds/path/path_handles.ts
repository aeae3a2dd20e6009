// The points and the marks of the crank's dial, as one takes hold of them on the drawing.
import type {Point} from "../../contract/messages";
import {Way, type Drag} from "../../drawing/drags/drag";
import {task_handle, type Handle} from "../../drawing/handles";
import {angle_note, point_note} from "../../drawing/notes";
import {multiple, wrapped_deg, type Keys} from "../../drawing/snapping";
import {part_drag, type Surface} from "../../drawing/surface";
import {t} from "../../texts/texts.svelte";
import {dial_of, hold_dial, release_dial, type Dial} from "./dial";
import {points_of, with_point} from "./points";
import {place_of} from "./task";

export const point_part = (index: number) => `point_${index + 1}`;
export const mark_part = (index: number) => `crank_${index + 1}`;

export function path_handles(surface: Surface): Handle[] {
  const dial = dial_of(surface);
  return [
    ...points_of(surface.workbench.problem).map((_, index) => point_handle(surface, index)),
    ...(dial?.marks.map((_, index) => mark_handle(surface, dial, index)) ?? []),
  ];
}

function point_handle(surface: Surface, index: number): Handle {
  const {workbench} = surface,
    part = point_part(index),
    here = (): Point => place_of(points_of(workbench.problem)[index] ?? {x: 0, y: 0, input_deg: 0});
  const note = (at: Point) => point_note(at, surface.space.step, workbench.unit);
  return task_handle(
    {
      part,
      label: () => t("path.point_handle", {n: index + 1, at: note(here())}),
      drag(from): Drag {
        const start = here(),
          way = new Way(surface, from),
          others = points_of(workbench.problem).flatMap((point, i) => (i === index ? [] : [place_of(point)]));
        return part_drag(surface, part, {
          move(at, keys) {
            const {point, guides} = surface.space.snapped(start, way.to(at, keys).from(start), keys, others),
              [x, y] = point;
            workbench.drag((problem) => with_point(problem, index, {x, y}));
            surface.guides = guides;
            surface.tell(at, note(point));
          },
        });
      },
      nudge(dx, dy, step) {
        const [x, y] = here(),
          add = (value: number, by: number) => Number((value + by).toPrecision(12)) + 0;
        workbench.edit(
          (problem) => with_point(problem, index, {x: add(x, dx * step), y: add(y, dy * step)}),
          `nudge ${part}`,
        );
      },
    },
    surface.space.project(here()),
    "move",
  );
}

/** An angle as it comes to rest. */
function snapped(raw: number, on: boolean, keys: Keys): number {
  return multiple(raw, keys.shift ? 15 : keys.alt || !on ? 0.001 : keys.fine ? 0.1 : 1);
}
function mark_handle(surface: Surface, dial: Dial, index: number): Handle {
  const {workbench} = surface,
    part = mark_part(index),
    mark = dial.marks[index]!;
  const set = (input_deg: number) => (problem: typeof workbench.problem) => with_point(problem, index, {input_deg});
  return task_handle(
    {
      part,
      label: () => t("path.crank_handle", {n: index + 1, angle: angle_note(mark.angle_deg)}),
      drag(): Drag {
        let value = mark.angle_deg;
        hold_dial(surface);
        return part_drag(surface, part, {
          move(at, keys) {
            const raw = (Math.atan2(dial.center[1] - at[1], at[0] - dial.center[0]) * 180) / Math.PI - dial.zero_deg;
            value = snapped(value + wrapped_deg(raw - value), surface.space.snaps, keys);
            workbench.drag(set(value));
            surface.tell(at, `φ ${angle_note(value)}`);
          },
          ended: () => release_dial(surface),
        });
      },
      nudge(dx, dy, step) {
        const by = ((dy || -dx) * step) / surface.space.step;
        workbench.edit(set(Number((mark.angle_deg + by).toPrecision(12))), `nudge ${part}`);
      },
    },
    mark.at,
  );
}
