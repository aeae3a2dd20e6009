import {afterEach, beforeEach, describe, expect, it, vi} from "vitest";
import {from_problem, to_problem} from "../state/document";
import {with_view, type Problem} from "../state/problem";
import {poses_of} from "../state/task";
import {Workbench} from "../state/workbench.svelte";
import {new_problem} from "../kinds/motion/kind";
import {
  damaged_work,
  forget_damaged,
  keep_work,
  other_work,
  own_slot,
  read_before,
  read_work,
  write_before,
  write_work,
  type Store,
} from "./storage";
import {with_pose} from "../kinds/kind_dispatch";

interface Items extends Store {
  items: Map<string, string>;
}
function store_of(most = 1e9, items = new Map<string, string>()): Items {
  return {
    items,
    get length() {
      return items.size;
    },
    key: (i) => [...items.keys()][i] ?? null,
    getItem: (key) => items.get(key) ?? null,
    removeItem: (key) => void items.delete(key),
    setItem(key, value) {
      if (value.length > most) throw new DOMException("full", "QuotaExceededError");
      items.set(key, value);
    },
  };
}
const problem: Problem = with_view(new_problem(), {
  picked: [0.5, 1.25],
  outline: [
    [0, 0],
    [2, 0],
    [1, 1],
  ],
  order: 3,
});
const steps = {past: [from_problem(new_problem())], present: from_problem(problem), future: []};

describe("the browser's store", () => {
  it("gives back what was kept, with its steps", async () => {
    const store = store_of();
    expect(await write_work("", steps, store, 5)).toBe(true);
    expect(read_work("", store)).toEqual({...steps, at: 5});
    expect(read_before("", store)).toBeNull();
    expect(await write_before("", problem, store)).toBe(true);
    expect(read_before("", store)).toEqual(problem);
  });
  it("gives up old steps, then the picture, where there is no room", async () => {
    const image = `data:image/png;base64,${"A".repeat(5000)}`,
      background = {image, x: 0, y: 0, width: 1, aspect: 1};
    const seen = {
      past: Array.from({length: 400}, (_, i) => from_problem(with_pose(problem, 0, {x: i}))),
      present: from_problem(with_view(problem, {background})),
      future: [],
    };
    const kept = async (room: number) => {
      const store = store_of(room),
        written = await write_work("", seen, store),
        {past, present} = read_work("", store) ?? {past: [], present: null};
      return [written, past.length, present?.problem.view?.background !== undefined && present !== null];
    };
    expect(await kept(1e9)).toEqual([true, 400, true]);
    expect(await kept(40_000)).toEqual([true, 50, true]);
    expect(await kept(7000)).toEqual([true, 0, true]);
    expect(await kept(4000)).toEqual([true, 0, false]);
    expect(await kept(10)).toEqual([false, 0, false]);
    expect(await write_work("", seen, null)).toBe(false);
  });
  it.each([
    "",
    "{",
    "null",
    "[]",
    '{"version": 1}',
    '{"version": 2, "problem": {}}',
    '{"version":1,"problem":{"linkwright":1,"task":{"kind":"motion","mechanism":"four_bar","poses":[{"x":null}]}}}',
  ])("takes a damaged entry for none, and puts it aside: %s", (text) => {
    const store = store_of();
    store.items.set("linkwright.work", text);
    expect(read_work("", store)).toBeNull();
    expect(damaged_work(store)).toBe(text);
    forget_damaged(store);
    expect(damaged_work(store)).toBeNull();
  });
  it("keeps all of a problem but what is malformed in it", () => {
    const store = store_of(),
      view = {...problem.view, traced: "x", pins: [{name: 7}]};
    const requirements = {
      types: 5,
      min_transmission_angle_deg: "steep",
      max_link_ratio: 7,
      ground_pivots_within: {x: [0]},
      min_length: "short",
      least_sweep: 0.1,
    };
    store.items.set(
      "linkwright.work",
      JSON.stringify({version: 1, problem: {...problem, requirements, options: {objective: "beauty", best: 3}, view}}),
    );
    const kept = to_problem(read_work("", store)!.present);
    expect(JSON.parse(JSON.stringify(kept))).toEqual({
      ...problem,
      requirements: {max_link_ratio: 7, least_sweep: 0.1},
      options: {best: 3},
    });
  });
});

