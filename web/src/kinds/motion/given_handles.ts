// What is given beside three positions, as one takes hold of it on the drawing: rings for lengths, a wedge for the angle,
// a cross for the instant centre.
import type {Point, Side} from "../../contract/messages";
import {Way} from "../../drawing/drags/drag";
import {task_handle, type Handle} from "../../drawing/handles";
import {angle_note, length_note, point_note} from "../../drawing/notes";
import {multiple, snapped_angle, wrapped_deg, type Keys} from "../../drawing/snapping";
import {is_held, part_drag, type Surface} from "../../drawing/surface";
import {t} from "../../texts/texts.svelte";
import {with_task, type Problem} from "../../state/problem";
import type {Given, Line, MotionTask} from "./task";
import {direction_deg, given_of, lengths_of, takes_given, takes_lines, with_given, with_length} from "./given";
import {given_lines, given_pivots, lines_of, pivot_kinds, pivots_of, sides} from "./pivots";
import {defaults} from "../../state/defaults";

export const wedge_radius = 64;
const line_knob_px = 70; // from a line's point
const usual_turn_deg = 45,
  knob_turns_deg = [usual_turn_deg, -45, 90, -90, 135, -135, 180]; // from the grounded link; the first that is to be seen

export interface Ring {
  side: Side;
  center: Point;
  radius: number;
  /** The engine has chosen it. */
  chosen: boolean;
  knob: Point;
}
export interface Wedge {
  apex: Point;
  /** Of the input link in position 1, and of the output, degrees. */
  from_deg: number;
  to_deg: number;
  directed: boolean;
  knob: Point; // screen
}

function given_here({workbench}: Surface): Given | null {
  return takes_given(workbench.problem) ? given_of(workbench.problem) : null;
}
function first_origin({origins: [first = [0, 0]]}: Surface): Point {
  return first;
}
function side_center(surface: Surface, side: Side): Point {
  return surface.workbench.hand?.[side].center ?? first_origin(surface);
}
/** Where a grounded link turns: what is dragged keeps the place in which it was pressed. */
function center_of(surface: Surface, side: Side): Point {
  return surface.anchor ?? side_center(surface, side);
}

export function rings_of(surface: Surface): Ring[] {
  const given = given_here(surface),
    {hand} = surface.workbench;
  if (!given) return [];
  return (Object.entries(lengths_of(given)) as [Side, number | null][]).flatMap(([side, length]) => {
    const radius = length ?? hand?.[side].length,
      held = is_held(surface, `ring_${side}`);
    if (!radius) return [];
    const center = held ? center_of(surface, side) : side_center(surface, side);
    const circle = hand?.[side].circle,
      from_deg = circle && hand?.[side].center ? direction_deg(hand[side].center, circle) : 0;
    return [{side, center, radius, chosen: length === null, knob: knob_of(surface, center, radius, from_deg)}];
  });
}
function knob_of({space}: Surface, [x, y]: Point, radius: number, from_deg: number): Point {
  const at = (turn: number): Point => [
    x + radius * Math.cos(((from_deg + turn) * Math.PI) / 180),
    y + radius * Math.sin(((from_deg + turn) * Math.PI) / 180),
  ];
  return at(knob_turns_deg.find((turn) => space.shows(at(turn), 20)) ?? usual_turn_deg);
}
export function wedge_of(surface: Surface): Wedge | null {
  const given = given_here(surface),
    input = surface.workbench.hand?.input;
  if (!given || !("side_angle_deg" in given)) return null;
  const apex = input?.center ?? first_origin(surface);
  const from_deg = input?.center && input.circle ? direction_deg(input.center, input.circle) : 0,
    to_deg = from_deg + given.side_angle_deg;
  const [x, y] = surface.space.project(apex),
    to = (to_deg * Math.PI) / 180;
  return {
    apex,
    from_deg,
    to_deg,
    directed: given.directed ?? defaults.given.directed,
    knob: [x + wedge_radius * Math.cos(to), y - wedge_radius * Math.sin(to)],
  };
}
export function instant_center_of(surface: Surface): Point | null {
  const given = given_here(surface);
  return given && "instant_center" in given && !given.at_infinity ? given.instant_center : null;
}

/** A pivot that is given, in the place of the linkage's own. */
interface GivenPlace {
  part: string;
  side: Side;
  at: Point;
  moved(given: Given, to: Point): Given;
}
export function pivots_here(surface: Surface): GivenPlace[] {
  const pivots = pivots_of(given_here(surface));
  return sides.flatMap((side): GivenPlace[] => {
    const pivot = pivots?.[side];
    if (!pivot) return [];
    return [
      {
        part: `pivot_${side}_${pivot.kind === "ground" ? "center" : "circle"}`,
        side,
        at: pivot.point,
        moved: (given, point) => given_pivots({...pivots_of(given), [side]: {kind: pivot.kind, point}}),
      },
    ];
  });
}

