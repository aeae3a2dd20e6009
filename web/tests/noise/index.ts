// An analysis that the page has never heard of: how loud a linkage is.
import type {AnalysisModule} from "../../src/analyses/analysis";
import type {RequirementKey} from "../../src/contract/messages";
import type {PropertyDescription} from "../../src/kinds/kind";
import {is_number, is_object} from "../../src/state/shape";

export interface Noise {
  rpm: number;
}
const noise_db: PropertyDescription = {
  text: "num.sweep",
  short: "num.sweep",
  term: null,
  needs: "noise",
  larger_is_better: false,
  requirement: "max_noise_db" as RequirementKey,
  quantity: "share",
  span: (_, __, problem) => [0, (problem as {noise?: Noise}).noise?.rpm ?? 1],
  levels: () => [],
};
const no_key = {name: "num.sweep", short: "num.sweep", term: null} as const;

export const noise: AnalysisModule<Noise> = {
  block: "noise",
  name: "num.sweep",
  term: "transmission_angle",
  read: (value) => (is_object(value) && is_number(value.rpm) ? {rpm: value.rpm} : null),
  fitted: (given, kind) => (kind.without_lengths ? null : given),
  has: (given, needs) => needs === "noise" || (needs === "speed" && given.rpm > 0),
  criteria: (kind) =>
    kind.without_lengths
      ? null
      : {
          properties: {
            noise_db,
          } as object,
          requirements: {
            max_noise_db: {...no_key, control: "limit", bound: "most", quantity: "ratio", from: 0, needs: "speed"},
          } as object,
          objectives: {noise: {name: "num.sweep", measure: "noise_db", needs: "noise"}} as object,
        },
  changed: () => [],
  cards: [{id: "noise", tab: "num.sweep"}],
  view: async () => (await import("./view")).noise_view,
};
