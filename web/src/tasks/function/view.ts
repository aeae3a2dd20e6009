import type {FunctionTask} from "../../state/task";
import type {TaskView} from "../view";
import DialLayer from "./DialLayer.svelte";
import {dial_handles} from "./dial_handles";
import Editor from "./Editor.svelte";
import FunctionNumbers from "./FunctionNumbers.svelte";

export const function_view: TaskView = {
  Editor,
  Layer: DialLayer,
  handles: dial_handles,
  Numbers: FunctionNumbers,
  plots: (task) =>
    (task as FunctionTask).function
      ? ["error", "transmission", "output", "velocity", "advantage"]
      : ["output", "transmission", "velocity", "advantage"],
};
