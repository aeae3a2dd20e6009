// Where work is kept: the browser's database, which has room for pictures and all steps of undo. What is in it is read once,
// before the page is shown, and can then be asked for at once. Where there is no database, as in some private windows, the
// small store has to do.
import {createStore, delMany, entries, get, set, setMany, type UseStore} from "idb-keyval";
import {browser_store} from "../state/browser_store";

export interface Store extends Pick<Storage, "getItem" | "removeItem" | "key" | "length"> {
  /** Throws, at once or later, where there is no room. What was set can be read at once. */
  setItem(name: string, text: string): void | Promise<void>;
  /** Where a text is safe at once: the page may be gone before the database has it. */
  readonly at_once?: Pick<Storage, "setItem"> | null;
  /** Characters of one text that are tried. */
  readonly most_characters?: number;
}
const patience_ms = 3000,
  is_work = /^linkwright\.(work|before|damaged|task)(\.|$)/;

let opened: Store | null | undefined;
/** As `open_work_store` found it. */
export function work_store(): Store | null {
  return opened === undefined ? browser_store() : opened;
}
/** To be awaited before work is read. */
export async function open_work_store(small: Storage | null = browser_store()): Promise<Store | null> {
  let awaited = true;
  const never = new Promise<null>((resolve) => setTimeout(() => resolve(null), patience_ms)).then(() => {
    awaited = false;
    return null;
  });
  opened = (await Promise.race([in_database(small, () => awaited), never])) ?? small;
  return opened;
}
/** Once it is awaited no longer, the page has begun with the small store, of which nothing may go any more. */
async function in_database(small: Storage | null, is_awaited: () => boolean): Promise<Store | null> {
  try {
    const database = createStore("linkwright", "work"),
      items = new Map(await entries<string, string>(database));
    if (!is_awaited()) return null;
    if (small) await move_in(small, items, database, is_awaited);
    return new DatabaseStore(database, items, small);
  } catch {
    return null;
  }
}

/** When a text was written, without reading all of it; 0 where it does not say. */
export function time_of(text: string): number {
  return Number(/^\{"version":1,"at":(\d+)/.exec(text)?.[1] ?? 0);
}
/** What lies in the small store comes in, unless it is older: that of earlier versions of the page, and what was written
 *  there when a page went. Of the same time it is the later one: what is added to a step leaves its time as it is. */
async function move_in(
  small: Storage,
  items: Map<string, string>,
  database: UseStore,
  is_awaited: () => boolean,
): Promise<void> {
  const names = Array.from({length: small.length}, (_, i) => small.key(i) ?? "").filter((name) => is_work.test(name));
  const found = names.map((name) => [name, small.getItem(name) ?? ""] as const),
    newer = found.filter(([name, text]) => !items.has(name) || time_of(text) >= time_of(items.get(name) ?? ""));
  for (const [name, text] of newer) items.set(name, text);
  try {
    await setMany(
      [...newer].map(([name, text]): [string, string] => [name, text]),
      database,
    );
    if (is_awaited()) for (const [name] of found) small.removeItem(name);
  } catch {
    // There is no room for it: it stays where it is, and is in hand all the same.
  }
}

class DatabaseStore implements Store {
  readonly most_characters = 50_000_000;
  private readonly channel = new BroadcastChannel("linkwright.work");

  constructor(
    private readonly database: UseStore,
    private readonly items: Map<string, string>,
    readonly at_once: Storage | null,
  ) {
    this.channel.onmessage = ({data}: MessageEvent<string>) => void this.hear(data);
  }
  get length(): number {
    return this.items.size;
  }
  key(index: number): string | null {
    return [...this.items.keys()][index] ?? null;
  }
  getItem(name: string): string | null {
    return this.items.get(name) ?? null;
  }
  async setItem(name: string, text: string): Promise<void> {
    this.items.set(name, text);
    await set(name, text, this.database);
    this.channel.postMessage(name);
    if (this.items.get(name) === text) this.at_once?.removeItem(name); // else there may be something newer
  }
  removeItem(name: string): void {
    this.items.delete(name);
    this.at_once?.removeItem(name);
    void delMany([name], this.database).then(
      () => this.channel.postMessage(name),
      () => {},
    );
  }
  /** Another tab wrote: told as browsers tell it of the small store. */
  private async hear(name: string): Promise<void> {
    const text = await get<string>(name, this.database).catch(() => undefined);
    if (text === undefined) this.items.delete(name);
    else this.items.set(name, text);
    dispatchEvent(new StorageEvent("storage", {key: name, newValue: text ?? null}));
  }
}
