// Work is kept in the browser between visits: what is on screen, and what was there before a link or an example took
// its place.
import {read_problem} from "../state/problem_shape";
import type {Problem} from "../state/problem";
import type {Workbench} from "../state/workbench.svelte";
import {without_picture} from "./share";

export type Slot = "work" | "before";
export type Store = Pick<Storage, "getItem" | "setItem">;

const key = (slot: Slot) => `linkwright.${slot}`;

/** Nothing where the browser keeps nothing. */
export function browser_store(): Store | null {
  try {
    return globalThis.localStorage ?? null;
  } catch {
    return null; // forbidden, as in some private windows
  }
}

export function read_work(slot: Slot, store: Store | null = browser_store()): Problem | null {
  try {
    const stored = JSON.parse(store?.getItem(key(slot)) ?? "null") as {version?: number; problem?: unknown} | null;
    return stored?.version === 1 ? read_problem(stored.problem) : null;
  } catch {
    return null; // a damaged entry is as good as none
  }
}
/** Whether it is kept. A picture that is too large for the store is left out rather than the work. */
export function write_work(slot: Slot, problem: Problem, store: Store | null = browser_store()): boolean {
  for (const part of [problem, without_picture(problem)]) {
    try {
      if (!store) return false;
      store.setItem(key(slot), JSON.stringify({version: 1, problem: part}));
      return true;
    } catch {
      // full: once more without the picture
    }
  }
  return false;
}

const rest_ms = 400;

/** Keeps the work from now on: soon after every step, and when the page goes. */
export function keep_work(workbench: Workbench, store: Store | null = browser_store()): void {
  let timer: ReturnType<typeof setTimeout> | undefined, changed = false;
  const keep = () => {
    clearTimeout(timer);
    if (!changed) return;
    changed = false;
    const kept = write_work("work", workbench.whole_problem, store);
    if (!kept && workbench.kept) workbench.say("state.storage_off");
    workbench.kept = kept;
  };
  workbench.on_commit(() => {
    changed = true;
    clearTimeout(timer);
    timer = setTimeout(keep, rest_ms);
  });
  addEventListener("pagehide", keep);
  document.addEventListener("visibilitychange", () => document.visibilityState === "hidden" && keep());
}
