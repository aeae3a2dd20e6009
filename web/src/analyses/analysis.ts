// What an analysis of linkages brings: a block of the problem, and what can be asked of linkages once that is given. The
// frame asks it through analysis_dispatch.ts, its views through view_dispatch.ts, and knows none by name.
import type {Point, Property, RequirementKey} from "../contract/messages";
import type {Objective} from "../state/problem";
import type {ObjectiveDescription, PropertyDescription, RequirementDescription, TaskKind} from "../kinds/kind";
import type {TermName} from "../terms/pictures";
import type {TextKey} from "../texts/texts.svelte";

/** What the linkages of a kind can be coloured by, required to be and the best by. */
export interface Criteria {
  properties: Partial<Record<Property, PropertyDescription>>;
  requirements: Partial<Record<RequirementKey, RequirementDescription>>;
  objectives: Partial<Record<Objective, ObjectiveDescription>>;
}
type Named = {[K in RequirementKey]: `req.${K}` | `req.short.${K}` extends TextKey ? K : never}[RequirementKey];
type Limit = Extract<RequirementDescription, {control: "limit"}>;
/** Requirements of numbers, called by their keys. */
export function limits<K extends Named>(
  described: Record<K, Omit<Limit, "name" | "short" | "control">>,
): Record<K, RequirementDescription> {
  const named = (Object.keys(described) as K[]).map((key): [K, RequirementDescription] => [
    key,
    {...described[key], name: `req.${key}`, short: `req.short.${key}`, control: "limit"},
  ]);
  return Object.fromEntries(named) as Record<K, RequirementDescription>;
}
/** All but the views. `Block`: what a problem has of it. */
export interface Analysis<Block extends object = object> {
  /** The member of a problem in which that is. */
  block: string;
  name: TextKey;
  term: TermName;
  /** From outside, member by member; the engine says in detail what is wrong. */
  read(value: unknown): Block | null;
  /** What of it goes with linkages of this kind; null: nothing. */
  fitted(given: Block, kind: TaskKind): Block | null;
  /** Whether that is given which something `needs`: the block itself by its name, or more of it. */
  has(given: Block, needs: string): boolean;
  /** Null: it says nothing of linkages of this kind. */
  criteria(kind: TaskKind): Criteria | null;
  /** Requirements whose numbers mean something else of another kind. */
  changed(kind: TaskKind, before: TaskKind): readonly RequirementKey[];
  /** With the fixed frame seen from elsewhere: places by `move`; none: nothing of it lies there. */
  moved?(given: Block, move: (point: Point) => Point): Block;
  /** What it shows below the map, in place of the numbers. */
  cards: readonly {id: string; tab: TextKey}[];
}
/** An analysis with its views (view.ts), which are loaded when a problem has its block, or when the page is at rest. */
export interface AnalysisModule<Block extends object = object> extends Analysis<Block> {
  view(): Promise<object>;
}
