import {IDBFactory, IDBObjectStore} from "fake-indexeddb";
import {afterEach, beforeEach, describe, expect, it, vi} from "vitest";
import {from_problem, to_problem} from "../state/document";
import {with_view, type Problem} from "../state/problem";
import {steps_text} from "../state/steps";
import {new_problem} from "../kinds/motion/kind";
import {own_slot, read_before, read_work, write_work} from "./storage";
import {open_work_store, type Store} from "./work_store";

/** localStorage as it is in a browser. */
function small_store(items: Record<string, string> = {}): Storage {
  const map = new Map(Object.entries(items));
  return {
    get length() {
      return map.size;
    },
    clear: () => map.clear(),
    key: (i) => [...map.keys()][i] ?? null,
    getItem: (name) => map.get(name) ?? null,
    removeItem: (name) => void map.delete(name),
    setItem: (name, text) => void map.set(name, text),
  };
}
const names = (store: Pick<Storage, "key" | "length">) =>
  Array.from({length: store.length}, (_, i) => store.key(i)).sort();
const problem = (title: string): Problem => ({...new_problem(), title});
const text = (title: string, at: number) =>
  steps_text({past: [from_problem(problem("before"))], present: from_problem(problem(title)), future: []}, at);
const title = (store: Store | null, slot = "") => read_work(slot, store)?.present.problem.title;

/** As in the browser: what one tab says, all others hear. */
class Channel {
  static all: Channel[] = [];
  onmessage: ((event: {data: unknown}) => void) | null = null;

  constructor() {
    Channel.all.push(this);
  }
  postMessage(data: unknown): void {
    for (const other of Channel.all) if (other !== this) other.onmessage?.({data});
  }
}
class FakeStorageEvent {
  readonly key: string | null = null;
  readonly newValue: string | null = null;
  constructor(
    readonly type: string,
    init: object,
  ) {
    Object.assign(this, init);
  }
}
let heard: (readonly [key: string | null, characters: number | undefined])[];

beforeEach(() => {
  Channel.all = [];
  heard = [];
  vi.stubGlobal("indexedDB", new IDBFactory());
  vi.stubGlobal("BroadcastChannel", Channel);
  vi.stubGlobal("StorageEvent", FakeStorageEvent);
  vi.stubGlobal("dispatchEvent", ({key, newValue}: FakeStorageEvent) => heard.push([key, newValue?.length]));
});
afterEach(() => {
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

describe("work of earlier versions of the page", () => {
  it("is opened and moved once, with its steps, what was there before, other tabs' and what was damaged", async () => {
    const small = small_store({
      "linkwright.preferences": "{}",
      "linkwright.work": text("Old", 7),
      "linkwright.work.tab": text("Other tab", 9),
      "linkwright.before": text("Replaced", 5),
      "linkwright.damaged": "{",
    });
    const store = await open_work_store(small);
    expect(title(store)).toBe("Old");
    expect(read_work("", store)).toMatchObject({at: 7, past: [{}]});
    expect(title(store, ".tab")).toBe("Other tab");
    expect(own_slot(store, small_store())).toBe(".tab"); // the last that was written
    expect(read_before("", store)?.title).toBe("Replaced");
    expect(store?.getItem("linkwright.damaged")).toBe("{");
    expect(names(small)).toEqual(["linkwright.preferences"]);

    const again = await open_work_store(small);
    expect(names(again!)).toEqual([
      "linkwright.before",
      "linkwright.damaged",
      "linkwright.work",
      "linkwright.work.tab",
    ]);
    expect(title(again)).toBe("Old");
  });
  it("does not take the place of newer work, and of what a page wrote as it went the newer counts", async () => {
    const first = await open_work_store(small_store());
    await first?.setItem("linkwright.work", text("Newer", 20));
    expect(title(await open_work_store(small_store({"linkwright.work": text("Older", 10)})))).toBe("Newer");
    const small = small_store({"linkwright.work": text("As it went", 30)});
    expect(title(await open_work_store(small))).toBe("As it went");
    expect(small.length).toBe(0);
    const amended = small_store({"linkwright.work": text("With another linkage in hand", 30)});
    expect(title(await open_work_store(amended))).toBe("With another linkage in hand");
  });
  it("stays where it is while the database has no room for it", async () => {
    vi.spyOn(IDBObjectStore.prototype, "put").mockImplementation(() => {
      throw new DOMException("full", "QuotaExceededError");
    });
    const small = small_store({"linkwright.work": text("Old", 7)});
    expect(title(await open_work_store(small))).toBe("Old");
    expect(names(small)).toEqual(["linkwright.work"]);
  });
});

describe("the database", () => {
  it("keeps what the small store has no room for", async () => {
    const image = `data:image/png;base64,${"A".repeat(6_000_000)}`,
      large = with_view(problem("Large"), {background: {image, x: 0, y: 0, width: 1, aspect: 1}});
    const steps = {past: [], present: from_problem(large), future: []};
    expect(await write_work("", steps, await open_work_store(small_store()))).toBe(true);
    const kept = read_work("", await open_work_store(small_store()));
    expect(kept && to_problem(kept.present).view?.background?.image).toHaveLength(image.length);
  });
  it("says that it is full, and that it keeps nothing where the browser keeps nothing", async () => {
    const store = await open_work_store(small_store()),
      steps = {past: [], present: from_problem(problem("Full")), future: []};
    const full = vi.spyOn(IDBObjectStore.prototype, "put").mockImplementation(() => {
      throw new DOMException("full", "QuotaExceededError");
    });
    expect(await write_work("", steps, store)).toBe(false);
    full.mockRestore();
    expect(await write_work("", steps, store)).toBe(true);
    vi.stubGlobal("indexedDB", undefined);
    expect(await open_work_store(null)).toBeNull();
  });
  it("gives way to the small store where it is forbidden or never answers", async () => {
    const small = small_store({"linkwright.work": text("Old", 7)});
    vi.stubGlobal("indexedDB", {
      open() {
        throw new DOMException("forbidden", "SecurityError");
      },
    });
    expect(await open_work_store(small)).toBe(small);
    vi.useFakeTimers();
    vi.stubGlobal("indexedDB", {open: () => ({})});
    const opening = open_work_store(small);
    await vi.advanceTimersByTimeAsync(4000);
    expect(await opening).toBe(small);
    vi.useRealTimers();
    expect(title(small)).toBe("Old");
  });
  it("tells other tabs what is written, and nobody who wrote it", async () => {
    const [one, two] = [await open_work_store(small_store()), await open_work_store(small_store())];
    const written = text("One", 1);
    await one?.setItem("linkwright.work", written);
    await vi.waitFor(() => expect(heard).toEqual([["linkwright.work", written.length]]));
    expect(title(two)).toBe("One");
    one?.removeItem("linkwright.work");
    await vi.waitFor(() => expect(two?.getItem("linkwright.work")).toBeNull());
  });
  it("has what a page wrote as it went taken out of the small store once it is written", async () => {
    const small = small_store(),
      store = await open_work_store(small);
    small.setItem("linkwright.work", text("Went", 5));
    const older = store?.setItem("linkwright.work", text("Older", 4)),
      newer = store?.setItem("linkwright.work", text("Went", 5));
    await older;
    expect(small.length).toBe(1);
    await newer;
    expect(small.length).toBe(0);
  });
});
