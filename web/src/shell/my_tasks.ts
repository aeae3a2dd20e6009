// The user's own tasks, as they were when others took their place: each with a picture, in the order of time. They lie
// beside the work of the tabs (storage.ts), in the same store.
import {deflateSync, inflateSync} from "fflate";
import type {Thumbnail} from "../engine/stored";
import {whole, type Linkage, type MapAnswer, type Pivot} from "../contract/messages";
import {examples} from "../gallery/gallery";
import {engine_text, type Problem} from "../state/problem";
import {read_problem} from "../state/problem_shape";
import {is_finite, is_object, type JsonObject} from "../state/shape";
import type {Workbench} from "../state/workbench.svelte";
import {joints_of} from "../kinds/kind_dispatch";
import {beginnings} from "./new_task";
import {without_picture} from "./share";
import {time_of, work_store, type Store} from "./work_store";

export interface OwnTask {
  key: string;
  /** When it was last worked on. */
  at: number;
  problem: Problem;
  picture: Thumbnail | null;
}
const start = "linkwright.task.",
  most = 60, // the oldest are given up
  picture_side = 64; // cells

// ---- pictures -------------------------------------------------------------------------------------------------------

type Packed = Omit<Thumbnail, "type" | "fails" | "title"> & {type: string; fails: string};

function packed(bytes: Uint8Array): string {
  return btoa(Array.from(deflateSync(bytes, {level: 9}), (byte) => String.fromCharCode(byte)).join(""));
}
function unpacked(text: unknown): Uint8Array<ArrayBuffer> {
  return inflateSync(Uint8Array.from(atob(String(text)), (c) => c.charCodeAt(0))) as Uint8Array<ArrayBuffer>;
}
/** Of a map as it is on screen and of the linkage in hand. */
export function picture_of(map: MapAnswer | null, linkage: Linkage | null): Thumbnail {
  const rows = map ? Math.min(map.rows, picture_side) : 0,
    columns = map ? Math.min(map.columns, picture_side) : 0,
    type = new Uint8Array(rows * columns),
    fails = new Uint32Array(rows * columns);
  for (let cell = 0; map && cell < type.length; ++cell) {
    const row = Math.floor(((Math.floor(cell / columns) + 0.5) * map.rows) / rows),
      column = Math.floor((((cell % columns) + 0.5) * map.columns) / columns);
    [type[cell], fails[cell]] = [map.type[row * map.columns + column]!, map.fails[row * map.columns + column]!];
  }
  return {title: "", rows, columns, type, fails, linkage: linkage && sketched(linkage)};
}
/** By its joints, as its kind sketches it. */
function sketched(linkage: Linkage): Thumbnail["linkage"] {
  const {tau, type, input, output} = linkage,
    own = joints_of(linkage)?.map(({at}) => at),
    pivots: readonly (Pivot | null)[] = own ?? [input.center, input.circle, output.center, output.circle];
  return pivots.includes(null) ? null : ({tau, type, pivots} as unknown as Thumbnail["linkage"]);
}
/** Four bytes to a cell; pictures kept by earlier pages have two. */
function unpacked_bits(bytes: Uint8Array<ArrayBuffer>, cells: number): Uint32Array {
  const {buffer} = bytes.slice();
  return bytes.length === 2 * cells ? Uint32Array.from(new Uint16Array(buffer)) : new Uint32Array(buffer);
}
function read_picture(value: unknown): Thumbnail | null {
  if (!is_object(value)) return null;
  const {rows, columns, linkage} = value as unknown as Packed;
  try {
    const type = unpacked(value.type),
      fails = unpacked_bits(unpacked(value.fails), type.length);
    if (type.length !== rows * columns || fails.length !== type.length) return null;
    return {title: "", rows, columns, type, fails, linkage: is_drawn(linkage) ? linkage : null};
  } catch {
    return null;
  }
}
function is_drawn(linkage: unknown): linkage is Thumbnail["linkage"] {
  return (
    is_object(linkage) &&
    Array.isArray(linkage.pivots) &&
    linkage.pivots.every((pivot) => Array.isArray(pivot) && pivot.every(is_finite))
  );
}

// ---- what is kept ---------------------------------------------------------------------------------------------------

function text_of({at, problem, picture}: Omit<OwnTask, "key">): string {
  const small: Packed | null = picture && {
    rows: picture.rows,
    columns: picture.columns,
    type: packed(picture.type),
    fails: packed(new Uint8Array(picture.fails.buffer)),
    linkage: picture.linkage,
  };
  return JSON.stringify({version: 1, at, problem, picture: small}); // `at` second: time_of reads no further
}
function read(key: string, text: string): OwnTask | null {
  try {
    const value = JSON.parse(text) as JsonObject,
      problem = read_problem(value.problem);
    return problem && {key, at: time_of(text), problem, picture: read_picture(value.picture)};
  } catch {
    return null;
  }
}
function keys(store: Store): string[] {
  const names = Array.from({length: store.length}, (_, i) => store.key(i) ?? "").filter((name) =>
    name.startsWith(start),
  );
  return names.sort((a, b) => time_of(store.getItem(b) ?? "") - time_of(store.getItem(a) ?? ""));
}
/** The last one first. */
export function my_tasks(store: Store | null = work_store()): OwnTask[] {
  return store ? keys(store).flatMap((key) => read(key, store.getItem(key) ?? "") ?? []) : [];
}
/** Whether it is nobody's own: an example or a beginning as it is. */
function is_known(problem: Problem): boolean {
  const asked = ({title: _, ...rest}: Problem) => engine_text(rest as Problem);
  return [...examples.map((example) => example.problem), ...beginnings.map(({make}) => make())].some(
    (known) => asked(known) === asked(problem),
  );
}
/** Keeps the work on the workbench among the user's own tasks, if it is his own. The same task is kept once. */
export async function keep_task(
  workbench: Workbench,
  store: Store | null = work_store(),
  at = Date.now(),
): Promise<void> {
  const {whole_problem, map, picked_linkage, answers} = workbench;
  if (!store || is_known(whole_problem)) return;
  const is_shown = answers.map_is_of_present && workbench.window === whole,
    problem = without_picture(whole_problem),
    linkage = answers.picked_is_of(workbench.problem) ? picked_linkage : null;
  const same = my_tasks(store).find((other) => engine_text(other.problem) === engine_text(problem));
  await put_task(
    {
      key: same?.key ?? `${start}${at.toString(36)}${Math.floor(Math.random() * 1e6).toString(36)}`,
      at,
      problem,
      picture: picture_of(is_shown ? map : null, linkage),
    },
    store,
  );
  for (const key of keys(store).slice(most)) store.removeItem(key);
}
export async function put_task(task: OwnTask, store: Store | null = work_store()): Promise<void> {
  try {
    await store?.setItem(task.key, text_of(task));
  } catch {
    // There is no room for it.
  }
}
export function remove_task({key}: OwnTask, store: Store | null = work_store()): void {
  store?.removeItem(key);
}
