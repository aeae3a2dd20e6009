// The keys of the whole page, as one table: what they do and what the list of keys says of them. Keys that a view
// answers itself (map, drawing) stand in it without an action.
import {preferences} from "../state/preferences.svelte";
import type {Workbench} from "../state/workbench.svelte";
import type {TextKey} from "../texts/texts.svelte";
import {move_to, step} from "../transport/play";
import {pick_file, save_file} from "./files";
import {may_act} from "./single_keys";

export interface KeyEntry {
  /** Ways to say it: "Ctrl+Shift+Z", "Space", "P". Ctrl stands for ⌘ as well. */
  keys: readonly string[];
  text: TextKey;
  run?: (workbench: Workbench) => void;
  /** Also while a text is being edited: the browser's own meaning would lose work. */
  in_text?: boolean;
}
export interface KeyGroup {
  title: TextKey;
  entries: readonly KeyEntry[];
}

function turn(by: number): (workbench: Workbench) => void {
  return (workbench) => {
    workbench.playing = false;
    move_to(workbench, workbench.angle + by);
  };
}
function fill(what: "drawing" | "map"): (workbench: Workbench) => void {
  return (workbench) => (workbench.full = workbench.full === what ? "none" : what);
}

/** The innermost thing that is open or under way ends. */
export function escape(workbench: Workbench): void {
  const last_toast = workbench.toasts.at(-1);
  if (workbench.gesture) workbench.cancel_gesture();
  else if (workbench.mode !== "point") workbench.mode = "point";
  else if (workbench.tour !== null) end_tour(workbench);
  else if (workbench.sheet !== null) workbench.sheet = null;
  else if (workbench.full !== "none") workbench.full = "none";
  else if (workbench.selected_pose !== null) workbench.selected_pose = null;
  else if (last_toast) workbench.dismiss(last_toast.id);
}
export function end_tour(workbench: Workbench): void {
  workbench.tour = null;
  preferences.toured = true;
}

export const key_groups: readonly KeyGroup[] = [
  {
    title: "keys.page",
    entries: [
      {
        keys: ["Space"],
        text: "keys.play",
        run: (workbench) => (workbench.playing = !workbench.playing && workbench.hand?.drive != null),
      },
      {keys: ["→"], text: "keys.turn", run: turn(1)},
      {keys: ["←"], text: "keys.turn_back", run: turn(-1)},
      {keys: ["Shift+→"], text: "keys.next_position", run: (workbench) => step(workbench, 1)},
      {keys: ["Shift+←"], text: "keys.last_position", run: (workbench) => step(workbench, -1)},
      {keys: ["Ctrl+Z"], text: "edit.undo", run: (workbench) => workbench.undo()},
      {keys: ["Ctrl+Y", "Ctrl+Shift+Z"], text: "edit.redo", run: (workbench) => workbench.redo()},
      {keys: ["P"], text: "keys.pin", run: (workbench) => workbench.pin()},
      {keys: ["S"], text: "keys.snap", run: () => (preferences.snap = !preferences.snap)},
      {keys: ["F"], text: "keys.full_drawing", run: fill("drawing")},
      {keys: ["M"], text: "keys.full_map", run: fill("map")},
      {keys: ["Ctrl+S"], text: "file.save", run: save_file, in_text: true},
      {keys: ["Ctrl+P"], text: "export.print", run: (workbench) => (workbench.dialog = "print"), in_text: true},
      {keys: ["Ctrl+O"], text: "file.open", run: pick_file, in_text: true},
      {keys: ["Shift+F10"], text: "keys.row_menu"},
      {keys: ["Esc"], text: "keys.escape", run: escape},
      {keys: ["?"], text: "help.keys", run: (workbench) => (workbench.dialog = "keys")},
    ],
  },
  {
    title: "keys.drawing",
    entries: [
      {keys: ["0"], text: "view.fit"},
      {keys: ["1"], text: "keys.fit_body"},
      {keys: ["R"], text: "keys.box"},
      {keys: ["T"], text: "keys.trace"},
      {keys: ["I"], text: "drawing.instant"},
      {keys: ["Tab"], text: "keys.next_handle"},
      {keys: ["←", "↑", "↓", "→"], text: "keys.move_handle"},
      {keys: ["Shift"], text: "keys.drag_straight"},
      {keys: ["Alt"], text: "keys.drag_free"},
      {keys: ["Ctrl"], text: "keys.drag_fine"},
    ],
  },
  {
    title: "keys.map",
    entries: [
      {keys: ["←", "↑", "↓", "→"], text: "keys.cell"},
      {keys: ["Shift", "Alt"], text: "keys.cell_steps"},
      {keys: ["Enter"], text: "keys.pick"},
      {keys: ["X"], text: "region.swap"},
      {keys: ["B"], text: "region.best"},
      {keys: ["N", "Shift+N"], text: "keys.next_best"},
      {keys: ["L"], text: "keys.next_layer", run: (workbench) => workbench.pick_beside(1)},
      {keys: ["Shift+L"], text: "keys.last_layer", run: (workbench) => workbench.pick_beside(-1)},
      {keys: ["I"], text: "region.improve"},
      {keys: ["C"], text: "keys.colours"},
      {keys: ["H"], text: "keys.only_meeting"},
      {keys: ["+", "−", "0"], text: "keys.zoom"},
    ],
  },
];

