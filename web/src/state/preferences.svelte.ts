// How this person likes to see things on this machine: kept between visits, not part of the task, not undoable.
import type {Property} from "../engine/protocol";

const key = "linkwright.preferences";

export class Preferences {
  language = $state<"en" | "zh">("en");
  theme = $state<"light" | "dark">("light");
  snap = $state(true);
  grid = $state(true);
  construction = $state(false); // poles, focus, asymptotes
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

  constructor() {
    if (typeof navigator === "undefined") return;
    if (navigator.language?.toLowerCase().startsWith("zh")) this.language = "zh";
    if (globalThis.matchMedia?.("(prefers-color-scheme: dark)").matches) this.theme = "dark";
    try {
      this.restore(JSON.parse(localStorage.getItem(key) ?? "{}"));
    } catch {
      // A private window or a damaged entry: the defaults stand.
    }
  }

  private names(): (keyof this & string)[] {
    return ["language", "theme", "snap", "grid", "construction", "contours", "defect_kinds", "only_meeting", "ridges",
      "colour_by", "speed", "repeat", "left_width", "right_width", "toured"] as (keyof this & string)[];
  }
  private restore(stored: Record<string, unknown>): void {
    for (const name of this.names()) {
      if (typeof stored[name] === typeof this[name]) this[name] = stored[name] as this[typeof name];
    }
  }
  /** To be called in an effect: reads every preference. */
  store(): void {
    const all = JSON.stringify(Object.fromEntries(this.names().map((name) => [name, this[name]])));
    try {
      localStorage.setItem(key, all);
    } catch {
      // Nothing can be kept here; the page says so once (shell/storage).
    }
  }
}

export const preferences = new Preferences();
