// Work is kept in the browser between visits: what is on screen with its steps of undo, and what was there before a link or
// an example took its place. Each tab writes a slot of its own: one that hears another tab write its slot moves to a new one.
import {mapped, most_steps, read_steps, steps_text, type Steps} from "../state/steps";
import {from_problem, to_problem} from "../state/document";
import type {Problem} from "../state/problem";
import type {Workbench} from "../state/workbench.svelte";
import {without_picture} from "./share";
import {time_of, work_store, type Store} from "./work_store";

export type {Store} from "./work_store";
export type Kept = Steps & {at: number};

const most_slots = 8; // of tabs that were open at the same time; the oldest are given up
const most_characters = 5_300_000; // the small store keeps no more in any browser, and trying takes time
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
/** What other tabs have kept, or had when they were closed. */
export function other_work(slot: string, store: Store | null = work_store()): Kept[] {
  return slots(store)
    .flatMap((other) => (other.slot === slot ? [] : [read_steps(other.text)]))
    .filter((kept) => kept !== null);
}
/** Where this tab writes: as before its reload, else where work was last written. */
export function own_slot(store: Store | null = work_store(), session: Store | null = session_store()): string {
  const before = session?.getItem(session_key) ?? null,
    slot = before ?? slots(store)[0]?.slot ?? "";
  if (before === null) put_at_once(session, session_key, slot);
  return slot;
}
function new_slot(store: Store | null, session: Store | null): string {
  const slot = `.${Date.now().toString(36)}${Math.floor(Math.random() * 1e6).toString(36)}`;
  for (const {slot: old} of slots(store).slice(most_slots - 1)) {
    store?.removeItem(key(work_key, old));
    store?.removeItem(key(before_key, old));
  }
  put_at_once(session, session_key, slot);
  return slot;
}
async function put(store: Store | null, name: string, text: string): Promise<boolean> {
  if (text.length > (store?.most_characters ?? most_characters)) return false;
  try {
    await store?.setItem(name, text);
    return store !== null;
  } catch {
    return false; // full, or forbidden
  }
}
function put_at_once(store: Pick<Storage, "setItem"> | null, name: string, text: string): boolean {
  if (text.length > most_characters) return false;
  try {
    store?.setItem(name, text);
    return store !== null;
  } catch {
    return false;
  }
}

// ---- work -----------------------------------------------------------------------------------------------------------

export function read_work(slot: string, store: Store | null = work_store()): Kept | null {
  const text = store?.getItem(key(work_key, slot)) ?? null,
    kept = read_steps(text);
  if (text !== null && !kept) void put(store, damaged_key, text); // the next step would write over it
  return kept;
}
/** Work that could not be read: it stays until it is given out. */
export function damaged_work(store: Store | null = work_store()): string | null {
  return store?.getItem(damaged_key) ?? null;
}
export function forget_damaged(store: Store | null = work_store()): void {
  store?.removeItem(damaged_key);
}
/** What is too large for a store loses its oldest steps first, then the picture. */
function* ever_smaller(steps: Steps, at: number): Generator<string> {
  for (const kept of [steps, mapped(steps, without_picture)])
    for (const most of [most_steps, 50, 0]) yield steps_text(kept, at, most);
}
/** Whether it is kept. */
export async function write_work(
  slot: string,
  steps: Steps,
  store: Store | null = work_store(),
  at = Date.now(),
): Promise<boolean> {
  if (!store) return false;
  for (const text of ever_smaller(steps, at)) if (await put(store, key(work_key, slot), text)) return true;
  return false;
}
/** Before the page goes, perhaps sooner than the store has it. */
function write_at_once(slot: string, steps: Steps, {at_once}: Store, at: number): void {
  if (!at_once) return;
  for (const text of ever_smaller(steps, at)) if (put_at_once(at_once, key(work_key, slot), text)) return;
}
export function read_before(slot: string, store: Store | null = work_store()): Problem | null {
  const kept = read_steps(store?.getItem(key(before_key, slot)) ?? null);
  return kept && to_problem(kept.present);
}
export async function write_before(
  slot: string,
  problem: Problem,
  store: Store | null = work_store(),
): Promise<boolean> {
  for (const part of [problem, without_picture(problem)]) {
    const text = steps_text({past: [], present: from_problem(part), future: []}, Date.now());
    if (await put(store, key(before_key, slot), text)) return true;
  }
  return false;
}

const rest_ms = 400;

/** Keeps the work from now on: soon after every step, and when the page goes. `since`: when it was last changed. Returns how
 *  to end it. */
export function keep_work(
  workbench: Workbench,
  since: number,
  store: Store | null = work_store(),
  session: Store | null = session_store(),
): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined,
    changed = false,
    at = since;
  const write = async () => {
    const kept = await write_work(workbench.slot, workbench.steps, store, at);
    if (!kept && workbench.kept) workbench.say("state.storage_off");
    workbench.kept = kept;
  };
  const keep = () => {
    clearTimeout(timer);
    if (!changed) return;
    changed = false;
    void write();
  };
  const leave = () => {
    if (changed && store) write_at_once(workbench.slot, workbench.steps, store, at);
    keep();
  };
  const heard = (event: StorageEvent) => {
    if (event.key !== key(work_key, workbench.slot) || event.newValue === null) return;
    workbench.slot = new_slot(store, session);
    changed = false;
    void write(); // as old as it is: the other tab's is newer, perhaps
    workbench.say("state.other_tab");
  };
  const hidden = () => document.visibilityState === "hidden" && leave();
  const keep_soon = () => {
    changed = true;
    clearTimeout(timer);
    timer = setTimeout(keep, rest_ms);
  };
  // Not the user's change: his work is as old as it was, and none where there was none.
  workbench.on_amend(() => at > 0 && keep_soon());
  workbench.on_commit(() => {
    at = Date.now();
    keep_soon();
  });
  addEventListener("pagehide", leave);
  addEventListener("storage", heard);
  document.addEventListener("visibilitychange", hidden);
  return () => {
    keep();
    removeEventListener("pagehide", leave);
    removeEventListener("storage", heard);
    document.removeEventListener("visibilitychange", hidden);
  };
}
