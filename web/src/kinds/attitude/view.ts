import type {Component} from "svelte";
import {no_mechanism} from "../../figure/no_mechanism";
import type {TaskView} from "../view";
import Editor from "./Editor.svelte";
import Panel from "./Panel.svelte";
import {attitude_files} from "./files";
import Picture from "./Picture.svelte";
import Stage from "./Stage.svelte";

export const attitude_view: TaskView = {
  mechanism: no_mechanism,
  Stage,
  Region: Panel,
  Editor,
  Picture: Picture as Component<{id: string}>,
  task_files: attitude_files,
  plots: () => ["path"],
};
