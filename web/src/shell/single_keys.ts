// Keys that are one character (WCAG 2.1.4): who speaks to a computer, or hits keys by chance, can have them act in the
// drawing and on the map only, and none of them ever lands in a field as what it cannot be there.
import {preferences} from "../state/preferences.svelte";

type Press = Pick<KeyboardEvent, "key" | "ctrlKey" | "metaKey" | "altKey">;

export function is_single(press: Press): boolean {
  return press.key.length === 1 && press.key !== " " && !press.ctrlKey && !press.metaKey && !press.altKey;
}
/** Whether a key may act as a command with the focus there: in the drawing or on the map always. */
export function may_act(press: Press, focus: Element | null): boolean {
  return !is_single(press) || preferences.single_keys || focus?.closest("[data-single-keys]") != null;
}
/** Letters with which no number begins (π may: p). */
export function begins_no_number(press: Press): boolean {
  return is_single(press) && /^[a-oq-z?]$/i.test(press.key);
}
/** A field that nothing was typed into hands such a letter on to the page. */
export function handed_on(event: KeyboardEvent): void {
  const {key, shiftKey} = event;
  event.preventDefault();
  event.stopPropagation();
  document.body.dispatchEvent(new KeyboardEvent("keydown", {key, shiftKey, bubbles: true, cancelable: true}));
}
