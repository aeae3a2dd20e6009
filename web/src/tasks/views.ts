// The views of the kinds of tasks there are.
import type {Task} from "../state/task";
import {kind_of} from "./kinds";
import {task_modules} from "./registry";
import type {TaskView} from "./view";

const views = new Map<unknown, TaskView>();

/** Before the page stands. */
export async function load_views(): Promise<void> {
  await Promise.all(task_modules.map(async (module) => views.set(module, await module.view())));
}
export function task_view(task: Task): TaskView {
  const view = views.get(kind_of(task));
  if (!view) throw new Error("the views are not loaded");
  return view;
}
