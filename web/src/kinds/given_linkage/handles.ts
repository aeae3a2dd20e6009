// The linkage's pivots in position 1, as one takes hold of them on the drawing.
import type {Point} from "../../contract/messages";
import {Way} from "../../drawing/drags/drag";
import {task_handle, type Handle} from "../../drawing/handles";
import {point_note} from "../../drawing/notes";
import {part_drag, type Surface} from "../../drawing/surface";
import type {Problem} from "../../state/problem";
import {lines_of, with_point, type Line} from "./file";
import {is_linkage} from "./task";
import {line_words} from "./line_words";

const ends: Record<string, string> = {center: "center", fixed: "center", circle: "circle", moving: "circle"};

/** As the drawing calls the pivot for which it stands; otherwise by its place in the file. */
function part_name({path: [form, name], key}: Line): string {
  const [side, end = ""] = String(name).split("_");
  return form === "pivots" && ends[end] ? `pivot_${side}_${ends[end]}` : key;
}
function moved(problem: Problem, line: Line, to: Point): Problem {
  return is_linkage(problem.task) ? {...problem, task: with_point(problem.task, line, to)} : problem;
}
export function given_handles(surface: Surface): Handle[] {
  const {workbench, space} = surface,
    {task} = workbench.problem;
  if (!is_linkage(task)) return [];
  return lines_of(task).flatMap((line): Handle[] => {
    const [x, y] = line.values,
      part = part_name(line);
    if (line.values.length !== 2 || x === undefined || y === undefined) return [];
    const start: Point = [x, y];
    const handle = {
      part,
      label: () => `${line_words(line, task)}, ${point_note(start, space.step, workbench.unit)}`,
      drag(from: Point) {
        const way = new Way(surface, from);
        return part_drag(surface, part, {
          cursor: "move",
          move(at, keys) {
            const {point, guides} = surface.space.snapped(start, way.to(at, keys).from(start), keys, surface.origins);
            surface.guides = guides;
            workbench.drag((problem) => moved(problem, line, point));
            surface.tell(at, point_note(point, surface.space.step, workbench.unit));
          },
        });
      },
      nudge(dx: number, dy: number, step: number) {
        const add = (value: number, by: number) => Number((value + by).toPrecision(12));
        workbench.edit((problem) => moved(problem, line, [add(x, dx * step), add(y, dy * step)]), `nudge ${part}`);
      },
    };
    return [task_handle(handle, space.project(start), "move")];
  });
}
