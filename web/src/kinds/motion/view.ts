import {four_bar} from "../../figure/four_bar";
import {plot_kinds} from "../../transport/plot";
import type {TaskView} from "../view";
import Editor from "./Editor.svelte";
import {given_handles} from "./given_handles";
import Layer from "./Layer.svelte";
import Offer from "./Offer.svelte";
import Picture from "./Picture.svelte";

export const motion_view: TaskView = {
  mechanism: four_bar,
  Editor,
  Offer,
  Layer,
  handles: given_handles,
  Picture,
  plots: () => plot_kinds,
};
