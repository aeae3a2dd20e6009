import {plot_kinds} from "../../transport/plot";
import Editor from "./Editor.svelte";
import type {TaskView} from "../view";

export const six_bar_view: TaskView = {Editor, plots: () => plot_kinds};
