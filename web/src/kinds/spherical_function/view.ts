import type {Component} from "svelte";
import {function_view} from "../function/view";
import {spherical_view} from "../spherical/view";
import type {TaskView} from "../view";
import Editor from "./Editor.svelte";
import Numbers from "./Numbers.svelte";
import Picture from "./Picture.svelte";
import Stage from "./Stage.svelte";

export const spherical_function_view: TaskView = {
  ...spherical_view,
  Stage,
  Editor,
  Numbers,
  Picture: Picture as Component<{id: string}>,
  dial: function_view.dial,
  plots: function_view.plots,
};