describe("tabs", () => {
  interface Tab {
    workbench: Workbench;
    session: Items;
    end: () => void;
  }
  let store: Items, windows: EventTarget[], listening: EventTarget;
  beforeEach(() => {
    vi.useFakeTimers({now: 1e12});
    store = store_of();
    windows = [];
    vi.stubGlobal("document", Object.assign(new EventTarget(), {visibilityState: "visible"}));
    vi.stubGlobal("addEventListener", (name: string, run: EventListener) => listening.addEventListener(name, run));
    vi.stubGlobal("removeEventListener", () => {});
  });
  afterEach(() => {
    vi.useRealTimers();
    vi.unstubAllGlobals();
  });
  /** A tab with the store as the browser gives it: what one writes, all others hear. */
  function opened(session = store_of()): Tab {
    const window = (listening = new EventTarget());
    const own: Store = {
      ...store,
      get length() {
        return store.length;
      },
      setItem(key, value) {
        void store.setItem(key, value);
        for (const other of windows)
          if (other !== window) other.dispatchEvent(Object.assign(new Event("storage"), {key, newValue: value}));
      },
    };
    const slot = own_slot(own, session),
      kept = read_work(slot, own),
      workbench = new Workbench(kept ?? problem);
    workbench.slot = slot;
    const end = keep_work(workbench, kept?.at ?? 0, own, session);
    windows.push(window);
    return {
      workbench,
      session,
      end: () => {
        end();
        windows = windows.filter((other) => other !== window);
      },
    };
  }
  const x = ({workbench}: Tab) => poses_of(workbench.problem.task)[1]!.x;
  function move(tab: Tab, to: number): void {
    tab.workbench.edit((before) => with_pose(before, 1, {x: to}));
    vi.advanceTimersByTime(1000);
  }

  it("that are opened one after the other go on where the last left off, undo included", () => {
    const first = opened();
    move(first, 11);
    move(first, 12);
    first.end();
    const second = opened();
    expect(x(second)).toBe(12);
    second.workbench.undo();
    second.workbench.undo();
    expect(x(second)).toBe(-60);
    second.workbench.redo();
    vi.advanceTimersByTime(1000);
    second.end();
    const third = opened();
    expect(x(third)).toBe(11);
    expect([third.workbench.can_undo, third.workbench.can_redo]).toEqual([true, true]);
    third.workbench.redo();
    expect(x(third)).toBe(12);
  });
  it("keep what is in hand without a step, of work that there is", () => {
    const put = (tab: Tab, tau: [number, number]) => {
      tab.workbench.amend({picked: {tau, place: null}});
      vi.advanceTimersByTime(1000);
    };
    const first = opened(),
      {picked} = first.workbench;
    put(first, [0.1, 0.2]);
    first.end();
    const second = opened();
    expect(second.workbench.picked).toEqual(picked);
    move(second, 11);
    put(second, [0.3, 0.4]);
    second.end();
    expect(opened().workbench.picked?.tau).toEqual([0.3, 0.4]);
  });
  it("that are open together do not write over each other", () => {
    const one = opened();
    move(one, 21);
    const two = opened();
    move(two, 22);
    expect(one.workbench.toasts.map(({key}) => key)).toEqual(["state.other_tab"]);
    move(one, 23);
    move(two, 24);
    expect(one.workbench.slot).not.toBe(two.workbench.slot);
    expect(two.workbench.toasts).toEqual([]);
    one.end();
    two.end();
    const [again, other] = [opened(one.session), opened(two.session)]; // reloads
    expect([x(again), x(other)]).toEqual([23, 24]);
    expect(other_work(again.workbench.slot, store).map(({present}) => poses_of(present.problem.task)[1]!.x)).toEqual([
      24,
    ]);
  });
  it("leave the last change for the next visit, not the last tab that was heard of", () => {
    const idle = opened();
    move(idle, 31);
    const busy = opened();
    move(busy, 32); // the idle one moves to a slot of its own, as old as it is
    busy.end();
    idle.end();
    expect(x(opened())).toBe(32);
  });
  it("give up the oldest of many slots", () => {
    for (let i = 0; i < 12; ++i)
      store.items.set(`linkwright.work.${i}`, `{"version":1,"at":${i},"problem":${JSON.stringify(new_problem())}}`);
    const one = opened(),
      two = opened();
    move(one, 41);
    move(two, 42);
    expect(other_work("", store).length).toBeLessThanOrEqual(9);
    expect(store.items.has("linkwright.work.0")).toBe(false);
    expect([x(one), x(two)]).toEqual([41, 42]);
  });
});
