import type {AnalysisModule} from "../analysis";
import {is_exact, limit_of, read_tolerances, type Tolerances} from "./block";
import {criteria} from "./criteria";
import type {Making} from "./making";

function fitted(tolerances: Tolerances, {lengths, limits}: Making): Tolerances {
  const fitting = {...tolerances},
    limit = limit_of(tolerances);
  if (lengths) delete fitting.link_angle_deg;
  else for (const key of ["length", "clearance", "turning_length"] as const) delete fitting[key];
  if (limit && !limits.includes(limit.kind)) delete fitting.limit;
  return fitting;
}

export const tolerances: AnalysisModule<Tolerances> = {
  block: "tolerances",
  name: "tolerance.row",
  term: "tolerance",
  read: read_tolerances,
  fitted(given, {analysed: {tolerances: making} = {}}) {
    const fitting = making && fitted(given, making);
    return fitting && !is_exact(fitting) ? fitting : null;
  },
  has: (given, needs) => needs === "tolerances" || (needs === "limit" && limit_of(given) !== null),
  criteria: ({analysed}) => (analysed?.tolerances ? criteria(analysed.tolerances) : null),
  changed: ({analysed}, {analysed: before}) =>
    analysed?.tolerances?.error === before?.tolerances?.error ? [] : ["max_tolerance_error"],
  cards: [
    {id: "tolerances", tab: "study.tab"},
    {id: "front", tab: "front.tab"},
  ],
  view: async () => (await import("./view")).tolerance_view,
};
