// What was last on screen, kept beside the work: who comes back sees his map before the engine is there. It is shown of the
// very question that it answers, by the very build of page and engine that kept it.
import {createStore, get, set} from "idb-keyval";
import {untrack} from "svelte";
import {code_urls} from "../engine/code";
import {whole} from "../contract/messages";
import {thinned, type StoredView} from "../engine/stored";
import {same_tau} from "../state/document";
import {engine_text} from "../state/problem";
import type {Workbench} from "../state/workbench.svelte";

export interface KeptView extends StoredView {
  build: string;
  question: string;
}
const name = "last",
  most_samples = 250,
  rest_ms = 1000,
  patience_ms = 300; // the frame is not kept waiting
const this_build = [import.meta.url, code_urls.first, code_urls.rest].join(" "); // their names tell their contents
const store = () => createStore("linkwright_view", "view");

/** What is on screen, if it is all of the present and can be shown again as it is. */
export function view_of(workbench: Workbench): KeptView | null {
  const {problem, picked, window, map, task, census, picked_linkage: linkage, live, answers, gesture} = workbench;
  if (gesture || window !== whole || !map || !task || !census || !linkage) return null;
  if (!answers.map_is_of_present || !answers.picked_is_of(problem) || !same_tau(linkage.tau, picked?.tau)) return null;
  const thin = {...thinned(map, most_samples), census};
  return {build: this_build, question: engine_text(problem), task, map: thin, linkage, live};
}
/** Of this document, or null. */
export function view_for({problem, picked}: Workbench, kept: KeptView | null): StoredView | null {
  if (kept?.build !== this_build || kept.question !== engine_text(problem)) return null;
  return same_tau(kept.linkage.tau, picked?.tau) ? {...kept, map: {...kept.map, window: whole}} : null;
}

/** Where there is no database, or no room in it, the next visit begins with the frame alone. */
export async function keep_view(view: KeptView): Promise<void> {
  await set(name, view, store()).catch(() => {});
}
export async function read_view(): Promise<KeptView | null> {
  return (await get<KeptView>(name, store()).catch(() => undefined)) ?? null;
}
/** What has been read before the page has to stand; null: it comes later, or not at all. */
export async function soon(reading: Promise<KeptView | null>): Promise<KeptView | null> {
  const later = new Promise<null>((resolve) => setTimeout(() => resolve(null), patience_ms));
  return Promise.race([reading, later]);
}
/** To be called where the page begins. */
export function keep_views(workbench: Workbench): void {
  $effect(() => {
    void [
      workbench.map,
      workbench.census,
      workbench.picked_linkage,
      workbench.live,
      workbench.picked,
      workbench.gesture,
    ];
    const waiting = setTimeout(() => {
      const view = untrack(() => view_of(workbench));
      if (view) void keep_view(view);
    }, rest_ms);
    return () => clearTimeout(waiting);
  });
}
