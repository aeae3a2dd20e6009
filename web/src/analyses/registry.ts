// The analyses there are: a folder and a line to each.
import type {AnalysisModule} from "./analysis";
import {loads} from "./loads/index";
import {tolerances} from "./tolerances/index";

export const analysis_modules: readonly AnalysisModule[] = [tolerances, loads];
