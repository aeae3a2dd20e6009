// As the file has it: what the output shall do, and the angle between the axes about which input and output turn.
import type {AngleTask} from "../function/task";
import type {Task} from "../../state/task";

/** The input turns about (0, 0, 1), the output about (sin α, 0, cos α), both right-handed. */
export interface SphericalFunctionTask extends AngleTask {
  mechanism: "spherical_four_bar";
  ground_angle_deg: number;
}

export function is_spherical_function(task: Task): task is SphericalFunctionTask {
  return task.kind === "function" && task.mechanism === "spherical_four_bar";
}
