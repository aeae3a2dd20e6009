// The views of the kinds of tasks there are: that of the task on screen first, the others later.
import {SvelteMap} from "svelte/reactivity";
import {later} from "../look/later.svelte";
import type {Task} from "../state/task";
import type {TaskKind} from "./kind";
import {kind_of, task_kinds} from "./kind_dispatch";
import {task_modules} from "./registry";
import type {TaskView} from "./view";

const views = new SvelteMap<unknown, TaskView>();

async function load(module: (typeof task_modules)[number]): Promise<void> {
  if (!views.has(module)) views.set(module, await module.view());
}
/** Before the page stands, and whenever a task of another kind comes. */
export async function load_view(task: Task): Promise<void> {
  await load(task_modules.find((module) => module === kind_of(task))!);
}
/** Before tasks of several kinds are shown beside each other. */
export const load_views = later(async () => void (await Promise.all(task_modules.map(load))));
/** Reactive. */
export function has_view(task: Task): boolean {
  return views.has(kind_of(task));
}
function view_of(kind: TaskKind | undefined): TaskView {
  const view = views.get(kind);
  if (!view) throw new Error("the view is not loaded");
  return view;
}
export function task_view(task: Task): TaskView {
  return view_of(kind_of(task));
}
/** Of the kind that has this beginning. */
export function beginning_view(id: string): TaskView {
  return view_of(task_kinds.find(({beginnings}) => beginnings.some((beginning) => beginning.id === id)));
}
