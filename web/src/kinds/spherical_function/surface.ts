// The same function in the plane and on the sphere.
import type {Problem} from "../../state/problem";
import type {FunctionTask} from "../function/task";
import {angles_of} from "../function/pairs";
import {default_max_length, with_other_task} from "../kind_dispatch";
import type {SphericalFunctionTask} from "./task";

const ground_angle_deg = 60,
  ground_pivots = {input: [0, 0], output: [100, 0]} as const;

export function task_of(problem: Problem): SphericalFunctionTask {
  return problem.task as SphericalFunctionTask;
}
function prescribed(problem: Problem): Pick<FunctionTask, "pairs" | "function" | "free"> {
  const {pairs, function: named, free} = angles_of(problem);
  return {...(pairs && {pairs}), ...(named && {function: named}), ...(free && {free})};
}
export function on_sphere({length_unit: _, ...problem}: Problem): Problem {
  const task: SphericalFunctionTask = {
    kind: "function",
    mechanism: "spherical_four_bar",
    ...prescribed(problem),
    ground_angle_deg,
  };
  return with_other_task(problem, task);
}
export function in_plane(problem: Problem): Problem {
  const task: FunctionTask = {kind: "function", mechanism: "four_bar", ...prescribed(problem), ground_pivots};
  const changed = with_other_task({...problem, length_unit: "mm"}, task);
  return {...changed, requirements: {max_length: default_max_length(changed), ...changed.requirements}};
}
export function with_ground_angle(problem: Problem, angle_deg: number): Problem {
  return {...problem, task: {...task_of(problem), ground_angle_deg: angle_deg} as SphericalFunctionTask};
}
