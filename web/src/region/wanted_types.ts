// The legend as a filter: which types the requirements ask for.
import type {LinkageType} from "../contract/messages";
import {with_requirements, type Problem} from "../state/problem";
import type {Task} from "../state/task";
import {types_of} from "../kinds/kind_dispatch";

/** In the legend: a change point is a line on the map, no area. */
export function legend_types(task: Task): LinkageType[] {
  return types_of(task).filter((type) => type !== "change_point");
}
export function is_wanted(problem: Problem, type: LinkageType): boolean {
  const types = problem.requirements?.types;
  return !types || types.length === 0 || types.includes(type);
}
function wanting(problem: Problem, types: readonly LinkageType[]): Problem {
  const all = legend_types(problem.task).every((type) => types.includes(type));
  const none = types.every((type) => type === "change_point");
  return with_requirements(problem, {types: all || none ? undefined : [...types]});
}
export function toggled(problem: Problem, type: LinkageType): Problem {
  return wanting(
    problem,
    types_of(problem.task).filter((t) => (t === type) !== is_wanted(problem, t)),
  );
}
/** Only this one; all again if it was so already. */
export function only(problem: Problem, type: LinkageType): Problem {
  const types = problem.requirements?.types;
  return wanting(problem, types?.length === 1 && types[0] === type ? types_of(problem.task) : [type]);
}
