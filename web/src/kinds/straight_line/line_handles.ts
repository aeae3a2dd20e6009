// The line and the given pivots, as one takes hold of them on the drawing.
import type {Point} from "../../contract/messages";
import {Way, type Drag} from "../../drawing/drags/drag";
import {task_handle, type Handle} from "../../drawing/handles";
import {angle_note, point_note} from "../../drawing/notes";
import {snapped_angle, wrapped_deg} from "../../drawing/snapping";
import {part_drag, type Surface} from "../../drawing/surface";
import {with_task, type Problem} from "../../state/problem";
import {t} from "../../texts/texts.svelte";
import {without_unmet} from "../kind_dispatch";
import {form_of} from "./cases";
import {is_straight_line, type StraightLineTask} from "./task";

export const direction_px = 90; // from the line's point to the knob

export function line_task({task}: Problem): StraightLineTask | null {
  return is_straight_line(task) ? task : null;
}
export function with_line_task(problem: Problem, change: (task: StraightLineTask) => StraightLineTask): Problem {
  const task = line_task(problem);
  return task ? without_unmet(with_task(problem, change(task))) : problem;
}

/** Something of the task that is a point. */
interface Place {
  part: string;
  name: string;
  at(task: StraightLineTask): Point | undefined;
  moved(task: StraightLineTask, to: Point): StraightLineTask;
}
const line_point: Place = {
  part: "line_point",
  name: "straight.line_point",
  at: ({line}) => line.point,
  moved: (task, point) => ({...task, line: {...task.line, point}}),
};
const ground_place = (side: "input" | "output"): Place => ({
  part: `pivot_${side}_center`, // in the place of the linkage's own
  name: `drawing.pivot_${side}_center`,
  at: ({ground_pivots}) => ground_pivots?.[side],
  moved: (task, to) => (task.ground_pivots ? {...task, ground_pivots: {...task.ground_pivots, [side]: to}} : task),
});
const input_place: Place = {
  part: "pivot_input_center",
  name: "drawing.pivot_input_center",
  at: ({input_pivot}) => input_pivot,
  moved: (task, input_pivot) => ({...task, input_pivot}),
};

function places_of(task: StraightLineTask): Place[] {
  const {pivots} = form_of(task);
  if (pivots === "both") return [line_point, ground_place("input"), ground_place("output")];
  return pivots === "input" ? [line_point, input_place] : [line_point];
}
export function line_handles(surface: Surface): Handle[] {
  const task = line_task(surface.workbench.problem);
  if (!task) return [];
  return [...places_of(task).map((place) => place_handle(surface, place)), direction_handle(surface, task)].flat();
}
/** On the screen. */
export function direction_knob({space}: Surface, {line}: StraightLineTask): Point {
  const [x, y] = space.project(line.point),
    angle = (line.direction_deg * Math.PI) / 180;
  return [x + direction_px * Math.cos(angle), y - direction_px * Math.sin(angle)];
}

function place_handle(surface: Surface, place: Place): Handle[] {
  const {workbench} = surface,
    {part} = place,
    here = (): Point | undefined => {
      const task = line_task(workbench.problem);
      return task ? place.at(task) : undefined;
    };
  const at = here();
  if (!at) return [];
  const others = () => {
    const task = line_task(workbench.problem);
    return task
      ? places_of(task).flatMap((other) => (other.part === part ? [] : [other.at(task) ?? []].filter(is_point)))
      : [];
  };
  const handle = task_handle(
    {
      part,
      label: () => `${t(place.name as never)}: ${point_note(at, surface.space.step, workbench.unit)}`,
      drag(from): Drag {
        const start = here() ?? at,
          beside = others(),
          way = new Way(surface, from);
        return part_drag(surface, part, {
          move(to, keys) {
            const {space} = surface,
              {point, guides} = space.snapped(start, way.to(to, keys).from(start), keys, beside);
            workbench.drag((problem) => with_line_task(problem, (task) => place.moved(task, point)));
            surface.guides = guides;
            surface.tell(to, point_note(point, space.step, workbench.unit));
          },
        });
      },
      nudge(dx, dy, step) {
        const [x, y] = here() ?? at,
          add = (value: number, by: number) => Number((value + by).toPrecision(12)) + 0,
          to: Point = [add(x, dx * step), add(y, dy * step)];
        workbench.edit((problem) => with_line_task(problem, (task) => place.moved(task, to)), `nudge ${part}`);
      },
    },
    surface.space.project(at),
    "move",
  );
  return [handle];
}
function is_point(value: Point | never[]): value is Point {
  return value.length === 2;
}

function direction_handle(surface: Surface, task: StraightLineTask): Handle {
  const {workbench} = surface,
    part = "line_direction";
  const turned = (direction_deg: number) => (problem: Problem) =>
    with_line_task(problem, (now) => ({...now, line: {...now.line, direction_deg}}));
  return task_handle(
    {
      part,
      label: () => t("straight.line_direction", {angle: angle_note(task.line.direction_deg)}),
      drag: () =>
        part_drag(surface, part, {
          move(at, keys) {
            const [x, y] = surface.space.project(task.line.point),
              raw = (Math.atan2(y - at[1], at[0] - x) * 180) / Math.PI;
            const {angle} = snapped_angle(raw, [], 0, surface.space.snaps, keys);
            workbench.drag(turned(angle));
            surface.tell(at, `λ ${angle_note(angle)}`);
          },
        }),
      nudge(dx, dy, step) {
        const by = ((dy || -dx) * step) / surface.space.step,
          now = line_task(workbench.problem)?.line.direction_deg ?? 0;
        workbench.edit(turned(wrapped_deg(Number((now + by).toPrecision(12)))), `nudge ${part}`);
      },
    },
    direction_knob(surface, task),
  );
}
