import {getContext} from "svelte";
import type {Workbench} from "./workbench.svelte";

const key = Symbol("workbench");

/** Every view finds the one state here. */
export function context_of(workbench: Workbench): Map<symbol, Workbench> {
  return new Map([[key, workbench]]);
}
export function use_workbench(): Workbench {
  return getContext<Workbench>(key);
}
