// The points, the coupler's angles there, given pivots and the marks of the crank's dial, as one takes hold of them on the
// drawing.
import type {Point, Side} from "../../contract/messages";
import {Way, type Drag} from "../../drawing/drags/drag";
import {arm_length, knob_place, task_handle, type Handle} from "../../drawing/handles";
import {angle_note, point_note} from "../../drawing/notes";
import {multiple, wrapped_deg, type Keys} from "../../drawing/snapping";
import {part_drag, type Surface} from "../../drawing/surface";
import type {Problem} from "../../state/problem";
import {t} from "../../texts/texts.svelte";
import {anchors_of} from "../kind_dispatch";
import {dial_of, hold_dial, release_dial, type Dial} from "./dial";
import {path_task, points_of, with_pivot, with_point} from "./points";
import {given_sides, pivots_of, place_of, type PathPoint} from "./task";

export const point_part = (index: number) => `point_${index + 1}`;
export const turn_part = (index: number) => `turn_${index + 1}`;
export const mark_part = (index: number) => `crank_${index + 1}`;

/** Of more the others are moved by the list. */
const most_held = 200;

/** As the pivots of linkages are called, in whose place it is taken hold of. */
export const pivot_part = (side: Side) => `pivot_${side}_center` as const;

export function path_handles(surface: Surface): Handle[] {
  const dial = dial_of(surface),
    task = path_task(surface.workbench.problem);
  return [
    ...(task?.points ?? []).slice(0, most_held).map((_, index) => point_handle(surface, index)),
    ...(task?.points ?? []).flatMap((point, index) => turn_handle(surface, point, index) ?? []),
    ...(task ? given_sides(task) : []).map((side) => pivot_handle(surface, side)),
    ...(dial?.marks.map((mark) => mark_handle(surface, dial, mark)) ?? []),
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
/** An angle of a point's, turned about a centre on the screen, where it is counted from `zero_deg`. */
interface Turn {
  part: string;
  label: (angle: string) => string;
  sign: string;
  center: Point;
  zero_deg: number;
  angle_deg: number;
  change: (angle_deg: number) => Partial<PathPoint>;
  held?: () => void;
  released?: () => void;
}
function angle_handle(surface: Surface, index: number, at: Point, turn: Turn): Handle {
  const {workbench} = surface,
    {part, center} = turn;
  const set = (angle_deg: number) => (problem: Problem) => with_point(problem, index, turn.change(angle_deg));
  return task_handle(
    {
      part,
      label: () => turn.label(angle_note(turn.angle_deg)),
      drag(): Drag {
        let value = turn.angle_deg;
        turn.held?.();
        return part_drag(surface, part, {
          move(to, keys) {
            const raw = (Math.atan2(center[1] - to[1], to[0] - center[0]) * 180) / Math.PI - turn.zero_deg;
            value = snapped(value + wrapped_deg(raw - value), surface.space.snaps, keys);
            workbench.drag(set(value));
            surface.tell(to, `${turn.sign} ${angle_note(value)}`);
          },
          ended: () => turn.released?.(),
        });
      },
      nudge(dx, dy, step) {
        const by = ((dy || -dx) * step) / surface.space.step;
        workbench.edit(set(Number((turn.angle_deg + by).toPrecision(12))), `nudge ${part}`);
      },
    },
    at,
  );
}
function mark_handle(surface: Surface, dial: Dial, {index, at, angle_deg}: Dial["marks"][number]): Handle {
  return angle_handle(surface, index, at, {
    part: mark_part(index),
    label: (angle) => t("path.crank_handle", {n: index + 1, angle}),
    sign: "φ",
    center: dial.center,
    zero_deg: dial.zero_deg,
    angle_deg,
    change: (input_deg) => ({input_deg}),
    held: () => hold_dial(surface),
    released: () => release_dial(surface),
  });
}
/** Where the coupler's angle at a point is taken hold of, as that of a pose is. */
export function knob_of({space}: Pick<Surface, "space">, {x, y, theta_deg}: PathPoint): Point | null {
  return theta_deg === undefined ? null : knob_place({x, y, theta_deg}, space, arm_length);
}
function turn_handle(surface: Surface, point: PathPoint, index: number): Handle | null {
  const at = knob_of(surface, point);
  if (!at) return null;
  return angle_handle(surface, index, at, {
    part: turn_part(index),
    label: (angle) => t("path.turn_handle", {n: index + 1, angle}),
    sign: "θ",
    center: surface.space.project(place_of(point)),
    zero_deg: 0,
    angle_deg: point.theta_deg!,
    change: (theta_deg) => ({theta_deg}),
  });
}
