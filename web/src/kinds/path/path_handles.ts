// The points, given pivots and the marks of the crank's dial, as one takes hold of them on the drawing.
import type {Point, Side} from "../../contract/messages";
import {Way, type Drag} from "../../drawing/drags/drag";
import {task_handle, type Handle} from "../../drawing/handles";
import {angle_note, point_note} from "../../drawing/notes";
import {multiple, wrapped_deg, type Keys} from "../../drawing/snapping";
import {part_drag, type Surface} from "../../drawing/surface";
import type {Problem} from "../../state/problem";
import {t} from "../../texts/texts.svelte";
import {anchors_of} from "../kind_dispatch";
import {dial_of, hold_dial, release_dial, type Dial} from "./dial";
import {path_task, points_of, with_pivot, with_point} from "./points";
import {given_sides, pivots_of, place_of} from "./task";

export const point_part = (index: number) => `point_${index + 1}`;
export const mark_part = (index: number) => `crank_${index + 1}`;

/** As the pivots of linkages are called, in whose place it is taken hold of. */
export const pivot_part = (side: Side) => `pivot_${side}_center` as const;

export function path_handles(surface: Surface): Handle[] {
  const dial = dial_of(surface),
    task = path_task(surface.workbench.problem);
  return [
    ...(task?.points ?? []).map((_, index) => point_handle(surface, index)),
    ...(task ? given_sides(task) : []).map((side) => pivot_handle(surface, side)),
    ...(dial?.marks.map((_, index) => mark_handle(surface, dial, index)) ?? []),
  ];
}

/** A place of the task: where it is, what else it lines up with, and the problem with it elsewhere. */
interface Place {
  part: string;
  label: (at: string) => string;
  here(): Point;
  others(): Point[];
  moved(problem: Problem, to: Point): Problem;
}
function place_handle(surface: Surface, {part, label, here, others, moved}: Place): Handle {
  const {workbench} = surface;
  const note = (at: Point) => point_note(at, surface.space.step, workbench.unit);
  return task_handle(
    {
      part,
      label: () => label(note(here())),
      drag(from): Drag {
        const start = here(),
          way = new Way(surface, from),
          beside = others();
        return part_drag(surface, part, {
          move(at, keys) {
            const {point, guides} = surface.space.snapped(start, way.to(at, keys).from(start), keys, beside);
            workbench.drag((problem) => moved(problem, point));
            surface.guides = guides;
            surface.tell(at, note(point));
          },
        });
      },
      nudge(dx, dy, step) {
        const [x, y] = here(),
          add = (value: number, by: number) => Number((value + by).toPrecision(12)) + 0;
        workbench.edit((problem) => moved(problem, [add(x, dx * step), add(y, dy * step)]), `nudge ${part}`);
      },
    },
    surface.space.project(here()),
    "move",
  );
}
function point_handle(surface: Surface, index: number): Handle {
  const points = () => points_of(surface.workbench.problem);
  return place_handle(surface, {
    part: point_part(index),
    label: (at) => t("path.point_handle", {n: index + 1, at}),
    here: () => place_of(points()[index] ?? {x: 0, y: 0}),
    others: () => points().flatMap((point, i) => (i === index ? [] : [place_of(point)])),
    moved: (problem, [x, y]) => with_point(problem, index, {x, y}),
  });
}
function pivot_handle(surface: Surface, side: Side): Handle {
  const task = () => path_task(surface.workbench.problem);
  return place_handle(surface, {
    part: pivot_part(side),
    label: (place) => t(`given.${pivot_part(side)}`, {place}),
    here: () => pivots_of(task()!)[side] ?? [0, 0],
    others: () => anchors_of(task()!).filter((at) => at !== pivots_of(task()!)[side]),
    moved: (problem, to) => with_pivot(problem, side, to),
  });
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
