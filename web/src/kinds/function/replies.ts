// What the engine says of function generators, beside what it says of every task and linkage.
export type {WantedFunction} from "../../contract/replies";

declare module "../../contract/messages" {
  interface Linkage {
    function: GeneratedFunction | null;
  }
  interface Properties {
    max_structural_error_deg: number; // of a named function, where no number is free
  }
}

/** Input and output angle, degrees on the task's dials. */
export type DegreePair = readonly [input: number, output: number];
/** What a four-bar makes of it, its free number as it is there. Null: the drive does not get there. */
export interface GeneratedFunction {
  pairs: (readonly [input: number, wanted: number, error: number | null])[];
  precision_error_deg: number; // largest magnitude at the pairs reached
  reaches_pairs: boolean;
  max_structural_error_deg: number | null;
  worst_input_deg: number | null;
  unreached_deg: readonly (readonly [from: number, to: number])[];
  curve: (readonly [input: number, wanted: number, generated: number | null])[];
}
