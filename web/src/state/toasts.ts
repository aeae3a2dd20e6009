// Messages that come and go. Of one thing only the last is true, so it takes the place of what was said before; what is
// said of the document as it stands goes when the document changes.
import type {TextKey, Values} from "../texts/texts.svelte";

export interface Toast {
  id: number;
  key: TextKey;
  values: Values;
  action?: {key: TextKey; run: () => void};
}
type Subject = "linkage" | "engine" | "link" | "file" | "saved";

const subjects: Partial<Record<TextKey, Subject>> = {
  "state.went_to_best": "linkage",
  "state.nothing_to_go_to": "linkage",
  "state.cannot_improve": "linkage",
  "state.pinned": "linkage",
  "state.already_pinned": "linkage",
  "state.engine_stopped": "engine",
  "state.engine_gave_up": "engine",
  "state.link_copied": "link",
  "state.link_copied_no_picture": "link",
  "state.link_in_address": "link",
  "state.local_link": "link",
  "state.local_link_copied": "link",
  "state.link_too_long": "link",
  "file.opened": "file",
  "state.bad_file": "file",
  "state.huge_file": "file",
  "state.newer_file": "file",
  "state.bad_link": "file",
  "state.huge_link": "file",
  "state.newer_link": "file",
  "state.exported": "saved",
  "export.saved_mind": "saved",
};
const most_others = 2; // that stay beside a new one

export function with_toast(toasts: readonly Toast[], toast: Toast): Toast[] {
  const subject = ({key}: Toast) => subjects[key] ?? key;
  return [...toasts.filter((other) => subject(other) !== subject(toast)).slice(-most_others), toast];
}
/** What still holds after a change: nothing said of the linkage, and no offer to undo what is not the last step any more. */
export function after_change(toasts: readonly Toast[]): Toast[] {
  return toasts.filter(({key, action}) => subjects[key] !== "linkage" && action?.key !== "edit.undo");
}