const names: Record<string, string> = {Space: " ", "→": "ArrowRight", "←": "ArrowLeft", Esc: "Escape"};

type Press = Pick<KeyboardEvent, "key" | "ctrlKey" | "metaKey" | "shiftKey" | "altKey">;
/** Whether a key press is this key. A letter is one in any case; "?" is wherever the keyboard has it. */
export function is_key(press: Press, written: string): boolean {
  const parts = written.split("+"),
    key = parts.pop()!,
    name = names[key] ?? key;
  if ((press.ctrlKey || press.metaKey) !== parts.includes("Ctrl") || press.altKey) return false;
  if (name.length === 1 && !/[A-Z ]/i.test(name)) return press.key === name;
  return press.shiftKey === parts.includes("Shift") && press.key.toLowerCase() === name.toLowerCase();
}

const text_fields =
  "input:not([type=checkbox], [type=radio], [type=range], [type=button]), textarea, select, [contenteditable]";
const owns_keys: readonly (readonly [keys: RegExp, places: string])[] = [
  [
    /^( |Enter)$/,
    "button, a, summary, input, [role=button], [role=tab], [role=switch], [role=menuitem], [role=option]",
  ],
  [
    /^Arrow/,
    "input, [role=slider], [role=tab], [role=radio], [role=menu], [role=listbox], [role=separator], [role=application], [data-handle], .handle, table",
  ],
];
/** Whether what has the focus wants this key for itself. */
export function is_taken(press: Press, target: Element | null, in_text: boolean): boolean {
  if (!target) return false;
  if (target.closest(text_fields)) return !in_text;
  if (target.closest("[role=menu], dialog")) return true;
  return owns_keys.some(([keys, places]) => keys.test(press.key) && target.closest(places) !== null);
}

export function listen_to_keys(workbench: Workbench): () => void {
  const entries = key_groups.flatMap((group) => group.entries).filter((entry) => entry.run);
  const pressed = (event: KeyboardEvent) => {
    if (event.defaultPrevented || workbench.dialog !== null) return;
    const entry = entries.find(({keys}) => keys.some((key) => is_key(event, key)));
    if (!may_act(event, document.activeElement)) return;
    if (!entry || is_taken(event, event.target instanceof Element ? event.target : null, entry.in_text ?? false))
      return;
    event.preventDefault();
    entry.run!(workbench);
  };
  addEventListener("keydown", pressed);
  return () => removeEventListener("keydown", pressed);
}
