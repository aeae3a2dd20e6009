// What a kind of task brings, without its views (view.ts): the frame asks it through kinds.ts and knows none by name.
import type {Point, Property} from "../engine/protocol";
import type {Objective, Problem} from "../state/problem";
import type {Object} from "../state/shape";
import type {Task} from "../state/task";
import type {TextKey} from "../texts/texts.svelte";

/** Why the engine is not asked yet: `state` for the page, a sentence with {n} for people. */
export interface Incomplete {
  state: "empty" | "too_few" | "too_many" | "no_given" | "no_chain";
  text: TextKey;
  n: number;
}
/** A new task to start from. */
export interface Beginning {
  id: string;
  name: TextKey;
  about: TextKey;
  make(): Problem;
}
export interface TaskKind<T extends Task = Task> {
  name: TextKey;
  is(task: Task): task is T;
  /** From outside; the engine says what is wrong with it in detail. */
  read(value: Object): T | null;
  incompleteness(task: T): Incomplete | null;
  /** Where the drive is to stop: positions that lie apart. */
  stops(task: T): number;
  /** Positions, those infinitely close together counted each, in the field's notation: PP-P-P. */
  pattern(task: T): string;
  /** Whether something moves through a position in a prescribed direction. */
  is_mixed(task: T): boolean;
  /** Points of the fixed frame between which the task lies. */
  anchors(task: T): Point[];
  /** Points that are shown with them: of what is drawn about them. */
  around?(task: T): Point[];
  /** New tasks get a size limit (the best transmission angle alone is found next to links of many metres). */
  default_max_length(problem: Problem): number;
  /** What the map is of: a linkage keeps its place on the map from task to task only where this stays. */
  map_of(task: T): string;
  /** What the map's colours can stand for beside what they always can. */
  properties?(task: T): readonly Property[];
  /** The fixed frame seen from elsewhere: points by `point`; poses are the frame's matter. */
  moved(task: T, point: (p: Point) => Point): T;
  /** What a linkage can be the best by beside the usual. */
  objectives?(task: T): readonly Objective[];
  /** What all its linkages are, a text's key, where it is the task that says so; otherwise a linkage is called by its type. */
  make_up?(task: T): TextKey | null;
  /** For the printed sheet. */
  table(task: T, unit: string): {head: string[]; rows: string[][]};
  beginnings: readonly Beginning[];
  /** What it says in place of a text of the frame. */
  texts?: Partial<Record<TextKey, TextKey>>;
}
