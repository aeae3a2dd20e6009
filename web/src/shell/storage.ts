// Work is kept in the browser between visits: what is on screen with its steps of undo, and what was there before a link or
// an example took its place. Each tab writes a slot of its own: one that hears another tab write its slot moves to a new one.
import {browser_store} from "../state/browser_store";
import {mapped, most_steps, read_steps, steps_text, type Steps} from "../state/steps";
import {from_problem, to_problem} from "../state/document";
import type {Problem} from "../state/problem";
import type {Workbench} from "../state/workbench.svelte";
import {without_picture} from "./share";

export type Store = Pick<Storage, "getItem" | "setItem" | "removeItem" | "key" | "length">;
export type Kept = Steps & {at: number};

const most_slots = 8; // of tabs that were open at the same time; the oldest are given up
const most_characters = 5_300_000; // no browser keeps more, and trying takes time
const work_key = "linkwright.work",
  before_key = "linkwright.before",
  damaged_key = "linkwright.damaged",
  session_key = "linkwright.slot";
/** A slot is "" or a dot and a name. */
const key = (start: string, slot: string) => start + slot;

function session_store(): Store | null {
  try {
    return globalThis.sessionStorage ?? null;
  } catch {
    return null;
  }
}

// ---- slots ----------------------------------------------------------------------------------------------------------

/** Slots with work in them, what was changed last first. */
function slots(store: Store | null): {slot: string; text: string}[] {
  if (!store) return [];
  const keys = Array.from({length: store.length}, (_, i) => store.key(i) ?? "").filter(
    (name) => name === work_key || name.startsWith(`${work_key}.`),
  );
  const all = keys.map((name) => ({slot: name.slice(work_key.length), text: store.getItem(name) ?? ""}));
  return all.sort((a, b) => time_of(b.text) - time_of(a.text));
}
/** Without reading all of it. */
function time_of(text: string): number {
  return Number(/^\{"version":1,"at":(\d+)/.exec(text)?.[1] ?? 0);
}
/** What other tabs have kept, or had when they were closed. */
export function other_work(slot: string, store: Store | null = browser_store()): Kept[] {
  return slots(store)
    .flatMap((other) => (other.slot === slot ? [] : [read_steps(other.text)]))
    .filter((kept) => kept !== null);
}
/** Where this tab writes: as before its reload, else where work was last written. */
export function own_slot(store: Store | null = browser_store(), session: Store | null = session_store()): string {
  const before = session?.getItem(session_key) ?? null,
    slot = before ?? slots(store)[0]?.slot ?? "";
  if (before === null) put(session, session_key, slot);
  return slot;
}
function new_slot(store: Store | null, session: Store | null): string {
  const slot = `.${Date.now().toString(36)}${Math.floor(Math.random() * 1e6).toString(36)}`;
  for (const {slot: old} of slots(store).slice(most_slots - 1)) {
    store?.removeItem(key(work_key, old));
    store?.removeItem(key(before_key, old));
  }
  put(session, session_key, slot);
  return slot;
}
function put(store: Pick<Store, "setItem"> | null, name: string, text: string): boolean {
  if (text.length > most_characters) return false;
  try {
    store?.setItem(name, text);
    return store !== null;
  } catch {
    return false; // full, or forbidden
  }
}

// ---- work -----------------------------------------------------------------------------------------------------------

export function read_work(slot: string, store: Store | null = browser_store()): Kept | null {
  const text = store?.getItem(key(work_key, slot)) ?? null,
    kept = read_steps(text);
  if (text !== null && !kept) put(store, damaged_key, text); // the next step would write over it
  return kept;
}
/** Work that could not be read: it stays until it is given out. */
export function damaged_work(store: Store | null = browser_store()): string | null {
  return store?.getItem(damaged_key) ?? null;
}
export function forget_damaged(store: Store | null = browser_store()): void {
  store?.removeItem(damaged_key);
}
/** Whether it is kept. What is too large for the store loses its oldest steps first, then the picture. */
export function write_work(
  slot: string,
  steps: Steps,
  store: Store | null = browser_store(),
  at = Date.now(),
): boolean {
  return (
    store !== null &&
    [steps, mapped(steps, without_picture)].some((kept) =>
      [most_steps, 50, 0].some((most) => put(store, key(work_key, slot), steps_text(kept, at, most))),
    )
  );
}
export function read_before(slot: string, store: Store | null = browser_store()): Problem | null {
  const kept = read_steps(store?.getItem(key(before_key, slot)) ?? null);
  return kept && to_problem(kept.present);
}
export function write_before(slot: string, problem: Problem, store: Store | null = browser_store()): boolean {
  const text = (part: Problem) => steps_text({past: [], present: from_problem(part), future: []}, Date.now());
  return [problem, without_picture(problem)].some((part) => put(store, key(before_key, slot), text(part)));
}

const rest_ms = 400;

/** Keeps the work from now on: soon after every step, and when the page goes. `since`: when it was last changed. Returns how
 *  to end it. */
export function keep_work(
  workbench: Workbench,
  since: number,
  store: Store | null = browser_store(),
  session: Store | null = session_store(),
): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined,
    changed = false,
    at = since;
  const write = () => {
    const kept = write_work(workbench.slot, workbench.steps, store, at);
    if (!kept && workbench.kept) workbench.say("state.storage_off");
    workbench.kept = kept;
  };
  const keep = () => {
    clearTimeout(timer);
    if (!changed) return;
    changed = false;
    write();
  };
  const heard = (event: StorageEvent) => {
    if (event.key !== key(work_key, workbench.slot) || event.newValue === null) return;
    workbench.slot = new_slot(store, session);
    changed = false;
    write(); // as old as it is: the other tab's is newer, perhaps
    workbench.say("state.other_tab");
  };
  const hidden = () => document.visibilityState === "hidden" && keep();
  workbench.on_commit(() => {
    changed = true;
    at = Date.now();
    clearTimeout(timer);
    timer = setTimeout(keep, rest_ms);
  });
  addEventListener("pagehide", keep);
  addEventListener("storage", heard);
  document.addEventListener("visibilitychange", hidden);
  return () => {
    keep();
    removeEventListener("pagehide", keep);
    removeEventListener("storage", heard);
    document.removeEventListener("visibilitychange", hidden);
  };
}
