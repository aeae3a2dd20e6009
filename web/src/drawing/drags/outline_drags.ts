// The body's outline: corners are dragged, midpoints become corners.
import type {Point} from "../../contract/messages";
import {body_point, outline_of, with_view, type Problem} from "../../state/problem";
import type {Target} from "../handles";
import {point_note} from "../notes";
import {no_keys, type Keys} from "../snapping";
import type {Bench} from "../bench";
import type {Drag} from "./drag";

export function with_outline(problem: Problem, outline: readonly Point[]): Problem {
  return with_view(problem, {outline});
}
/** A corner's body coordinates under the pointer, snapped in the body. */
export function corner_at({scene}: Bench, at: Point, keys: Keys = no_keys, from: Point = [0, 0]): Point {
  const raw = body_point(scene.space.unproject(at), scene.outline_pose!);
  return scene.space.snapped(from, raw, keys).point;
}
export function without_corner(outline: readonly Point[], index: number): readonly Point[] {
  return outline.length > 3 ? outline.filter((_, i) => i !== index) : outline;
}

export function corner_drag(bench: Bench, target: Extract<Target, {kind: "corner" | "midpoint"}>): Drag {
  const {workbench, scene} = bench,
    before = scene.outline;
  const added = target.kind === "midpoint",
    index = added ? target.index + 1 : target.index;
  const start = added ? [...before.slice(0, index), ...before.slice(index - 1)] : before;
  workbench.begin_gesture();
  scene.held = {kind: "corner", index};
  scene.corner = index;
  return {
    cursor: "crosshair",
    move(at, keys) {
      const point = corner_at(bench, at, keys, start[index]);
      workbench.drag((problem) =>
        with_outline(
          problem,
          start.map((p, i) => (i === index ? point : p)),
        ),
      );
      scene.tell(at, point_note(point, scene.space.step, workbench.unit), null);
    },
    end: () => scene.finish(true),
    cancel: () => scene.finish(false),
  };
}
/** A click on an edge's midpoint adds a corner there. */
export function add_corner(bench: Bench, index: number): void {
  bench.workbench.edit((problem) => {
    const outline = outline_of(problem),
      p = outline[index],
      q = outline[(index + 1) % outline.length];
    if (!p || !q) return problem;
    const short = (value: number) => Number(value.toPrecision(9));
    const middle: Point = [short((p[0] + q[0]) / 2), short((p[1] + q[1]) / 2)];
    return with_outline(problem, [...outline.slice(0, index + 1), middle, ...outline.slice(index + 1)]);
  });
  bench.scene.corner = index + 1;
}
export function remove_corner(bench: Bench, index: number): void {
  bench.workbench.edit((problem) => with_outline(problem, without_corner(outline_of(problem), index)));
  bench.scene.corner = null;
}
