// The kinds of tasks there are.
import type {LinkageType, Notice, Point, Property} from "../engine/protocol";
import {with_options, with_task, type Problem} from "../state/problem";
import {is_object} from "../state/shape";
import {diagonal_of, type Task} from "../state/task";
import {function_kind} from "./function/kind";
import {notice_text, type TextKey} from "../texts/texts.svelte";
import type {Incomplete, TaskKind} from "./kind";
import {motion_kind} from "./motion/kind";
import {six_bar_kind} from "./six_bar/kind";

export const task_kinds = [motion_kind, function_kind, six_bar_kind] as unknown as readonly TaskKind[];

const common_properties: readonly Property[] = [
  "min_transmission_angle_deg",
  "link_ratio",
  "longest_link",
  "min_transmission_angle_full_turn_deg",
  "driver_sweep_deg",
];

export function kind_of(task: Task): TaskKind {
  return task_kinds.find((kind) => kind.is(task)) ?? task_kinds[0];
}
/** The same object is the same task: the steps of undo share what they have in common. */
export function read_task(value: unknown): Task | null {
  if (!is_object(value)) return null;
  const known = read_before.get(value);
  if (known !== undefined) return known;
  let task: Task | null = null;
  for (const kind of task_kinds) task ??= kind.read(value);
  read_before.set(value, task);
  return task;
}
const read_before = new WeakMap<object, Task | null>();

export function incompleteness({task}: Problem): Incomplete | null {
  return kind_of(task).incompleteness(task);
}
export function default_max_length(problem: Problem): number {
  return kind_of(problem.task).default_max_length(problem);
}
export function anchors_of(task: Task): Point[] {
  return kind_of(task).anchors(task);
}
/** How large the task is: the diagonal of the box around it. */
export function extent_of(task: Task): number {
  return diagonal_of(anchors_of(task)) || 1;
}
/** What a colour of the map can stand for, beside the type. */
export function properties_of(task: Task): Property[] {
  return [...common_properties, ...(kind_of(task).properties?.(task) ?? [])];
}
/** The problem with another task; what linkages can be the best by only in the old one is no objective any more. */
export function with_other_task(problem: Problem, task: Task): Problem {
  const changed = with_task(problem, task),
    objectives = (of: Task) => kind_of(of).objectives?.(of) ?? [];
  const lost = objectives(problem.task).filter((objective) => !objectives(task).includes(objective));
  return lost.some((objective) => objective === problem.options?.objective)
    ? with_options(changed, {objective: undefined})
    : changed;
}
/** A text of the frame, as this kind of task says it. */
export function text_for(task: Task, key: TextKey): TextKey {
  return kind_of(task).texts?.[key] ?? key;
}
/** A sentence of the engine, as this kind of task says it. */
export function told(task: Task, notice: Notice): string {
  return notice_text(notice, text_for(task, `notice.${notice.code}` as TextKey));
}
/** What a linkage of this task is called: a text's key. */
export function name_of(task: Task, type: LinkageType): TextKey {
  return kind_of(task).make_up?.(task) ?? `type.${type}`;
}
export function map_of(task: Task): string {
  return kind_of(task).map_of(task);
}
