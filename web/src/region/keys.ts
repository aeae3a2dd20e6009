// The map's keys.
import {whole} from "../contract/messages";
import {preferences} from "../state/preferences.svelte";
import {colorings_of} from "./property";
import type {RegionView} from "./view.svelte";

const arrows: Record<string, readonly [rows: number, columns: number]> = {
  ArrowUp: [1, 0],
  ArrowDown: [-1, 0],
  ArrowRight: [0, 1],
  ArrowLeft: [0, -1],
};
const zoom_step = 1.6;

/** Does what the key stands for; false if it stands for nothing here. `focused`: the map has the focus, and does not
 *  just lie under the pointer. */
export function map_key(event: KeyboardEvent, view: RegionView, focused: boolean): boolean {
  if (event.ctrlKey || event.metaKey) return false;
  const arrow = arrows[event.key];
  if (focused && arrow) {
    const [rows, columns] = arrow,
      cells = event.altKey ? 0.1 : event.shiftKey ? 10 : 1;
    view.step(rows * cells, columns * cells);
    return true;
  }
  if (event.altKey) return false;
  if (focused && event.key === "Enter") return pick(view);
  if (event.key === "Escape") return back(view);
  const command = commands[event.key.length === 1 ? event.key.toLowerCase() : event.key];
  if (!command) return false;
  command(view, event.shiftKey);
  return true;
}

function pick(view: RegionView): boolean {
  const {hovered} = view.workbench;
  if (hovered) view.workbench.pick(hovered);
  return hovered !== null;
}
function back(view: RegionView): boolean {
  if (!view.workbench.hovered) return false;
  view.leave();
  return true;
}
function zoom(view: RegionView, factor: number): void {
  view.zoom_at(view.hand_place ?? view.middle(), factor);
}
/** What is picked then is what one wants to see, wherever the pointer is. */
function jump(view: RegionView, to: () => unknown): void {
  to();
  view.leave();
}
const commands: Record<string, (view: RegionView, shift: boolean) => void> = {
  p: ({workbench}) => void (workbench.tau_in_hand && workbench.pin_at(workbench.tau_in_hand)),
  x: (view) => jump(view, () => view.workbench.swap_driver()),
  b: (view) => jump(view, () => view.workbench.pick_best()),
  n: (view, shift) => jump(view, () => view.workbench.pick_next_best(shift ? -1 : 1)),
  i: (view) => jump(view, () => view.workbench.improve()),
  c: ({workbench}) => {
    const colorings = colorings_of(workbench.problem);
    preferences.colour_by = colorings[(colorings.indexOf(workbench.coloring) + 1) % colorings.length] ?? "type";
  },
  h: () => (preferences.only_meeting = !preferences.only_meeting),
  "+": (view) => zoom(view, 1 / zoom_step),
  "=": (view) => zoom(view, 1 / zoom_step),
  "-": (view) => zoom(view, zoom_step),
  "0": ({workbench}) => workbench.zoom(whole),
};
