// What a kind of task shows and lets take hold of: the frame has a place for each.
import type {Component} from "svelte";
import type {Drag} from "../drawing/drags/drag";
import type {Handle} from "../drawing/handles";
import type {Surface} from "../drawing/surface";
import type {ExportFormat, Linkage, MachineFormat, Point, RequirementKey, Requirements} from "../contract/messages";
import type {Mechanism} from "../figure/mechanism";
import type {Problem} from "../state/problem";
import type {Task} from "../state/task";
import type {Workbench} from "../state/workbench.svelte";
import type {TextKey} from "../texts/texts.svelte";
import type {Dial, PlotChoice} from "../transport/plot";

export interface EditorProperties {
  /** A sentence about a field, or that there is nothing to say about it any more. */
  report: (place: string, sentence: string | null) => void;
}
/** A file of the task itself, where no linkage is sought. */
export interface TaskFile {
  format: string;
  name: TextKey;
  about: TextKey;
  /** What follows the title in its name. */
  ending: string;
  made(workbench: Workbench): Promise<Blob>;
}
export interface RequirementProperties {
  key: RequirementKey;
  /** What is in force. */
  requirements: Requirements;
  report: (sentence: string | null) => void;
}
export interface TaskView {
  /** How its linkages are put together, and so drawn everywhere: on the drawing, in small, in films and in 3-D. */
  mechanism: Mechanism;

  // ---- the drawing ----------------------------------------------------------------------------------------------

  /** In place of the drawing of the plane, for linkages that live elsewhere: with a space of its own (drawing/space). */
  Stage?: Component;
  /** On the drawing, above the linkage. */
  Layer?: Component;
  /** What can be taken hold of there, beside poses and pivots: handles whose target is a part of the task. */
  handles?(surface: Surface): Handle[];
  /** With what a click on the canvas adds to a task that lacks some of it; null: it lacks nothing. Of poses the frame does so. */
  with_clicked?(problem: Problem, at: Point): Problem | null;
  /** What a pointer does that is pressed on the drawing while one draws (the mode "draw"). */
  stroke?(surface: Surface, from: Point): Drag | null;
  /** Over the drawing: it places itself. */
  Inset?: Component;

  // ---- the panels -----------------------------------------------------------------------------------------------

  /** In the task panel. */
  Editor: Component<EditorProperties>;
  /** The control of what can be required in a way that no other kind has (kind.ts: "own"). */
  Requirement?: Component<RequirementProperties>;
  /** In place of the map of the solution region; null: there is none. */
  Region?: Component | null;
  /** Under the sentence that says why there is no map, or nothing wanted on it: ways on. */
  Offer?: Component;
  /** Beside the numbers of the linkage in hand. */
  Numbers?: Component<{hand: Linkage}>;
  /** Below what all linkages have. */
  NumbersBelow?: Component<{hand: Linkage}>;
  /** How plots count the driver's angle of a linkage, where not from position 1. */
  dial?(linkage: Linkage): Dial | null;
  /** The first one is shown first. */
  plots(task: Task): readonly [PlotChoice, ...PlotChoice[]];
  /** Files that there are not of its linkages, with the reason. */
  not_written?: Partial<Record<ExportFormat | MachineFormat, TextKey>>;
  /** Of the task itself, where no linkage is sought. */
  task_files?: readonly TaskFile[];
  /** What a new task is about, at a glance, on a field of 72 by 46: one to each of the kind's beginnings. */
  Picture: Component<{id: string}>;
}
