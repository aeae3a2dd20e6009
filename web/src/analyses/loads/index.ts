import type {AnalysisModule} from "../analysis";
import {has_of, read_loads, type Loads} from "./block";
import {criteria} from "./criteria";
import {moved_loads} from "./moved";

export const loads: AnalysisModule<Loads> = {
  block: "loads",
  name: "loads.row",
  term: "loads",
  read: read_loads,
  fitted: (given, {analysed}) => (analysed?.loads ? given : null),
  has: has_of,
  criteria: ({analysed}) => (analysed?.loads ? criteria : null),
  changed: () => [],
  moved: moved_loads,
  cards: [{id: "loads", tab: "loads.tab"}],
  view: async () => (await import("./view")).loads_view,
};
