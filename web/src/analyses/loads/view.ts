import {untrack} from "svelte";
import type {AnalysisView} from "../view";
import {load_handles} from "./load_handles";
import LoadRow from "./LoadRow.svelte";
import LoadsLayer from "./LoadsLayer.svelte";
import {place_handles} from "./place_handles";
import PrintedLoads from "./PrintedLoads.svelte";
import SetCrank from "./SetCrank.svelte";
import SetHandle from "./SetHandle.svelte";
import {load_study_of} from "./study.svelte";

export const loads_view: AnalysisView = {
  /** For the printed sheet; while its card is looked at that asks by itself. */
  follow(workbench) {
    const {dialog} = workbench;
    void [workbench.hand, workbench.tau_in_hand, workbench.driver_client];
    if (dialog === "export" || dialog === "print") untrack(() => load_study_of(workbench).follow());
  },
  Block: LoadRow,
  missing: {hand: SetHandle, crank: SetCrank},
  cards: {loads: () => import("./LoadCard.svelte")},
  Printed: PrintedLoads,
  Layer: LoadsLayer,
  handles: (surface, now) => [...load_handles(surface, now), ...place_handles(surface, now)],
  switches: [{name: "loads.show_forces", by: "forces"}],
};
