import ChainLayer from "./ChainLayer.svelte";
import {chain_handles} from "./chain_handles";
import Editor from "./Editor.svelte";
import SixBarLayer from "./SixBarLayer.svelte";
import type {TaskView} from "../view";

export const six_bar_view: TaskView = {
  Editor,
  Linkage: SixBarLayer,
  Layer: ChainLayer,
  handles: chain_handles,
  plots: () => ["transmission", "coupler", "path"],
};
