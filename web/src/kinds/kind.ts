// What a kind of task brings: the frame asks it through kind_dispatch.ts, its views through view_dispatch.ts, and knows none by name.
import type {
  Linkage,
  LinkageType,
  Pivot,
  Point,
  Property,
  RequirementKey,
  Requirements,
  TauPair,
} from "../contract/messages";
import type {End} from "../figure/figure";
import type {Orientation} from "../orientation/orientation";
import type {Objective, Pin, Problem} from "../state/problem";
import type {JsonObject} from "../state/shape";
import type {Pose, Task} from "../state/task";
import type {TermName} from "../terms/pictures";
import type {TextKey} from "../texts/texts.svelte";

/** Why the engine is not asked yet: `state` for the page, a sentence with {n} for people. */
export interface Incomplete {
  state: "empty" | "too_few" | "too_many" | "no_given" | "no_chain" | "to_be_sought";
  text: TextKey;
  n: number;
}
/** A new task to start from. */
export interface Beginning {
  id: string;
  name: TextKey;
  about: TextKey;
  make(): Problem;
  /** Of a guided body: its task through so many positions that there are already. */
  through?: {count: number; task(poses: readonly Pose[]): Task};
  /** Likewise through orientations: of at most so many. */
  turned?: {count: number; task(orientations: readonly Orientation[]): Task};
}
/** A distance between two joints of a body, in words; `color` is that of a part of the drawing (app.css). */
export interface NamedLength {
  key: string;
  name: string;
  /** In degrees where the joints' axes meet. */
  length: number;
  color: string | null;
  term?: TermName;
}
export interface NamedJoint {
  key: string;
  name: string;
  at: Pivot;
  on_ground: boolean;
  color: string;
  term?: TermName;
}
/** What analyses have to know of a kind's linkages, by their blocks: each adds what that is. */
export interface Analysed {
  [block: string]: object | undefined;
}
/** What a colour of the map stands for. `T`: the kind's tasks, here and below. */
export interface PropertyDescription<T extends Task = Task> {
  /** Not all of the kind's tasks have it. */
  is_of?(task: T): boolean;
  /** Of an analysis: what must be given of its block. */
  needs?: string;
  text: TextKey;
  short: TextKey;
  term: TermName | null;
  larger_is_better: boolean;
  /** Which limits it. */
  requirement: RequirementKey | null;
  /** A share is a number without a unit, from 0 up; an error a length, or told in degrees; forces and torques have a sense. */
  quantity: "angle" | "fine_angle" | "ratio" | "share" | "percent" | "length" | "error" | "force" | "torque";
  in_degrees?: boolean;
  /** Equal steps of the scale are equal ratios. */
  logarithmic?: boolean;
  /** Known of cells that meet everything only. */
  of_meeting?: boolean;
  /** By samples, cell by cell. */
  sampled?: boolean;
  /** What the scale bar spans. `typical`: a length of the task's size. */
  span(requirements: Requirements, typical: number, problem: Partial<Problem>): [number, number];
  /** Contour levels within the span. */
  levels(span: readonly [number, number]): number[];
}
interface NamedRequirement {
  /** Not all of the kind's tasks have it. */
  is_of?(task: Task): boolean;
  /** Of its row, and in sentences. */
  name: TextKey;
  short: TextKey;
  term: TermName | null;
}
/** What can be required of a linkage: by `control` how it is set, and with it what its value is. */
export type RequirementDescription = NamedRequirement &
  (
    | {control: "types" | "no_defects" | "transmission_angle"}
    | {
        control: "limit";
        bound: "least" | "most";
        quantity: "angle" | "ratio" | "length" | "percent" | "error" | "force" | "torque";
        in_degrees?: boolean;
        from: number;
        needs?: string;
      }
    /** Where pivots at these ends of the grounded links are to lie. */
    | {control: "box"; end: End}
    /** By the kind's own component (view.ts). */
    | {control: "own"; is_value(value: unknown): boolean}
  );
