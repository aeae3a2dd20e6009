// The views of the kinds of tasks there are.
import type {Task} from "../state/task";
import type {TaskKind} from "./kind";
import {kind_of, task_kinds} from "./kinds";
import {task_modules} from "./registry";
import type {TaskView} from "./view";

const views = new Map<unknown, TaskView>();

/** Before the page stands. */
export async function load_views(): Promise<void> {
  await Promise.all(task_modules.map(async (module) => views.set(module, await module.view())));
}
function view_of(kind: TaskKind | undefined): TaskView {
  const view = views.get(kind);
  if (!view) throw new Error("the views are not loaded");
  return view;
}
export function task_view(task: Task): TaskView {
  return view_of(kind_of(task));
}
/** Of the kind that has this beginning. */
export function beginning_view(id: string): TaskView {
  return view_of(task_kinds.find(({beginnings}) => beginnings.some((beginning) => beginning.id === id)));
}
