import type {TaskView} from "../view";
import Editor from "./Editor.svelte";
import {spherical_four_bar} from "./figure";
import Numbers from "./Numbers.svelte";
import Picture from "./Picture.svelte";
import Requirement from "./Requirement.svelte";
import Stage from "./Stage.svelte";

export const spherical_view: TaskView = {
  mechanism: spherical_four_bar,
  Stage,
  Editor,
  Requirement,
  Numbers,
  Picture,
  not_written: {dxf: "spherical.no_dxf", plates: "spherical.no_dxf"},
  plots: () => ["transmission", "output", "velocity", "advantage"],
};
