import type {Workbench} from "../state/workbench.svelte";

/** The part of the page that draws in 3-D comes when it is first wanted: the server may be gone by then. */
export function say_not_loaded(workbench: Workbench): void {
  workbench.solid = false;
  workbench.say("state.solid_not_loaded", {}, {key: "state.try_again", run: () => void (workbench.solid = true)});
}
