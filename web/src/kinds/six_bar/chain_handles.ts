// The chain's hinges in position 1, as one takes hold of them on the drawing.
import type {Point} from "../../contract/messages";
import {Way, type Drag} from "../../drawing/drags/drag";
import {task_handle, type Handle, type TaskPart} from "../../drawing/handles";
import {point_note} from "../../drawing/notes";
import {is_held, part_drag, type Surface} from "../../drawing/surface";
import type {Problem} from "../../state/problem";
import {t} from "../../texts/texts.svelte";
import {hinges, six_bar_task, with_hinge, with_six_bar, type Hinge} from "./chain";

export function chain_handles(surface: Surface): Handle[] {
  const chain = six_bar_task(surface.workbench.problem)?.chain;
  return chain
    ? hinges.map((hinge) =>
        task_handle(part_of(surface, hinge, chain[hinge]), surface.space.project(chain[hinge]), "move"),
      )
    : [];
}
export function name_of(hinge: Hinge): string {
  return `chain_${hinge}`;
}
export function held_hinge(surface: Surface): Hinge | null {
  return hinges.find((hinge) => is_held(surface, name_of(hinge))) ?? null;
}

function moved(problem: Problem, hinge: Hinge, to: (from: Point) => Point): Problem {
  const chain = six_bar_task(problem)?.chain;
  return chain ? with_six_bar(problem, {chain: with_hinge(chain, hinge, to(chain[hinge]))}) : problem;
}
function part_of(surface: Surface, hinge: Hinge, start: Point): Omit<TaskPart, "kind"> {
  const {workbench} = surface,
    part = name_of(hinge);
  return {
    part,
    label: () => t("six_bar.hinge", {name: hinge, place: point_note(start, surface.space.step, workbench.unit)}),
    drag: (from) => hinge_drag(surface, hinge, start, from),
    nudge(dx, dy, step) {
      const add = (value: number, by: number) => Number((value + by).toPrecision(12));
      workbench.edit(
        (problem) => moved(problem, hinge, ([x, y]) => [add(x, dx * step), add(y, dy * step)]),
        `nudge ${part}`,
      );
    },
  };
}
function hinge_drag(surface: Surface, hinge: Hinge, start: Point, from: Point): Drag {
  const {workbench} = surface,
    way = new Way(surface, from);
  const dragged = part_drag(surface, name_of(hinge), {
    cursor: "move",
    move(at, keys) {
      const {space, origins} = surface,
        {point, guides} = space.snapped(start, way.to(at, keys).from(start), keys, origins);
      surface.guides = guides;
      workbench.drag((problem) => moved(problem, hinge, () => point));
      surface.tell(at, `${hinge}  ${point_note(point, space.step, workbench.unit)}`);
    },
  });
  const [x, y] = start;
  surface.show_halo(surface.poses.length + hinges.indexOf(hinge), {x, y, theta_deg: 0}); // after the poses
  return dragged;
}
