// What of its linkages each kind of task makes with tolerances, and how their errors are told.
import type {TextKey} from "../../texts/texts.svelte";
import type {LengthEntry, LimitKind} from "./block";

export interface Making {
  /** Lengths that have tolerances, by name; null: links are arcs, whose angles have one. */
  lengths: Partial<Record<LengthEntry, TextKey>> | null;
  error: "length" | "angle";
  /** That a linkage can be held to; the usual one first. */
  limits: readonly LimitKind[];
}
declare module "../../kinds/kind" {
  interface Analysed {
    tolerances?: Making;
  }
}

const links = {
  input: "num.input",
  coupler: "num.coupler",
  output: "num.output",
  ground_pivots: "tolerance.pivots",
} as const;
const body = {...links, point: "tolerance.point"} as const;
/** Four-bars that guide a body. */
export const body_making: Making = {lengths: body, error: "length", limits: ["position", "angle_deg"]};
/** Of which the output's angle counts. */
export const angle_making: Making = {lengths: links, error: "angle", limits: ["angle_deg"]};
export const arc_making: Making = {lengths: null, error: "angle", limits: ["angle_deg"]};
/** Of which a point of the coupler counts. */
export const path_making: Making = {lengths: body, error: "length", limits: ["position"]};
export const line_making: Making = {lengths: body, error: "length", limits: ["deviation"]};
export const chain_making: Making = {
  lengths: {
    ...body,
    input: "tolerance.driving_link",
    output: "tolerance.grounded_links",
    coupler: "tolerance.other_links",
  },
  error: "length",
  limits: ["position", "angle_deg"],
};
