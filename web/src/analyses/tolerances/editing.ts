// Tolerances of a problem as the page gives and takes them.
import {most_of} from "../../state/ends";
import {round_step, type Problem} from "../../state/problem";
import type {Task} from "../../state/task";
import {extent_of, kind_of, with_analysis} from "../../kinds/kind_dispatch";
import {length_entries, length_tolerance, type Limit, type LimitKind, type Tolerances} from "./block";
import {tolerances as analysis} from "./index";
import type {Making} from "./making";

/** Null: nothing is asked of the tolerances of such linkages. */
export function making_of(task: Task): Making | null {
  return kind_of(task).analysed?.tolerances ?? null;
}
/** With other tolerances, or none; what is asked of linkages only with those that there were goes with them. */
export function made_to(problem: Problem, tolerances: Tolerances | null): Problem {
  return with_analysis(problem, analysis, tolerances);
}
/** To begin with: a thousandth of the task's size, a tenth of a degree. */
export function suggested_tolerances(task: Task): Tolerances {
  return making_of(task)?.lengths ? {length: round_step(extent_of(task) / 1500)} : {link_angle_deg: 0.1};
}
/** To begin with: what most linkages can keep. */
export function suggested_limit(
  {task, tolerances = {}}: Pick<Problem, "task" | "tolerances">,
  wanted?: LimitKind,
): Limit {
  const {limits, lengths} = making_of(task)!,
    kind = wanted ?? limits[0] ?? "position",
    {clearance = 0, driver_deg = 0, link_angle_deg = 0} = tolerances,
    largest = most_of([clearance, ...length_entries.map((entry) => length_tolerance(tolerances, entry))]);
  const angle = Math.max(driver_deg, link_angle_deg, lengths ? (largest / extent_of(task)) * (180 / Math.PI) : 0);
  const times = 4;
  return {[kind]: round_step(times * ((kind === "angle_deg" ? angle : largest) || (angle * extent_of(task)) / 57.3))};
}
/** As it is made to others: what is asked of linkages stays. */
export function with_tolerances(problem: Problem, tolerances: Tolerances): Problem {
  return {...problem, tolerances};
}
