// Studs of springs, the centre of mass and the handle, as one takes hold of them on the drawing.
import type {Point} from "../../contract/messages";
import {Way, type Drag} from "../../drawing/drags/drag";
import {task_handle, type Handle} from "../../drawing/handles";
import {point_note} from "../../drawing/notes";
import {part_drag, type Surface} from "../../drawing/surface";
import type {Configuration} from "../../figure/mechanism";
import type {Problem} from "../../state/problem";
import {t} from "../../texts/texts.svelte";
import {loads_of, type Loads} from "./block";
import {with_loads, with_stud} from "./editing";
import {carried_at, frames_of, marks_of, place_of, type Frames, type Mark} from "./places";

function with_mark(loads: Loads, {of}: Mark, at: Point): Loads {
  switch (of.kind) {
    case "center":
      return loads.body ? {...loads, body: {...loads.body, center: at}} : loads;
    case "handle":
      return loads.handle ? {...loads, handle: {...loads.handle, point: at}} : loads;
    case "stud":
      return with_stud(loads, of.spring, of.end, at);
  }
}
function moved(problem: Problem, mark: Mark, at: Point): Problem {
  return with_loads(problem, (loads) => with_mark(loads, mark, at));
}
function label_of({of, stud}: Mark, loads: Loads, at: string): string {
  if (of.kind === "center") return t("loads.center_handle", {at});
  if (of.kind === "handle") return t("loads.hand_handle", {at});
  const name = loads.springs?.[of.spring]?.name ?? `${t("loads.spring")} ${of.spring + 1}`;
  return t("loads.stud_handle", {name, body: t(`loads.on_${stud.on}`), at});
}

function mark_handle(surface: Surface, loads: Loads, mark: Mark, at: Point, frames: Frames): Handle {
  const {workbench} = surface,
    {part, stud} = mark,
    note = (point: Point) => point_note(point, surface.space.step, workbench.unit);
  return task_handle(
    {
      part,
      label: () => label_of(mark, loads, note(stud.at)),
      drag(from): Drag {
        const way = new Way(surface, from);
        return part_drag(surface, part, {
          move(pointer, keys) {
            const {point, guides} = surface.space.snapped(at, way.to(pointer, keys).from(at), keys, surface.origins),
              there = carried_at(stud.on, point, frames, surface.space.step / 10);
            workbench.drag((problem) => moved(problem, mark, there));
            surface.guides = guides;
            surface.tell(pointer, note(there));
          },
        });
      },
      nudge(dx, dy, step) {
        const [x, y] = stud.at,
          add = (value: number, by: number) => Number((value + by).toPrecision(12)) + 0;
        workbench.edit((problem) => moved(problem, mark, [add(x, dx * step), add(y, dy * step)]), `nudge ${part}`);
      },
    },
    surface.space.project(at),
    "move",
  );
}
export function load_handles(surface: Surface, now: Configuration | null): Handle[] {
  const loads = loads_of(surface.workbench.problem);
  if (!loads) return [];
  const frames = frames_of(now, surface.poses[0]);
  return marks_of(loads).flatMap((mark) => {
    const at = place_of(mark.stud, frames);
    return at ? [mark_handle(surface, loads, mark, at, frames)] : [];
  });
}
