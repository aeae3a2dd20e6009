import type {Component} from "svelte";
import {four_bar} from "../../figure/four_bar";
import type {FunctionTask} from "./task";
import type {TaskView} from "../view";
import DialLayer from "./DialLayer.svelte";
import {angle_scale_handles} from "./dial_handles";
import {function_dial, structural_error} from "./error_plot";
import Editor from "./Editor.svelte";
import FunctionNumbers from "./FunctionNumbers.svelte";
import Picture from "./Picture.svelte";

export const function_view: TaskView = {
  mechanism: four_bar,
  Editor,
  Layer: DialLayer,
  handles: angle_scale_handles,
  Numbers: FunctionNumbers,
  Picture: Picture as Component<{id: string}>,
  dial: function_dial,
  plots: (task) =>
    (task as FunctionTask).function
      ? [structural_error, "transmission", "output", "velocity", "advantage"]
      : ["output", "transmission", "velocity", "advantage"],
};
