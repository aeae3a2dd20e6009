// The chain's hinges in position 1, as one takes hold of them on the drawing.
import type {Point} from "../../engine/protocol";
import {finish, grid, pixel, Way, type Bench, type Drag} from "../../drawing/drags/drag";
import {task_handle, type Handle, type TaskPart} from "../../drawing/handles";
import type {Scene} from "../../drawing/scene.svelte";
import {snapped_point} from "../../drawing/snapping";
import {to_screen} from "../../drawing/viewport";
import {point_note} from "../../drawing/words";
import {mistake_sentence} from "../../task/mistakes";
import {t} from "../../texts/texts.svelte";
import {hinges, six_bar_task, with_hinge, with_six_bar, type Hinge} from "./chain";

export function chain_handles(scene: Scene): Handle[] {
  const chain = six_bar_task(scene.workbench.problem)?.chain;
  return chain
    ? hinges.map((hinge) =>
        task_handle(part_of(scene, hinge, chain[hinge]), to_screen(scene.view, chain[hinge]), "move"),
      )
    : [];
}
export function held_hinge({held}: Scene): Hinge | null {
  return held?.kind === "task" ? (hinges.find((hinge) => held.part === `chain_${hinge}`) ?? null) : null;
}

function moved({workbench}: Bench, hinge: Hinge, at: Point): void {
  workbench.drag((problem) => {
    const chain = six_bar_task(problem)?.chain;
    return chain ? with_six_bar(problem, {chain: with_hinge(chain, hinge, at)}) : problem;
  });
}
function part_of(scene: Scene, hinge: Hinge, start: Point): Omit<TaskPart, "kind"> {
  const {workbench} = scene,
    part = `chain_${hinge}`;
  return {
    part,
    label: () => t("six_bar.hinge", {name: hinge, place: point_note(start, scene.step, workbench.unit)}),
    drag: (bench, from) => hinge_drag(bench, hinge, start, from),
    nudge(_, dx, dy, step) {
      const add = (value: number, by: number) => Number((value + by).toPrecision(12));
      workbench.edit((problem) => {
        const chain = six_bar_task(problem)?.chain;
        return chain
          ? with_six_bar(problem, {
              chain: with_hinge(chain, hinge, [add(chain[hinge][0], dx * step), add(chain[hinge][1], dy * step)]),
            })
          : problem;
      }, `nudge ${part}`);
    },
  };
}
function hinge_drag(bench: Bench, hinge: Hinge, start: Point, from: Point): Drag {
  const {workbench, scene} = bench,
    way = new Way(scene, from);
  workbench.begin_gesture();
  scene.held =
    scene.handles.find(({target}) => target.kind === "task" && target.part === `chain_${hinge}`)?.target ?? null;
  return {
    cursor: "move",
    move(at, keys) {
      const {x, y} = way.to(at, keys),
        {point, guides} = snapped_point(
          start,
          [start[0] + x, start[1] + y],
          grid(scene, scene.poses),
          keys,
          pixel(scene.view),
        );
      scene.guides = guides;
      moved(bench, hinge, point);
      const [mistake] = workbench.refusal ?? [];
      scene.note = {
        at,
        text: `${hinge}  ${point_note(point, scene.step, workbench.unit)}`,
        reason: mistake ? mistake_sentence(mistake) : null,
      };
    },
    end: () => finish(bench, true),
    cancel: () => finish(bench, false),
  };
}
