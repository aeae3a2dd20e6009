// Keeps what tolerances do to the linkage in hand up to it: to be called where the page begins.
import {untrack} from "svelte";
import type {Workbench} from "../state/workbench.svelte";

export function follow_tolerances(workbench: Workbench): void {
  $effect(() => {
    void [workbench.problem, workbench.hand, workbench.tau_in_hand, workbench.answers.hand_is_of_present];
    untrack(() => workbench.tolerance_study.follow());
  });
}
