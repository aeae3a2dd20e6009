import type {Component} from "svelte";
import type {TaskView} from "../view";
import Editor from "./Editor.svelte";
import {straight_four_bar} from "./figure";
import FindsInTheMiddle from "./FindsInTheMiddle.svelte";
import {line_handles} from "./line_handles";
import LineLayer from "./LineLayer.svelte";
import Magnifier from "./Magnifier.svelte";
import Cognates from "./Cognates.svelte";
import Numbers from "./Numbers.svelte";
import Picture from "./Picture.svelte";
import {profile, speed} from "./profile";

export const straight_line_view: TaskView = {
  mechanism: straight_four_bar,
  Editor,
  Layer: LineLayer,
  Inset: Magnifier,
  Offer: FindsInTheMiddle,
  handles: line_handles,
  Numbers,
  NumbersBelow: Cognates,
  Picture: Picture as Component<{id: string}>,
  plots: () => [profile, speed, "transmission", "output"],
};
