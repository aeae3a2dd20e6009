import {plot_kinds} from "../../transport/plot";
import type {TaskView} from "../view";
import Editor from "./Editor.svelte";
import {given_handles} from "./given_handles";
import Layer from "./Layer.svelte";
import Offer from "./Offer.svelte";

export const motion_view: TaskView = {Editor, Offer, Layer, handles: given_handles, plots: () => plot_kinds};
