// What is given beside three positions, as one takes hold of it on the drawing: rings for lengths, a wedge for the angle,
// a cross for the instant centre.
import type {Point, Side} from "../../engine/protocol";
import {Way} from "../../drawing/drags/drag";
import {task_handle, type Handle} from "../../drawing/handles";
import {angle_note, length_note, point_note} from "../../drawing/notes";
import {multiple, snapped_angle, wrapped_deg, type Keys} from "../../drawing/snapping";
import {is_held, part_drag, type Surface} from "../../drawing/surface";
import {t} from "../../texts/texts.svelte";
import type {Given} from "./task";
import {direction_deg, given_of, lengths_of, takes_given, with_given, with_length} from "./given";
import {defaults} from "../../state/defaults";

export const wedge_radius = 64;
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
  return handles;
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

function center_handle(surface: Surface, [x, y]: Point): Handle {
  const {workbench} = surface,
    part = "instant_center";
  return task_handle(
    {
      part,
      label: () => t("given.center", {place: point_note([x, y], surface.space.step, workbench.unit)}),
      drag(from) {
        const way = new Way(surface, from);
        return part_drag(surface, part, {
          move(at, keys) {
            const {space, origins} = surface,
              {point, guides} = space.snapped([x, y], way.to(at, keys).from([x, y]), keys, origins);
            surface.guides = guides;
            change(surface, {instant_center: point}, at, point_note(point, space.step, workbench.unit));
          },
        });
      },
      nudge(dx, dy, step) {
        const add = (value: number, by: number) => Number((value + by).toPrecision(12));
        workbench.edit(
          (problem) => with_given(problem, {instant_center: [add(x, dx * step), add(y, dy * step)]}),
          `nudge ${part}`,
        );
      },
    },
    surface.space.project([x, y]),
    "move",
  );
}
