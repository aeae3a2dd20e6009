import {untrack} from "svelte";
import {preferences} from "../../state/preferences.svelte";
import {t} from "../../texts/texts.svelte";
import type {AnalysisView} from "../view";
import {tolerances_of} from "./block";
import PrintedTolerances from "./PrintedTolerances.svelte";
import SamplesLayer from "./SamplesLayer.svelte";
import SamplesLegend from "./SamplesLegend.svelte";
import SetLimit from "./SetLimit.svelte";
import {samples_picture} from "./sphere_samples";
import {tolerance_study_of} from "./study.svelte";
import ToleranceRow from "./ToleranceRow.svelte";
import {figures_text} from "./figure_words";

export const tolerance_view: AnalysisView = {
  follow(workbench) {
    void [workbench.problem, workbench.hand, workbench.tau_in_hand, workbench.answers.hand_is_of_present];
    untrack(() => tolerance_study_of(workbench).follow());
  },
  Block: ToleranceRow,
  missing: {limit: SetLimit},
  line({tolerance}, unit) {
    if (!tolerance) return null;
    return {text: figures_text(tolerance, unit), but: tolerance.beyond_first_order ? t("tolerance.beyond") : null};
  },
  cards: {
    tolerances: () => import("./ToleranceCard.svelte"),
    front: () => import("./FrontCard.svelte"),
  },
  Printed: PrintedTolerances,
  Layer: SamplesLayer,
  items(workbench) {
    const {of_hand, magnification} = tolerance_study_of(workbench);
    return preferences.samples && of_hand ? samples_picture(of_hand, magnification) : [];
  },
  Legend: SamplesLegend,
  has_legend: (workbench) => tolerance_study_of(workbench).found !== null,
  wants_legend: (workbench) => tolerance_study_of(workbench).magnification > 1,
  switches: [{name: "samples.show", by: "samples"}],
  in_picture(workbench) {
    const {of_hand, magnification} = tolerance_study_of(workbench);
    return preferences.samples && of_hand ? magnification : null;
  },
  may_be_in_picture: (problem) => preferences.samples && tolerances_of(problem) !== null,
};
