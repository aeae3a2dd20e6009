// What is given beside three positions, as one takes hold of it on the drawing: rings for lengths, a wedge for the angle,
// a cross for the instant centre.
import type {Point, Side} from "../../engine/protocol";
import type {Bench, Drag} from "../../drawing/drags/drag";
import {finish, grid, pixel, Way} from "../../drawing/drags/drag";
import {task_handle, type Handle} from "../../drawing/handles";
import type {Scene} from "../../drawing/scene.svelte";
import {multiple, snapped_angle, snapped_point, wrapped_deg, type Keys} from "../../drawing/snapping";
import {shows, to_screen, to_user} from "../../drawing/viewport";
import {angle_note, length_note, point_note} from "../../drawing/words";
import {mistake_sentence} from "../../task/mistakes";
import {t} from "../../texts/texts.svelte";
import type {Given} from "./task";
import {direction_deg, given_of, lengths_of, takes_given, with_given, with_length} from "./given";

export const wedge_radius = 64;
const knob_turns_deg = [45, -45, 90, -90, 135, -135, 180]; // from the side link; the first that is to be seen

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
  /** Of the input side link in position 1, and of the output, degrees. */
  from_deg: number;
  to_deg: number;
  directed: boolean;
  knob: Point; // screen
}

function given_here({workbench}: Scene): Given | null {
  return takes_given(workbench.problem) ? given_of(workbench.problem) : null;
}
/** Where a side link turns: what is dragged keeps the place in which it was pressed. */
function center_of(scene: Scene, side: Side): Point {
  const {hand} = scene.workbench,
    [first] = scene.poses;
  return scene.anchor ?? hand?.[side].center ?? [first.x, first.y];
}

export function rings_of(scene: Scene): Ring[] {
  const given = given_here(scene),
    {hand} = scene.workbench;
  if (!given) return [];
  return (Object.entries(lengths_of(given)) as [Side, number | null][]).flatMap(([side, length]) => {
    const radius = length ?? hand?.[side].length,
      held = scene.held?.kind === "task" && scene.held.part === `ring_${side}`;
    if (!radius) return [];
    const center = held ? center_of(scene, side) : (hand?.[side].center ?? [scene.poses[0].x, scene.poses[0].y]);
    const circle = hand?.[side].circle,
      from_deg = circle && hand?.[side].center ? direction_deg(hand[side].center, circle) : 0;
    return [{side, center, radius, chosen: length === null, knob: knob_of(scene, center, radius, from_deg)}];
  });
}
function knob_of({view}: Scene, [x, y]: Point, radius: number, from_deg: number): Point {
  const at = (turn: number): Point => [
    x + radius * Math.cos(((from_deg + turn) * Math.PI) / 180),
    y + radius * Math.sin(((from_deg + turn) * Math.PI) / 180),
  ];
  return at(knob_turns_deg.find((turn) => shows(view, at(turn), 20)) ?? knob_turns_deg[0]);
}
export function wedge_of(scene: Scene): Wedge | null {
  const given = given_here(scene),
    input = scene.workbench.hand?.input;
  if (!given || !("side_angle_deg" in given)) return null;
  const [first] = scene.poses,
    apex = input?.center ?? ([first.x, first.y] as Point);
  const from_deg = input?.center && input.circle ? direction_deg(input.center, input.circle) : 0,
    to_deg = from_deg + given.side_angle_deg;
  const [x, y] = to_screen(scene.view, apex),
    to = (to_deg * Math.PI) / 180;
  return {
    apex,
    from_deg,
    to_deg,
    directed: given.directed ?? true,
    knob: [x + wedge_radius * Math.cos(to), y - wedge_radius * Math.sin(to)],
  };
}
export function instant_center_of(scene: Scene): Point | null {
  const given = given_here(scene);
  return given && "instant_center" in given && !given.at_infinity ? given.instant_center : null;
}

// ---- taking hold --------------------------------------------------------------------------------------------------

export function given_handles(scene: Scene): Handle[] {
  const handles = rings_of(scene).map((ring) => ({
    ...ring_handle(scene, ring),
    distance: (at: Point) => off_ring(scene, ring, at),
  }));
  const wedge = wedge_of(scene),
    center = instant_center_of(scene);
  if (wedge) handles.push(angle_handle(scene, wedge) as (typeof handles)[number]);
  if (center) handles.push(center_handle(scene, center) as (typeof handles)[number]);
  return handles;
}
/** A ring can be taken anywhere. */
function off_ring(scene: Scene, {center, radius, knob}: Ring, at: Point): number {
  const [x, y] = to_screen(scene.view, center),
    [kx, ky] = to_screen(scene.view, knob);
  return Math.min(
    Math.abs(Math.hypot(at[0] - x, at[1] - y) - radius * scene.view.scale) + 6,
    Math.hypot(at[0] - kx, at[1] - ky),
  );
}

