// What the component tests share: the whole page around a real workbench with the real engine, in the DOM of browser.ts;
// what a hand does to it, and what is to be read on it. Names are those of e2e/support.ts where they do the same.
import {createHash} from "node:crypto";
import {IDBFactory} from "fake-indexeddb";
import {flushSync, mount, tick, unmount} from "svelte";
import {expect, vi} from "vitest";
import App from "../../src/App.svelte";
import {film_choice, film_sizes} from "../../src/exports/film_form.svelte";
import {paper} from "../../src/exports/paper.svelte";
import {plate_choice} from "../../src/exports/plate_form.svelte";
import {read_view} from "../../src/shell/kept_view.svelte";
import {first_workbench} from "../../src/shell/start";
import {open_work_store} from "../../src/shell/work_store";
import {context_of} from "../../src/state/context";
import {Preferences, preferences} from "../../src/state/preferences.svelte";
import type {Problem} from "../../src/state/problem";
import {poses_of} from "../../src/state/task";
import type {Workbench} from "../../src/state/workbench.svelte";
import {driver} from "../../src/kinds/given_linkage/speed.svelte";
import {shown_cognate} from "../../src/kinds/straight_line/cognates.svelte";
import {load_view} from "../../src/kinds/view_dispatch";
import {end_threads} from "./thread";

// ---- the page -------------------------------------------------------------------------------------------------------

/** Of the page that is open. */
export let workbench: Workbench;
let page: object | null = null;
const complaints: string[] = [],
  no_webgl = /Error creating WebGL context/; // the page says so itself
const preference_names = Object.entries(Object.getOwnPropertyDescriptors(Preferences.prototype)).flatMap(
  ([name, {set}]) => (set ? [name] : []),
);

/** What a page keeps for one visit, in its modules: of others than tests each visit has its own. */
function begin_visit(): void {
  plate_choice.sizes = {};
  [film_choice.size, film_choice.rate] = [film_sizes[1], 30];
  paper.size = "A4";
  driver.rpm = 60;
  shown_cognate.index = null;
}
/** Opens the page as main.ts does. */
export async function open_workbench(): Promise<void> {
  begin_visit();
  await open_work_store();
  workbench = first_workbench(await read_view());
  await load_view(workbench.problem.task);
  document.body.innerHTML = '<div id="app"></div>';
  const target = document.getElementById("app")!;
  hear_of_changes(target);
  page = mount(App, {target, context: context_of(workbench)});
  await until(() => workbench.engine_state === "ready");
}
/** Opens it, and waits until all of it is that of the first example. */
export async function open_settled(): Promise<void> {
  await open_workbench();
  await until_settled();
}
/** Opens an example by the menu, once the page has settled. */
export async function open_example(name: string): Promise<void> {
  await open_settled();
  await file_menu("file.examples");
  await click(`example.${name}`);
  await until_settled();
}
/** Makes a new task by the dialog. */
export async function begin(kind: string): Promise<void> {
  await click("bar.new");
  await click(`new.${kind}`);
  await click("new.create");
}
/** What an address given out by somebody else would open, without the address. */
export async function open_problem(problem: Problem): Promise<void> {
  workbench.open(problem);
  await until_settled();
}
async function close(): Promise<void> {
  if (!page) return;
  dispatchEvent(new Event("pagehide"));
  await unmount(page);
  const clients = [workbench.engine, workbench.driver_client];
  await until(() => !clients.some((client) => client?.busy)); // nobody hears any more that there is no answer
  for (const client of clients) client?.close();
  end_threads();
  page = null;
  await open_work_store(); // once what it was about to keep is kept
}
/** Leaves the page and comes back. */
export async function reload(): Promise<void> {
  await close();
  await open_workbench();
}

/** What hooks.ts does before each test. */
export function begin_test(): void {
  const fresh = new Preferences(() => null);
  for (const name of preference_names)
    (preferences as unknown as Record<string, unknown>)[name] = fresh[name as keyof Preferences];
  Object.assign(preferences, {toured: true, language: "en", theme: "light"});
  for (const level of ["error", "warn"] as const)
    vi.spyOn(console, level).mockImplementation((...words) => {
      if (!no_webgl.test(words.join(" "))) complaints.push(words.join(" "));
    });
}
/** And after each: nothing is left of it. */
export async function end_test(): Promise<void> {
  await close();
  localStorage.clear();
  sessionStorage.clear();
  globalThis.indexedDB = new IDBFactory();
  vi.restoreAllMocks();
  expect(complaints.splice(0), "complaints of the page").toEqual([]);
}

/** Removes the complaints that were expected; there must be some. */
export function expect_and_forget(pattern: RegExp): void {
  const left = complaints.filter((complaint) => !pattern.test(complaint));
  expect(left.length, `a complaint like ${pattern}`).toBeLessThan(complaints.length);
  complaints.splice(0, complaints.length, ...left);
}

