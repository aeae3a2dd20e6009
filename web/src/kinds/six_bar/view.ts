import type {Component} from "svelte";
import type {TaskView} from "../view";
import ChainLayer from "./ChainLayer.svelte";
import {chain_handles} from "./chain_handles";
import Editor from "./Editor.svelte";
import {six_bar} from "./figure";
import Picture from "./Picture.svelte";

export const six_bar_view: TaskView = {
  mechanism: six_bar,
  Editor,
  Layer: ChainLayer,
  handles: chain_handles,
  Picture: Picture as Component<{id: string}>,
  plots: () => ["transmission", "coupler", "path"],
};