/** A line on which pivots lie, of three positions or of four. */
interface LinePlace {
  part: string;
  /** Whose pivots: of one link, or of both. */
  side: Side | null;
  line: Line;
  with_line(problem: Problem, line: Line): Problem;
}
export function lines_here(surface: Surface): LinePlace[] {
  const {problem} = surface.workbench,
    lines = lines_of(given_here(surface)) ?? {},
    on = takes_lines(problem) ? ((problem.task as MotionTask).pivot_on ?? []) : [];
  return [
    ...pivot_kinds.flatMap((kind): LinePlace[] => {
      const line = lines[kind];
      const with_line = (now: Problem, to: Line) =>
        with_given(now, given_lines({...lines_of(given_of(now)), [kind]: to}));
      return line ? [{part: `line_${kind}`, side: null, line, with_line}] : [];
    }),
    ...on.map(({which, line}): LinePlace => ({
      part: `line_${which}`,
      side: which,
      line,
      with_line(now, to) {
        const task = now.task as MotionTask,
          pivot_on = (task.pivot_on ?? []).map((one) => (one.which === which ? {...one, line: to} : one));
        return with_task(now, {...task, pivot_on});
      },
    })),
  ];
}
/** On the screen. */
export function line_knob({space}: Surface, {point, direction_deg}: Line): Point {
  const [x, y] = space.project(point),
    angle = (direction_deg * Math.PI) / 180;
  return [x + line_knob_px * Math.cos(angle), y - line_knob_px * Math.sin(angle)];
}

// ---- taking hold --------------------------------------------------------------------------------------------------

export function given_handles(surface: Surface): Handle[] {
  const handles = rings_of(surface).map((ring) => ({
    ...ring_handle(surface, ring),
    distance: (at: Point) => off_ring(surface, ring, at),
  }));
  const wedge = wedge_of(surface),
    center = instant_center_of(surface);
  if (wedge) handles.push(angle_handle(surface, wedge) as (typeof handles)[number]);
  if (center) handles.push(center_handle(surface, center) as (typeof handles)[number]);
  return [
    ...handles,
    ...pivots_here(surface).map((place) => pivot_handle(surface, place)),
    ...lines_here(surface).flatMap((place) => [line_point_handle(surface, place), line_turn_handle(surface, place)]),
  ];
}
/** A ring can be taken anywhere. */
function off_ring(surface: Surface, {center, radius, knob}: Ring, at: Point): number {
  const [x, y] = surface.space.project(center),
    [kx, ky] = surface.space.project(knob);
  return Math.min(
    Math.abs(Math.hypot(at[0] - x, at[1] - y) - radius * surface.space.scale) + 6,
    Math.hypot(at[0] - kx, at[1] - ky),
  );
}

function change(surface: Surface, given: Given, at: Point, text: string): void {
  const {workbench} = surface;
  workbench.drag((problem) => with_given(problem, given));
  const refused = workbench.refusal?.length;
  const reason = workbench.task?.status === "solved" ? null : (workbench.task?.reason?.message ?? null);
  surface.tell(at, text, refused ? undefined : reason);
}

function ring_handle(surface: Surface, {side, center, radius, knob}: Ring): Handle {
  const part = `ring_${side}`,
    {workbench} = surface;
  const step_of = (keys: Keys) => {
    const {space} = surface;
    return keys.alt || !space.snaps ? 1 / space.scale : keys.fine ? space.step / 10 : space.step;
  };
  const set = (length: number, at: Point) => {
    const given = given_of(workbench.problem),
      note = length_note(length, surface.space.step, workbench.unit);
    if (given && length > 0)
      change(surface, with_length(given, side, length), at, `${side === "input" ? "R₁" : "R₂"} ${note}`);
  };
  return task_handle(
    {
      part,
      label: () => t(`given.ring_${side}`, {length: length_note(radius, surface.space.step, workbench.unit)}),
      drag: () =>
        part_drag(surface, part, {
          anchor: center,
          move(at, keys) {
            const [x, y] = surface.space.unproject(at);
            set(multiple(Math.hypot(x - center[0], y - center[1]), step_of(keys)), at);
          },
        }),
      nudge(dx, dy, step) {
        const given = given_of(workbench.problem),
          length = Number((radius + (dx || dy) * step).toPrecision(12));
        if (given && length > 0)
          workbench.edit((problem) => with_given(problem, with_length(given, side, length)), `nudge ${part}`);
      },
    },
    surface.space.project(knob),
    "grab",
  );
}