/** Waits for a state of the page, however busy the machine is. */
export async function until(what: () => unknown, told = () => String(what)): Promise<void> {
  const end = performance.now() + 120_000;
  while (!what()) {
    if (performance.now() > end) throw new Error(`never: ${told()}`);
    await new Promise((resolve) => setTimeout(resolve, 1));
  }
  await drawn();
}
export const until_there = (name: string): Promise<void> => until(() => is_there(name));
/** All is that of the problem as it is, and nothing more will come by itself but what is finer. */
export async function until_settled(): Promise<void> {
  await until(() => {
    const {is_current, census, hand, tau_in_hand, questions} = workbench;
    return is_current && census && questions.settled() && hand?.tau.join() === tau_in_hand?.join();
  });
}
/** The map and its counts are of the problem as it is. */
export async function until_mapped(): Promise<void> {
  await until(() => workbench.is_current && workbench.census && workbench.questions.settled());
}
/** What has changed stands on the page. */
async function drawn(): Promise<void> {
  await tick();
  flushSync();
}

// ---- what is on it --------------------------------------------------------------------------------------------------

export function all(name: string): HTMLElement[] {
  return [...document.querySelectorAll<HTMLElement>(`[data-testid="${name}"]`)];
}
/** The one that has this name; it must be there. */
export function get<E extends Element = HTMLElement>(name: string): E {
  const [found, ...others] = all(name);
  if (!found || others.length > 0) throw new Error(`${found ? 1 + others.length : "none"} of ${name}`);
  return found as unknown as E;
}
export const field = (name: string): HTMLInputElement => get<HTMLInputElement>(name);
export const value_of = (name: string): string => field(name).value;
export const focused = (): string | null => document.activeElement?.getAttribute("data-testid") ?? null;
export const is_there = (name: string): boolean => all(name).length > 0;
const words = (text: string | null | undefined): string => (text ?? "").replace(/\s+/g, " ").trim();
/** What stands there, with single spaces. */
export const text = (name: string): string => words(get(name).textContent);
export const texts = (selector: string): string[] =>
  [...document.querySelectorAll(selector)].map(({textContent}) => words(textContent));
export const faults = (): string => texts("[data-testid='task.fault']").join("\n");
export const toasts = (): string => texts("[data-testid='toast.title']").join("\n");
/** What `read` finds in the page's state. */
export const read_state = <T>(read: (of: Workbench) => T): T => read(workbench);
export const poses_of_page = () => poses_of(workbench.problem.task);

/** What is on screen, by what it is drawn from. */
export function shown(): {map: string; picked: string; pins: string; poses: string} {
  const {map, picked, pins} = workbench;
  return {
    map: createHash("md5").update(map!.type).update(map!.defects).update(map!.fails).digest("hex"),
    picked: picked!.tau.join(),
    pins: JSON.stringify(pins.map(({name, note, tau}) => [name, note, tau])),
    poses: JSON.stringify(poses_of_page()),
  };
}

// ---- what a hand does -----------------------------------------------------------------------------------------------

type At = string | Element;
const at = (place: At): Element => (typeof place === "string" ? get(place) : place);

export async function send(place: At, event: Event): Promise<boolean> {
  const taken = at(place).dispatchEvent(event);
  await drawn();
  return taken;
}
/** Clicks as soon as there is something to be clicked. */
export async function click(place: At, keys: MouseEventInit = {}): Promise<void> {
  const found = () => (typeof place === "string" ? all(place)[0] : place) as HTMLButtonElement | undefined;
  await until(
    () => found() && !found()!.disabled,
    () => `${String(place)} can be clicked; it is ${found()?.outerHTML ?? "not there"}`,
  );
  const element = at(place) as HTMLButtonElement;
  element.focus?.();
  const was = {...keys, bubbles: true, cancelable: true};
  for (const kind of ["pointerdown", "pointerup"]) element.dispatchEvent(new PointerEvent(kind, was));
  await send(element, new PointerEvent("click", was));
}
export async function focus(name: string): Promise<void> {
  get(name).focus();
  await drawn();
}
export async function choose(name: string, option: string): Promise<void> {
  const list = get<HTMLSelectElement>(name);
  if (![...list.options].some((one) => one.value === option)) throw new Error(`${name} has no ${option}`);
  list.value = option;
  await send(list, new Event("change", {bubbles: true}));
}
export async function file_menu(item: string): Promise<void> {
  await click("file.menu");
  await click(item);
}
/** Puts it in place of what is in a field. */
export async function fill(name: string, typed: string): Promise<void> {
  get(name).focus();
  field(name).value = typed;
  await send(name, new InputEvent("input", {bubbles: true}));
}
export async function type_into(name: string, typed: string, key = "Enter"): Promise<void> {
  await fill(name, typed);
  await press(key);
}
export async function paste_into(name: string, pasted: string): Promise<void> {
  get(name).focus();
  const clipboardData = new DataTransfer();
  clipboardData.setData("text/plain", pasted);
  await send(name, new ClipboardEvent("paste", {clipboardData, bubbles: true, cancelable: true}));
}