/** What linkages can be the best by. */
export interface ObjectiveDescription<T extends Task = Task> {
  name: TextKey;
  /** On the map. */
  measure: Property;
  is_of?(task: T): boolean;
  needs?: string;
}
/** Linkages at a place of the map. */
export interface AtPlace {
  all: readonly TauPair[];
  at: number;
}
/** All but the views. */
export interface TaskKind<T extends Task = Task> {
  name: TextKey;
  /** Nothing is sought: no linkage in hand, no map, nothing required, pinned or driven. */
  without_linkages?: true;
  /** The task is one linkage: it is in hand, there is no map, and nothing is required of it. */
  gives_linkage?: true;
  /** Its links are angles: there is no unit, no size and no ratio of them. */
  without_lengths?: true;
  /** The engine's normal form is another than what was typed, which the page keeps. */
  keeps_form?: true;
  is(task: Task): task is T;
  /** From outside; the engine says what is wrong with it in detail. */
  read(value: JsonObject): T | null;
  /** A body's poses and nothing else, as old pins and files of single linkages have them. */
  of_poses?(poses: unknown): T | null;
  /** Of another file of the program's, which holds what is one of its tasks. */
  of_file?(file: JsonObject): T | null;
  /** What the program reads, where that is not a problem file. */
  filed?(problem: Problem): object;
  /** With other poses, of a body that is guided; what does not go with them is left out. */
  with_poses?(task: T, poses: readonly Pose[]): T;
  /** Without options that do not go with the task. */
  fitting?(problem: Problem): Problem;
  /** Of a body that is turned: what another kind may take over. */
  orientations?(task: T): readonly Orientation[];
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
  /** In the order in which C walks through them. */
  properties: Partial<Record<Property, PropertyDescription<T>>>;
  /** What its linkages can be but degenerate, in the order of the legend. */
  types: readonly LinkageType[];
  /** In the order of the engine's bits. */
  requirements: Partial<Record<RequirementKey, RequirementDescription>>;
  /** In the order of the list to choose from. */
  objectives: Partial<Record<Objective, ObjectiveDescription<T>>>;
  analysed?: Analysed;
  /** Where the file is silent; none: the transmission angle. */
  default_objective?: Objective | ((task: T) => Objective);
  /** What is asked in its place while a hand moves, where its own answer would keep it waiting. */
  hurried?(problem: Problem): Problem;
  /** The fixed frame seen from elsewhere: points by `point`; poses are the frame's matter. */
  moved(task: T, point: (p: Point) => Point): T;
  /** What all its linkages are, a text's key, where it is the task that says so; otherwise a linkage is called by its type. */
  make_up?(task: T): TextKey | null;
  /** For the printed sheet. */
  table(task: T, unit: string): {head: string[]; rows: string[][]};
  beginnings: readonly Beginning[];
  /** What it says in place of a text of the frame. */
  texts?: Partial<Record<TextKey, TextKey>>;

  /** What a pin keeps of a linkage, to show it without the engine (Mechanism.ghost); else the ends of its grounded links. */
  kept_pivots?(linkage: Linkage): Pin["pivots"];
  /** The same of a linkage in a file of the program's. */
  filed_pivots?(linkage: JsonObject): Pin["pivots"];

  // Of a linkage, where it is one of this kind and not told like any four-bar; otherwise null.
  called?(linkage: Linkage): TextKey | null;
  term?(linkage: Linkage): TermName | null;
  /** All that stand at its place of the map, and which of them it is; null: it is the only one there may be. */
  at_place?(linkage: Linkage): AtPlace | null;
  lengths?(linkage: Linkage): NamedLength[] | null;
  joints?(linkage: Linkage): NamedJoint[] | null;
}
/** A kind with its views (view.ts), which are loaded before the page stands: what only computes does not hang on them. */
export interface TaskModule<T extends Task = Task> extends TaskKind<T> {
  view(): Promise<object>;
}
