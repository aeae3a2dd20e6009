// The legend as a filter: which types the requirements ask for.
import {linkage_types, type LinkageType} from "../engine/protocol";
import {with_requirements, type Problem} from "../state/problem";

/** All that can be wanted; what is degenerate cannot. */
export const wantable = linkage_types.filter((type) => type !== "degenerate");
/** In the legend: a change point is a line on the map, no area. */
export const legend_types = wantable.filter((type) => type !== "change_point");

export function is_wanted(problem: Problem, type: LinkageType): boolean {
  const types = problem.requirements?.types;
  return !types || types.length === 0 || types.includes(type);
}
function wanting(problem: Problem, types: readonly LinkageType[]): Problem {
  const all = legend_types.every((type) => types.includes(type));
  const none = types.every((type) => type === "change_point");
  return with_requirements(problem, {types: all || none ? undefined : [...types]});
}
export function toggled(problem: Problem, type: LinkageType): Problem {
  return wanting(
    problem,
    wantable.filter((t) => (t === type) !== is_wanted(problem, t)),
  );
}
/** Only this one; all again if it was so already. */
export function only(problem: Problem, type: LinkageType): Problem {
  const types = problem.requirements?.types;
  return wanting(problem, types?.length === 1 && types[0] === type ? wantable : [type]);
}
