// What is given beside three positions: its forms, and what of it can be seen and dragged.
import type {Linkage, Point, Side} from "../../contract/messages";
import {poses_extent, round_step, with_task, type Problem} from "../../state/problem";
import {poses_of, position_count} from "../../state/task";
import {given_lines, given_pivots, lines_of, pivot_of, pivots_of} from "./pivots";
import {fitting_options, is_motion, type Given, type MotionTask} from "./task";

export const given_forms = [
  "side_lengths",
  "side_length",
  "side_angle",
  "instant_center",
  "pivots",
  "pivot_lines",
] as const;
export type GivenForm = (typeof given_forms)[number];

export function form_of(given: Given): GivenForm {
  if (pivots_of(given)) return "pivots";
  if (lines_of(given)) return "pivot_lines";
  return "side_lengths" in given
    ? "side_lengths"
    : "side_length" in given
      ? "side_length"
      : "side_angle_deg" in given
        ? "side_angle"
        : "instant_center";
}
export function given_of({task}: Problem): Given | null {
  return (task as MotionTask).given ?? null;
}
export function with_given(problem: Problem, given: Given): Problem {
  return fitting_options(with_task(problem, {...(problem.task as MotionTask), given}));
}
export function takes_given({task}: Problem): boolean {
  return is_motion(task) && position_count(task.poses) === 3;
}
export function takes_lines({task}: Problem): boolean {
  return is_motion(task) && position_count(task.poses) === 4;
}
/** A direction of travel says the same as an instant centre. */
export function has_form({task}: Problem, form: GivenForm): boolean {
  return form !== "instant_center" || poses_of(task).every((pose) => !pose.derivatives?.length);
}

/** A form to start from: what is given already, else as the linkage in hand has it, else of the task's size. */
export function fresh_given(form: GivenForm, problem: Problem, hand: Linkage | null): Given {
  const poses = poses_of(problem.task),
    size = poses_extent(poses),
    {x, y} = poses[0] ?? {x: 0, y: 0},
    given = given_of(problem),
    known = given ? lengths_of(given) : {};
  const length = (side: Side) => known[side] ?? Number((hand?.[side].length ?? round_step(0.5 * size)).toPrecision(3));
  if (form === "side_lengths") return {side_lengths: [length("input"), length("output")]};
  if (form === "side_length") return {side_length: length("input")};
  if (form === "side_angle") return {side_angle_deg: 60, directed: true};
  if (form === "pivots") {
    const pivot = (side: Side, around: Point) =>
      ({kind: "ground", point: pivot_of(hand, side, "ground", around)}) as const;
    const aside = round_step(0.5 * size);
    return given_pivots({input: pivot("input", [x + aside, y]), output: pivot("output", [x + 2 * aside, y])});
  }
  if (form === "pivot_lines")
    return given_lines({ground: {point: pivot_of(hand, "input", "ground", [x, y]), direction_deg: 0}});
  return {instant_center: [Number((x + round_step(0.5 * size)).toPrecision(6)), y]};
}

/** Lengths of grounded links that are given; null: the engine chooses this one, and it can be set. */
export function lengths_of(given: Given): Partial<Record<Side, number | null>> {
  if ("side_lengths" in given) return {input: given.side_lengths[0], output: given.side_lengths[1]};
  if ("side_length" in given) return {input: given.side_length, output: null};
  return "side_angle_deg" in given ? {input: given.input_length ?? null} : {};
}
export function with_length(given: Given, side: Side, length: number): Given {
  if ("side_lengths" in given)
    return {side_lengths: side === "input" ? [length, given.side_lengths[1]] : [given.side_lengths[0], length]};
  if ("side_length" in given)
    return side === "input" ? {side_length: length} : {side_lengths: [given.side_length, length]};
  return "side_angle_deg" in given ? {...given, input_length: length} : given;
}

/** What was given in each form before another was chosen: it comes back with its form, but for what both have. */
export class GivenMemory {
  private readonly left = new Map<GivenForm, Given>();

  chosen(form: GivenForm, problem: Problem, hand: Linkage | null): Given {
    const now = given_of(problem);
    if (now) this.left.set(form_of(now), now);
    const before = this.left.get(form),
      input = now ? lengths_of(now).input : null;
    if (!before) return fresh_given(form, problem, hand);
    return typeof input === "number" && typeof lengths_of(before).input === "number"
      ? with_length(before, "input", input)
      : before;
  }
}

const memories = new WeakMap<object, {opened: number; memory: GivenMemory}>();
/** Of the task that is open: another begins with nothing. */
export function memory_of(workbench: {opened: number}): GivenMemory {
  const known = memories.get(workbench),
    {opened} = workbench;
  if (known?.opened === opened) return known.memory;
  const memory = new GivenMemory();
  memories.set(workbench, {opened, memory});
  return memory;
}

/** Three positions leave four numbers free. */
export function free_parameter_count(given: Given): number {
  const pivots = pivots_of(given),
    lines = lines_of(given);
  if (pivots) return pivots.input && pivots.output ? 0 : 2;
  if (lines) return lines.ground && lines.moving ? 0 : 2;
  if ("side_lengths" in given || "instant_center" in given) return 2;
  return "input_length" in given && given.input_length !== undefined ? 2 : 3;
}

/** Direction of a grounded link in position 1, degrees. */
export function direction_deg(center: Point, circle: Point): number {
  return (Math.atan2(circle[1] - center[1], circle[0] - center[0]) * 180) / Math.PI;
}
