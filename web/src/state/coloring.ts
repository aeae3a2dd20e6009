// What the colours of the map stand for, and the property that is asked of the engine with a map.
import type {Property} from "../engine/protocol";
import {kind_of} from "../tasks/kinds";
import {preferences} from "./preferences.svelte";
import type {Objective, Problem} from "./problem";
import type {Task} from "./task";

export type Coloring = "type" | Property;

const common: readonly Property[] = ["min_transmission_angle_deg", "link_ratio", "longest_link", "min_transmission_angle_full_turn_deg", "driver_sweep_deg"];
const measures: Record<Objective, Property> = {
  min_transmission_angle: "min_transmission_angle_deg", link_ratio: "link_ratio", size: "longest_link", structural_error: "max_structural_error_deg",
};

function properties_of(task: Task): readonly Property[] {
  return kind_of(task).properties?.(task) ?? [];
}
/** In the order in which C walks through them. */
export function colorings_of({task}: Problem): Coloring[] {
  return ["type", ...properties_of(task), ...common];
}
/** The one that is preferred, where this task has it. */
export function coloring_of(problem: Problem): Coloring {
  return colorings_of(problem).includes(preferences.colour_by) ? preferences.colour_by : "type";
}
/** What the objective is measured by, where the map shows it. */
export function measure_of(problem: Problem): Property {
  const property = measures[problem.options?.objective ?? "min_transmission_angle"];
  return common.includes(property) || properties_of(problem.task).includes(property) ? property : common[0];
}
