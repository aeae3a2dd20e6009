import {plot_kinds} from "../../transport/plot";
import type {TaskView} from "../view";
import Editor from "./Editor.svelte";

export const function_view: TaskView = {Editor, plots: plot_kinds};
