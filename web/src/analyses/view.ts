// What an analysis shows: the frame has a place for each.
import type {Component} from "svelte";
import type {Linkage} from "../contract/messages";
import type {Handle} from "../drawing/handles";
import type {Surface} from "../drawing/surface";
import type {Configuration} from "../figure/mechanism";
import type {preferences} from "../state/preferences.svelte";
import type {Problem} from "../state/problem";
import type {Workbench} from "../state/workbench.svelte";
import type {Item} from "../sphere/item";
import type {TextKey} from "../texts/texts.svelte";

type Preferences = typeof preferences;
/** A preference that is on or off. */
export type Switch = {[Key in keyof Preferences]: boolean extends Preferences[Key] ? Key : never}[keyof Preferences];
export interface AnalysisView {
  /** Called where its questions may be other ones: reads what they are about. */
  follow?(workbench: Workbench): void;

  /** Among what is required: how its block is given. */
  Block: Component;
  /** In place of the control of a requirement that needs more of the block than is given, by what that is. */
  missing?: Readonly<Record<string, Component>>;
  /** Of a linkage in a line; `but`: why to be careful with it. */
  line?(linkage: Linkage, unit: string): {text: string; but: string | null} | null;
  /** Below the map, by the ids of the analysis. */
  cards: Readonly<Record<string, () => Promise<{default: Component}>>>;
  /** Among the numbers of the printed sheet. */
  Printed?: Component<{linkage: Linkage}>;

  // ---- the drawing ----------------------------------------------------------------------------------------------

  /** Under the linkage, in the plane and on the sphere. */
  Layer?: Component;
  items?(workbench: Workbench): Item[];
  /** What can be taken hold of there, in the plane; `now`: the linkage as it stands. */
  handles?(surface: Surface, now: Configuration | null): Handle[];
  /** What can be chosen of it there; `tells`: nothing else says what the picture shows. */
  Legend?: Component<{tells?: boolean}>;
  has_legend?(workbench: Workbench): boolean;
  /** On a phone the drawing has room for it only when asked. */
  wants_legend?(workbench: Workbench): boolean;
  /** Among what the drawing shows: switched by this. */
  switches?: readonly {name: TextKey; by: Switch}[];
  /** What a picture of the linkage in hand shows of it, told apart by this; null: nothing. */
  in_picture?(workbench: Workbench): unknown;
  /** Whether pictures of this problem's linkages may show something of it. */
  may_be_in_picture?(problem: Problem): boolean;
}
