// What the parts of a task see of the drawing on which they are shown and taken hold of. The drawing gives it (Scene);
// kinds of tasks know no more of it than this.
import {getContext} from "svelte";
import type {Linkage, Mistake, Point, TaskAnswer} from "../contract/messages";
import type {TaskDocument} from "../state/document";
import type {Problem} from "../state/problem";
import type {Pose} from "../state/task";
import type {Toast} from "../state/toasts";
import type {Workbench} from "../state/workbench.svelte";
import type {TextKey, Values} from "../texts/texts.svelte";
import type {Drag} from "./drags/drag";
import type {Handle, Target} from "./handles";
import type {Guide, Keys} from "./snapping";
import type {Plane} from "./space";

/** What they read and change of the page's state. */
export interface Desk {
  readonly problem: Problem;
  readonly unit: string;
  readonly hand: Linkage | null;
  /** What is in hand where nothing is only pointed at. */
  readonly picked_linkage: Linkage | null;
  /** The engine's answer to the task. */
  readonly task: TaskAnswer | null;
  readonly refusal: readonly Mistake[] | null;
  /** What a press on the drawing does. */
  mode: Workbench["mode"];
  begin_gesture(): void;
  /** A change inside of a gesture. */
  drag(change: (problem: Problem) => Problem): void;
  drag_document(change: (document: TaskDocument) => TaskDocument): void;
  edit(change: (problem: Problem) => Problem, merge?: string | null): void;
  undo(): void;
  study<Study extends object>(name: string, make: (of: Workbench) => Study): Study;
  say(key: TextKey, values?: Values, action?: Toast["action"]): void;
}
/** Numbers beside the pointer. */
export interface Note {
  at: Point;
  text: string;
  /** Why it does not work here. */
  reason?: string | null;
}
export interface Surface {
  readonly workbench: Desk;
  readonly space: Plane;
  readonly poses: readonly Pose[];
  /** Where they lie. */
  readonly origins: readonly Point[];
  readonly handles: readonly Handle[];
  readonly hovered: Target | null;
  /** What is being dragged. */
  held: Target | null;
  /** Where a part of the task stood when it was pressed, if it stays there while it is dragged. */
  anchor: Point | null;
  guides: readonly Guide[];
  /** The view is the user's: it is not changed so that a linkage is seen. */
  touched: boolean;
  /** Numbers beside the pointer; without a reason of their own, with what the engine refuses. */
  tell(at: Point, text: string, reason?: string | null): void;
  /** Where a part of the task that was pressed there may go with linkages left: parts as the engine counts them. */
  show_halo(part: number, pressed: Pose): void;
  /** Ends or cancels one gesture, and takes away what only a drag shows. */
  finish(keep: boolean): void;
}

export const surface_key = Symbol("surface");
export function use_surface(): Surface {
  return getContext<Surface>(surface_key);
}

/** Whether a part of the task is held, or else under the pointer. */
export function is_lit({held, hovered}: Surface, part: string): boolean {
  const target = held ?? hovered;
  return target?.kind === "task" && target.part === part;
}
export function is_held({held}: Surface, part: string): boolean {
  return held?.kind === "task" && held.part === part;
}
interface PartDrag {
  cursor?: string;
  /** Where it stays while it is dragged. */
  anchor?: Point | null;
  move(at: Point, keys: Keys): void;
  ended?(kept: boolean): void;
}
/** A gesture on a part of the task. */
export function part_drag(
  surface: Surface,
  part: string,
  {cursor = "grabbing", anchor = null, move, ended}: PartDrag,
): Drag {
  surface.workbench.begin_gesture();
  surface.held = surface.handles.find(({target}) => target.kind === "task" && target.part === part)?.target ?? null;
  surface.anchor = anchor;
  const end = (keep: boolean) => {
    surface.finish(keep);
    ended?.(keep);
  };
  return {cursor, move, end: () => end(true), cancel: () => end(false)};
}
