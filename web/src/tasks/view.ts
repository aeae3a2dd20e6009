// What a kind of task shows and lets take hold of: the frame has a place for each.
import type {Component} from "svelte";
import type {Handle} from "../drawing/handles";
import type {Linkage} from "../engine/protocol";
import type {Task} from "../state/task";
import type {Scene} from "../drawing/scene.svelte";
import type {PlotChoice} from "../transport/plot";

export interface EditorProperties {
  /** A sentence about a field, or that there is nothing to say about it any more. */
  report: (place: string, sentence: string | null) => void;
}
export interface TaskView {
  /** In the task panel. */
  Editor: Component<EditorProperties>;
  /** Under the sentence that says why there is no map, or nothing wanted on it: ways on. */
  Offer?: Component;
  /** On the drawing, in place of a four-bar; its side links do not hang on the guided body alone. */
  Linkage?: Component;
  /** On the drawing, above the linkage. */
  Layer?: Component;
  /** What can be taken hold of on the drawing, beside poses and pivots: handles whose target is a part of the task. */
  handles?(scene: Scene): Handle[];
  /** Beside the numbers of the linkage in hand. */
  Numbers?: Component<{hand: Linkage}>;
  /** The first one is shown first. */
  plots(task: Task): readonly [PlotChoice, ...PlotChoice[]];
}
