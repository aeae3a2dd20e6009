import type {Component} from "svelte";
import type {TaskView} from "../view";
import Editor from "./Editor.svelte";
import {path_four_bar} from "./figure";
import Layer from "./Layer.svelte";
import Numbers from "./Numbers.svelte";
import {path_handles} from "./path_handles";
import Picture from "./Picture.svelte";
import {with_clicked} from "./points";
import Requirement from "./Requirement.svelte";
import {stroke_drag} from "./stroke.svelte";

export const path_view: TaskView = {
  mechanism: path_four_bar,
  Editor,
  Requirement,
  Layer,
  handles: path_handles,
  with_clicked,
  stroke: stroke_drag,
  Numbers,
  Picture: Picture as Component<{id: string}>,
  plots: () => ["transmission", "path", "coupler", "output", "velocity", "advantage"],
};
