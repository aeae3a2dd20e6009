// The views of the kinds of tasks there are.
import type {Task} from "../state/task";
import {function_view} from "./function/view";
import {kind_of} from "./kinds";
import {function_kind} from "./function/kind";
import {motion_view} from "./motion/view";
import {six_bar_kind} from "./six_bar/kind";
import {six_bar_view} from "./six_bar/view";
import type {TaskKind} from "./kind";
import type {TaskView} from "./view";

const views = new Map<unknown, TaskView>([
  [function_kind, function_view],
  [six_bar_kind, six_bar_view],
]);

export function task_view(task: Task): TaskView {
  return views.get(kind_of(task) as TaskKind) ?? motion_view;
}