/** A key where the focus is, as "Control+Shift+z", with what browsers do about it by themselves. */
export async function press(written: string): Promise<void> {
  const parts = written.split("+"),
    key = parts.pop() || "+",
    active = document.activeElement,
    focused = active?.isConnected ? active : document.body;
  const [ctrlKey, shiftKey, altKey] = ["Control", "Shift", "Alt"].map((name) => parts.includes(name));
  const init = {key, ctrlKey, shiftKey, altKey, bubbles: true, cancelable: true};
  if (focused.dispatchEvent(new KeyboardEvent("keydown", init))) by_itself(key, focused as HTMLElement, init.shiftKey!);
  focused.dispatchEvent(new KeyboardEvent("keyup", init));
  await drawn();
}
function by_itself(key: string, focused: HTMLElement, back: boolean): void {
  if (key === "Tab") next_stop(focused, back)?.focus();
  else if (key === "Escape") document.querySelector("dialog[open]")?.dispatchEvent(new Event("cancel"));
  else if (key === "Enter" && focused instanceof HTMLInputElement) said_changed(focused);
  else if ((key === "Enter" || key === " ") && focused instanceof HTMLButtonElement) focused.click();
}
/** Where Tab leads to. */
function next_stop(focused: HTMLElement, back: boolean): HTMLElement | undefined {
  const all = [...document.querySelectorAll<HTMLElement>("a[href], button, input, select, textarea, [tabindex]")],
    stops = all.filter((stop) => stop === focused || (stop.tabIndex >= 0 && !(stop as HTMLButtonElement).disabled));
  return stops[stops.indexOf(focused) + (back ? -1 : 1)];
}

/** Drops a file on the page. */
export async function drop(name: string, content: string, place: At = document.body): Promise<void> {
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(new File([content], name));
  Object.defineProperty(dataTransfer, "types", {value: ["Files"]});
  for (const kind of ["dragover", "drop"])
    await send(place, Object.assign(new Event(kind, {bubbles: true, cancelable: true}), {dataTransfer}));
}
export async function go_to(hash: string): Promise<void> {
  location.hash = hash;
  await send(document.body, new Event("hashchange", {bubbles: true}));
}
export async function move_a_pose(x = -222): Promise<void> {
  await type_into("task.x.3", String(x));
}
/** Plays to the end of the travel: the poses that lit up on the way. */
export async function played_poses(): Promise<number[]> {
  const passed: number[] = [],
    {get: read, set: write} = Object.getOwnPropertyDescriptor(Object.getPrototypeOf(workbench), "lit_pose")!;
  Object.defineProperty(workbench, "lit_pose", {
    get: () => read!.call(workbench),
    set(pose: number | null) {
      if (pose !== null) passed.push(pose);
      write!.call(workbench, pose);
    },
  });
  await click("drive.play");
  await until(() => !workbench.playing);
  return passed;
}
export const copied = (): Promise<string> => navigator.clipboard.readText();
/** What the browser would save of what is done: its name and what is in it. */
export async function download(act: () => Promise<void>): Promise<{name: string; bytes: Buffer}> {
  let saved: {name: string; blob: Blob} | null = null;
  const blobs = vi.spyOn(URL, "createObjectURL"),
    links = vi.spyOn(HTMLAnchorElement.prototype, "click").mockImplementation(function (this: HTMLAnchorElement) {
      saved = {name: this.download, blob: blobs.mock.lastCall![0] as Blob};
    });
  await act();
  await until(() => saved);
  for (const spy of [blobs, links]) spy.mockRestore();
  const {name, blob} = saved!;
  return {name, bytes: Buffer.from(await blob.arrayBuffer())};
}
/** Gives a file to the chooser that opens with what is done. */
export async function choose_file(name: string, content: string | Buffer, act: () => Promise<void>): Promise<void> {
  const chosen = vi.spyOn(HTMLInputElement.prototype, "click").mockImplementation(function (this: HTMLInputElement) {
    void give_file(this, name, content);
  });
  await act();
  chosen.mockRestore();
}
export async function give_file(input: At, name: string, content: string | Buffer): Promise<void> {
  const file = new File([content as BlobPart], name);
  Object.defineProperty(at(input), "files", {configurable: true, value: [file]});
  await send(input, new Event("change", {bubbles: true}));
}
/** Opens a file, and waits until the page has said what it is. */
export async function open_files(name: string, content: string | Buffer): Promise<void> {
  const said = workbench.toasts.at(-1);
  await choose_file(name, content, () => file_menu("file.open"));
  await until(() => workbench.toasts.length > 0 && workbench.toasts.at(-1) !== said);
}

const told = new WeakMap<Element, string>();
function hear_of_changes(page: HTMLElement): void {
  page.addEventListener("focusin", ({target}) => told.set(target as Element, (target as HTMLInputElement).value));
  page.addEventListener("focusout", ({target}) => target instanceof HTMLInputElement && said_changed(target));
}
/** A text that was typed is told as a change when the field is left, or by Enter. */
function said_changed(typed: HTMLInputElement): void {
  if (told.get(typed) === typed.value) return;
  told.set(typed, typed.value);
  typed.dispatchEvent(new Event("change", {bubbles: true}));
}
