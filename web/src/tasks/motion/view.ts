import {plot_kinds} from "../../transport/plot";
import type {TaskView} from "../view";
import Editor from "./Editor.svelte";

export const motion_view: TaskView = {Editor, plots: plot_kinds};
