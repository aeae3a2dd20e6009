// What a colour of the map can stand for, whatever the task: its words, its range, which end is good, its requirement.
import type {LinkageType, Property, Requirements, TaskAnswer} from "../contract/messages";
import {round_step} from "../state/problem";
import type {Problem} from "../state/problem";
import type {Workbench} from "../state/workbench.svelte";
import {properties_of, property_descriptions, property_of, requirement_descriptions} from "../kinds/kind_dispatch";
import type {TermName} from "../terms/pictures";
import type {TextKey} from "../texts/texts.svelte";
import {degrees_text, mechanical_unit, percent_text, significant, with_unit} from "../texts/numbers";
import type {ValueRange} from "./value_range";

export type Coloring = "type" | Property;
/** In the order in which C walks through them. */
export function colorings_of(problem: Problem): Coloring[] {
  return ["type", ...properties_of(problem)];
}

export function coloring_text(coloring: Coloring): TextKey {
  return coloring === "type" ? "region.by_type" : property_descriptions[coloring].short;
}

export function term_of(coloring: Coloring): TermName | null {
  return coloring === "type" ? null : property_descriptions[coloring].term;
}
/** Known of cells that meet everything only. */
export function is_of_meeting(coloring: Coloring): boolean {
  return coloring !== "type" && (property_descriptions[coloring].of_meeting ?? false);
}

/** What is shown, and what the engine said of its task. */
interface Shown {
  problem: Pick<Problem, "task">;
  task: Pick<TaskAnswer, "requirements" | "characteristic_length"> | null;
}
/** What the scale bar spans. */
export function domain(property: Property, of: Shown): [number, number] {
  const {requirements = {}, characteristic_length = 1} = of.task ?? {};
  return property_of(of.problem.task, property).span(requirements, characteristic_length, of.problem);
}
/** What its numbers are in, where they are lengths, or errors. */
export function unit_for(property: Property, {problem, unit}: Pick<Workbench, "problem" | "unit">): string {
  const {quantity, in_degrees} = property_of(problem.task, property);
  return in_degrees ? "°" : (mechanical_unit(quantity, unit) ?? unit);
}

/** The requirement's threshold on this property, where there is one that can be moved. */
export function threshold(property: Property, requirements: Requirements): number | null {
  const key = property_descriptions[property].requirement;
  if (!key) return null;
  const needs_no_defects = requirement_descriptions[key].control === "transmission_angle";
  if (needs_no_defects && requirements.no_defects === false) return null;
  return (requirements[key] as number | null | undefined) ?? (needs_no_defects ? 0 : null);
}
export function held_threshold(property: Property, value: number): number {
  const {quantity} = property_descriptions[property];
  if (quantity === "angle") return Math.min(Math.max(Math.round(value), 0), 89);
  if (quantity === "ratio") return Math.max(Math.round(value * 10) / 10, 1);
  if (quantity === "percent") return Math.min(Math.max(Math.round(100 * value) / 100, 0), 1);
  if (quantity === "force") return Math.round(value);
  const step = round_step(value / 200);
  return Number(Math.max(Math.round(value / step) * step, step).toPrecision(9));
}

export function value_text(property: Property, value: number, unit: string): string {
  const {quantity} = property_descriptions[property];
  if (quantity === "angle") return degrees_text(value, 0);
  if (quantity === "fine_angle") return `${significant(value, 3)}°`;
  if (quantity === "percent") return percent_text(value);
  return quantity === "ratio" || quantity === "share" ? significant(value, 3) : with_unit(significant(value, 3), unit);
}

/** Ends for the painter: from the bad one to the good one. */
export function painted_range(property: Property, ends: readonly [number, number]): ValueRange {
  const {larger_is_better, logarithmic} = property_descriptions[property],
    [from, to] = larger_is_better ? ends : [ends[1], ends[0]];
  return {from, to, ...(logarithmic ? {logarithmic} : {})};
}

/** Contour levels, the requirement's own among them. */
export function contour_levels(property: Property, of: Shown): {level: number; bold: boolean}[] {
  const bold = threshold(property, of.task?.requirements ?? {});
  const [from, to] = domain(property, of),
    levels = new Set(property_of(of.problem.task, property).levels([from, to]));
  if (bold !== null && (bold > 0 || bold > from)) levels.add(bold);
  return [...levels].sort((a, b) => a - b).map((level) => ({level, bold: level === bold}));
}
export function type_text(type: LinkageType): TextKey {
  return `type.${type}`;
}