function change(bench: Bench, given: Given, at: Point, text: string): void {
  const {workbench, scene} = bench;
  workbench.drag((problem) => with_given(problem, given));
  const [mistake] = workbench.refusal ?? [];
  const reason = workbench.task?.status === "solved" ? null : (workbench.task?.reason?.message ?? null);
  scene.note = {at, text, reason: mistake ? mistake_sentence(mistake) : reason};
}
/** A gesture on a part of the task: `move` follows the pointer. */
function given_drag(
  {workbench, scene}: Bench,
  part: string,
  anchor: Point | null,
  move: (at: Point, keys: Keys) => void,
): Drag {
  workbench.begin_gesture();
  scene.held = scene.handles.find(({target}) => target.kind === "task" && target.part === part)?.target ?? null;
  scene.anchor = anchor;
  return {
    cursor: "grabbing",
    move,
    end: () => finish({workbench, scene}, true),
    cancel: () => finish({workbench, scene}, false),
  };
}

function ring_handle(scene: Scene, {side, center, radius, knob}: Ring): Handle {
  const part = `ring_${side}`,
    {workbench} = scene;
  const step_of = (keys: Keys) =>
    keys.alt || !grid(scene).on ? pixel(scene.view) : keys.fine ? scene.step / 10 : scene.step;
  const set = (bench: Bench, length: number, at: Point) => {
    const given = given_of(workbench.problem);
    if (given && length > 0)
      change(
        bench,
        with_length(given, side, length),
        at,
        `${side === "input" ? "R₁" : "R₂"} ${length_note(length, scene.step, workbench.unit)}`,
      );
  };
  return task_handle(
    {
      part,
      label: () => t(`given.ring_${side}`, {length: length_note(radius, scene.step, workbench.unit)}),
      drag: (bench) =>
        given_drag(bench, part, center, (at, keys) => {
          const [x, y] = to_user(scene.view, at);
          set(bench, multiple(Math.hypot(x - center[0], y - center[1]), step_of(keys)), at);
        }),
      nudge(_, dx, dy, step) {
        const given = given_of(workbench.problem),
          length = Number((radius + (dx || dy) * step).toPrecision(12));
        if (given && length > 0)
          workbench.edit((problem) => with_given(problem, with_length(given, side, length)), `nudge ${part}`);
      },
    },
    to_screen(scene.view, knob),
    "grab",
  );
}

function angle_handle(scene: Scene, {apex, from_deg, knob}: Wedge): Handle {
  const {workbench} = scene,
    part = "side_angle";
  const turned = (given: Given, angle: number): Given => ({...given, side_angle_deg: angle}) as Given;
  return task_handle(
    {
      part,
      label: () =>
        t("given.wedge", {angle: angle_note((given_of(workbench.problem) as {side_angle_deg: number}).side_angle_deg)}),
      drag: (bench) =>
        given_drag(bench, part, apex, (at, keys) => {
          const [x, y] = to_screen(scene.view, apex),
            given = given_of(workbench.problem);
          const raw = (Math.atan2(y - at[1], at[0] - x) * 180) / Math.PI - from_deg,
            {angle} = snapped_angle(raw, [], 0, grid(scene).on, keys);
          if (given) change(bench, turned(given, angle), at, `γ ${angle_note(angle)}`);
        }),
      nudge(_, dx, dy, step) {
        const given = given_of(workbench.problem) as {side_angle_deg: number},
          by = ((dy || -dx) * step) / scene.step;
        workbench.edit(
          (problem) =>
            with_given(
              problem,
              turned(given as Given, wrapped_deg(Number((given.side_angle_deg + by).toPrecision(12)))),
            ),
          `nudge ${part}`,
        );
      },
    },
    knob,
  );
}

function center_handle(scene: Scene, [x, y]: Point): Handle {
  const {workbench} = scene,
    part = "instant_center";
  return task_handle(
    {
      part,
      label: () => t("given.center", {place: point_note([x, y], scene.step, workbench.unit)}),
      drag(bench, from) {
        const way = new Way(scene, from);
        return given_drag(bench, part, null, (at, keys) => {
          const moved = way.to(at, keys),
            {point, guides} = snapped_point(
              [x, y],
              [x + moved.x, y + moved.y],
              grid(scene, scene.poses),
              keys,
              pixel(scene.view),
            );
          scene.guides = guides;
          change(bench, {instant_center: point}, at, point_note(point, scene.step, workbench.unit));
        });
      },
      nudge(_, dx, dy, step) {
        const add = (value: number, by: number) => Number((value + by).toPrecision(12));
        workbench.edit(
          (problem) => with_given(problem, {instant_center: [add(x, dx * step), add(y, dy * step)]}),
          `nudge ${part}`,
        );
      },
    },
    to_screen(scene.view, [x, y]),
    "move",
  );
}
