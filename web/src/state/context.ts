import {getContext, setContext} from "svelte";
import type {Workbench} from "./workbench.svelte";

const key = Symbol("workbench");

/** Every view finds the one state here. */
export function provide_workbench(workbench: Workbench): Workbench {
  return setContext(key, workbench);
}
export function use_workbench(): Workbench {
  return getContext<Workbench>(key);
}
