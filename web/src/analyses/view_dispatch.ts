// The views of analyses: those of a problem that has their block at once, the others when the page is at rest.
import {SvelteMap} from "svelte/reactivity";
import type {Linkage} from "../contract/messages";
import {later} from "../look/later.svelte";
import type {Problem} from "../state/problem";
import {given_analyses} from "./analysis_dispatch";
import type {AnalysisModule} from "./analysis";
import {analysis_modules} from "./registry";
import type {AnalysisView} from "./view";

const views = new SvelteMap<AnalysisModule, AnalysisView>();

async function load(analysis: AnalysisModule): Promise<void> {
  if (!views.has(analysis)) views.set(analysis, (await analysis.view()) as AnalysisView);
}
async function load_all(analyses: readonly AnalysisModule[]): Promise<void> {
  await Promise.all(analyses.map(load));
}
later(() => load_all(analysis_modules));
export async function load_given(problem: Problem): Promise<void> {
  await load_all(given_analyses(problem));
}
const loaded = (analyses: readonly AnalysisModule[]): AnalysisView[] => analyses.flatMap((one) => views.get(one) ?? []);
/** Reactive: what has come of those whose block is given. */
export function given_views(problem: Problem): AnalysisView[] {
  return loaded(given_analyses(problem));
}
/** What they say of a linkage in a line each. */
export function lines_of(problem: Problem, linkage: Linkage, unit: string): {text: string; but: string | null}[] {
  return given_views(problem).flatMap(({line}) => line?.(linkage, unit) ?? []);
}
/** Of the cards below the map, by their ids. */
export function given_cards(problem: Problem): AnalysisView["cards"] {
  return Object.assign({}, ...given_views(problem).map(({cards}) => cards)) as AnalysisView["cards"];
}
/** Reactive: what has come of that one. */
export function view_of(analysis: AnalysisModule): AnalysisView | null {
  return views.get(analysis) ?? null;
}