function angle_handle(surface: Surface, {apex, from_deg, knob}: Wedge): Handle {
  const {workbench} = surface,
    part = "side_angle";
  const turned = (given: Given, angle: number): Given => ({...given, side_angle_deg: angle}) as Given;
  return task_handle(
    {
      part,
      label: () =>
        t("given.wedge", {angle: angle_note((given_of(workbench.problem) as {side_angle_deg: number}).side_angle_deg)}),
      drag: () =>
        part_drag(surface, part, {
          anchor: apex,
          move(at, keys) {
            const [x, y] = surface.space.project(apex),
              given = given_of(workbench.problem);
            const raw = (Math.atan2(y - at[1], at[0] - x) * 180) / Math.PI - from_deg,
              {angle} = snapped_angle(raw, [], 0, surface.space.snaps, keys);
            if (given) change(surface, turned(given, angle), at, `γ ${angle_note(angle)}`);
          },
        }),
      nudge(dx, dy, step) {
        const given = given_of(workbench.problem) as {side_angle_deg: number},
          by = ((dy || -dx) * step) / surface.space.step;
        const angle = wrapped_deg(Number((given.side_angle_deg + by).toPrecision(12)));
        workbench.edit((problem) => with_given(problem, turned(given as Given, angle)), `nudge ${part}`);
      },
    },
    knob,
  );
}

/** What a point is dragged to, and by the arrow keys. */
function point_handle(
  surface: Surface,
  part: string,
  label: () => string,
  here: () => Point,
  set: (to: Point, at: Point | null) => void,
): Handle {
  return task_handle(
    {
      part,
      label,
      drag(from) {
        const start = here(),
          way = new Way(surface, from);
        return part_drag(surface, part, {
          move(at, keys) {
            const {space, origins} = surface,
              {point, guides} = space.snapped(start, way.to(at, keys).from(start), keys, origins);
            surface.guides = guides;
            set(point, at);
          },
        });
      },
      nudge(dx, dy, step) {
        const add = (value: number, by: number) => Number((value + by).toPrecision(12)),
          [x, y] = here();
        set([add(x, dx * step), add(y, dy * step)], null);
      },
    },
    surface.space.project(here()),
    "move",
  );
}

function pivot_handle(surface: Surface, place: GivenPlace): Handle {
  const {workbench} = surface,
    {part, side} = place;
  const now = () => pivots_of(given_of(workbench.problem))?.[side]?.point ?? place.at;
  return point_handle(
    surface,
    part,
    () => t(`given.${part as "pivot_input_center"}`, {place: point_note(now(), surface.space.step, workbench.unit)}),
    now,
    (point, at) => {
      const given = given_of(workbench.problem);
      if (!given) return;
      const to = place.moved(given, point);
      if (at) change(surface, to, at, point_note(point, surface.space.step, workbench.unit));
      else workbench.edit((problem) => with_given(problem, to), `nudge ${part}`);
    },
  );
}

function line_point_handle(surface: Surface, place: LinePlace): Handle {
  const {workbench} = surface,
    part = `${place.part}_point`;
  const now = () => lines_here(surface).find((line) => line.part === place.part)?.line ?? place.line;
  return point_handle(
    surface,
    part,
    () => `${t("straight.line_point")}: ${point_note(now().point, surface.space.step, workbench.unit)}`,
    () => now().point,
    (point, at) => {
      const moved = (problem: Problem) => place.with_line(problem, {...now(), point});
      if (!at) return workbench.edit(moved, `nudge ${part}`);
      workbench.drag(moved);
      surface.tell(at, point_note(point, surface.space.step, workbench.unit));
    },
  );
}

function line_turn_handle(surface: Surface, place: LinePlace): Handle {
  const {workbench} = surface,
    part = `${place.part}_direction`;
  const now = () => lines_here(surface).find((line) => line.part === place.part)?.line ?? place.line;
  const turned = (direction: number) => (problem: Problem) =>
    place.with_line(problem, {...now(), direction_deg: direction});
  return task_handle(
    {
      part,
      label: () => t("straight.line_direction", {angle: angle_note(now().direction_deg)}),
      drag: () =>
        part_drag(surface, part, {
          move(at, keys) {
            const [x, y] = surface.space.project(now().point),
              raw = (Math.atan2(y - at[1], at[0] - x) * 180) / Math.PI;
            const {angle} = snapped_angle(raw, [], 0, surface.space.snaps, keys);
            workbench.drag(turned(angle));
            surface.tell(at, `λ ${angle_note(angle)}`);
          },
        }),
      nudge(dx, dy, step) {
        const by = ((dy || -dx) * step) / surface.space.step;
        workbench.edit(turned(wrapped_deg(Number((now().direction_deg + by).toPrecision(12)))), `nudge ${part}`);
      },
    },
    line_knob(surface, place.line),
  );
}

function center_handle(surface: Surface, at_first: Point): Handle {
  const {workbench} = surface;
  const now = () => {
    const given = given_of(workbench.problem);
    return given && "instant_center" in given ? given.instant_center : at_first;
  };
  return point_handle(
    surface,
    "instant_center",
    () => t("given.center", {place: point_note(now(), surface.space.step, workbench.unit)}),
    now,
    (point, at) => {
      const given: Given = {instant_center: point};
      if (at) change(surface, given, at, point_note(point, surface.space.step, workbench.unit));
      else workbench.edit((problem) => with_given(problem, given), "nudge instant_center");
    },
  );
}
