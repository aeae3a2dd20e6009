// A linkage that is there already: nothing is sought.
import type {JsonObject} from "../../state/shape";
import type {Task} from "../../state/task";

export const mechanisms = ["four_bar", "six_bar", "spherical_four_bar"] as const;
export type LinkageMechanism = (typeof mechanisms)[number];
export interface LinkageTask extends Task {
  readonly kind: "linkage";
  readonly mechanism: LinkageMechanism;
  /** What a linkage file of the program's has (linkage_file.hpp), without its header. */
  readonly file: JsonObject;
}
export function is_linkage(task: Task): task is LinkageTask {
  return task.kind === "linkage";
}
