// What a colour of the map can stand for, whatever the task: its words, its range, which end is good, its requirement.
import type {LinkageType, Property, Requirements} from "../engine/protocol";
import {round_step} from "../state/problem";
import type {Task} from "../state/task";
import {properties_of, property_descriptions, requirement_descriptions} from "../tasks/kinds";
import type {TermName} from "../terms/pictures";
import type {TextKey} from "../texts/texts.svelte";
import {degrees_text, significant} from "../texts/numbers";
import type {Range} from "./painter";

export type Coloring = "type" | Property;
/** In the order in which C walks through them. */
export function colorings_of(task: Task): Coloring[] {
  return ["type", ...properties_of(task)];
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

/** What the scale bar spans. `typical`: a length of the task's size. */
export function domain(property: Property, requirements: Requirements, typical: number): [number, number] {
  return property_descriptions[property].span(requirements, typical);
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
  const step = round_step(value / 200);
  return Number(Math.max(Math.round(value / step) * step, step).toPrecision(9));
}

export function value_text(property: Property, value: number, unit: string): string {
  const {quantity} = property_descriptions[property];
  if (quantity === "angle") return degrees_text(value, 0);
  if (quantity === "fine_angle") return `${significant(value, 3)}°`;
  return quantity === "ratio" || quantity === "share"
    ? significant(value, 3)
    : `${significant(value, 3)} ${unit}`.trim();
}

/** Ends for the painter: from the bad one to the good one. */
export function painted_range(property: Property, ends: readonly [number, number]): Range {
  return property_descriptions[property].larger_is_better ? {from: ends[0], to: ends[1]} : {from: ends[1], to: ends[0]};
}

/** Contour levels, the requirement's own among them. */
export function contour_levels(
  property: Property,
  requirements: Requirements,
  typical: number,
): {level: number; bold: boolean}[] {
  const bold = threshold(property, requirements);
  const levels = new Set(property_descriptions[property].levels(domain(property, requirements, typical)));
  if (bold !== null && bold > 0) levels.add(bold);
  return [...levels].sort((a, b) => a - b).map((level) => ({level, bold: level === bold}));
}
export function type_text(type: LinkageType): TextKey {
  return `type.${type}`;
}
