// How this person likes to see things on this machine: kept between visits, not part of the task, not undoable.
import type {Property} from "../contract/messages";
import {browser_store} from "./browser_store";
import {is_number, is_object} from "./shape";

const key = "linkwright.preferences";
export const speeds: readonly number[] = [0.5, 1, 2, 4];
export const decimal_choices: readonly number[] = [0, 1, 2, 3, 4, 6];

export class Preferences {
  language = $state<"en" | "zh">("en");
  theme = $state<"light" | "dark">("light");
  snap = $state(true);
  grid = $state(true);
  construction = $state(false); // poles, focus, asymptotes
  instant = $state(false); // pole, inflection circle, stationary curvature of the linkage as it stands
  plane_map = $state(true); // the map over the drawing, where its places are places of a pivot
  samples = $state(true); // linkages as they are made, where tolerances are given
  forces = $state(true); // arrows, where loads are given
  contours = $state(true);
  defect_kinds = $state(false);
  only_meeting = $state(false);
  ridges = $state(false);
  colour_by = $state<"type" | Property>("type");
  speed = $state(1);
  repeat = $state<"reverse" | "loop" | "once">("reverse");
  left_width = $state(268);
  right_width = $state(548);
  toured = $state(false);
  decimals = $state<number | null>(null); // of lengths and pivots; null: as their size has it

  /** Letters and digits act as commands wherever no text is being typed; off: only in the drawing and on the map. */
  single_keys = $state(true);
  private known: Stored = {}; // as it was read or last written

  constructor(private readonly store_of: () => Pick<Storage, "getItem" | "setItem"> | null = browser_store) {
    if (globalThis.navigator?.language?.toLowerCase().startsWith("zh")) this.language = "zh";
    if (globalThis.matchMedia?.("(prefers-color-scheme: dark)").matches) this.theme = "dark";
    this.restore();
  }
  /** Each stored value for itself: what is none of its kind leaves the default. */
  private restore(): void {
    const stored = this.stored();
    for (const name of names) if (checks[name](stored[name])) this.put(name, stored[name]);
    this.known = this.all();
  }
  private put<K extends Name>(name: K, value: unknown): void {
    (this as Record<K, unknown>)[name] = value;
  }
  private all(): Stored {
    return Object.fromEntries(names.map((name) => [name, this[name]]));
  }
  private stored(): Stored {
    try {
      const stored: unknown = JSON.parse(this.store_of()?.getItem(key) ?? "{}");
      return is_object(stored) ? stored : {};
    } catch {
      return {}; // a damaged entry is as good as none
    }
  }
  /** To be called in an effect: reads every preference. Writes those that have changed here: another tab may have changed others. */
  store(): void {
    const all = this.all(),
      changed = Object.entries(all).filter(([name, value]) => value !== this.known[name]);
    if (changed.length === 0) return;
    try {
      this.store_of()?.setItem(key, JSON.stringify({...this.stored(), ...Object.fromEntries(changed)}));
    } catch {
      // Nothing can be kept here; the page says so once (shell/storage).
    }
    this.known = all;
  }
}

type Name = keyof typeof checks;
type Stored = Record<string, unknown>;
const flag = (value: unknown) => typeof value === "boolean";
const one_of =
  (...values: unknown[]) =>
  (value: unknown) =>
    values.includes(value);
const width = (value: unknown) => is_number(value) && value >= 100 && value <= 10_000;
const checks = {
  language: one_of("en", "zh"),
  theme: one_of("light", "dark"),
  snap: flag,
  grid: flag,
  construction: flag,
  instant: flag,
  plane_map: flag,
  samples: flag,
  forces: flag,
  contours: flag,
  defect_kinds: flag,
  only_meeting: flag,
  ridges: flag,
  colour_by: (value: unknown) => typeof value === "string" && /^\w{1,60}$/.test(value), // kinds of tasks know which there are,
  speed: one_of(...speeds),
  repeat: one_of("reverse", "loop", "once"),
  left_width: width,
  right_width: width,
  toured: flag,
  decimals: one_of(null, ...decimal_choices),
  single_keys: flag,
} satisfies Record<string, (value: unknown) => boolean>;
const names = Object.keys(checks) as Name[];

export const preferences = new Preferences();
