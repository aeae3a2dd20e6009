// What a field hears of what is edited: the engine's refusal, and that one has gone back or forth in the history.
import {getContext, setContext} from "svelte";
import type {Mistake} from "../contract/messages";

export interface Edited {
  refusal: Mistake[] | null;
  /** Counts the ways through the history: what was typed and not taken goes with them. */
  readonly moves: number;
  undo(): void;
}
const key = Symbol("edited");

export function provide_edited(edited: Edited): void {
  setContext(key, edited);
}
export function use_edited(): Edited {
  return getContext<Edited>(key);
}
