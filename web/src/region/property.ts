// What a colour of the map can stand for, whatever the task: its words, its range, which end is good, its requirement.
import type {LinkageType, Property, Requirements} from "../engine/protocol";
import {length_levels, round_step} from "../state/problem";
import type {Task} from "../state/task";
import type {PropertyDescription} from "../tasks/kind";
import {own_descriptions, properties_of} from "../tasks/kinds";
import type {TermName} from "../terms/pictures";
import type {TextKey} from "../texts/texts.svelte";
import {degrees_text, significant} from "../texts/numbers";
import type {Range} from "./painter";

export type Coloring = "type" | Property;
const angle_span = (): [number, number] => [0, 90],
  angle_levels = () => [30, 45, 60, 75];
export const descriptions = {
  min_transmission_angle_deg: {
    text: "region.by_transmission",
    short: "region.short_transmission",
    term: "transmission_angle",
    larger_is_better: true,
    requirement: "min_transmission_angle_deg",
    quantity: "angle",
    span: angle_span,
    levels: angle_levels,
  },
  link_ratio: {
    text: "region.by_ratio",
    short: "region.short_ratio",
    term: "link_ratio",
    larger_is_better: false,
    requirement: "max_link_ratio",
    quantity: "ratio",
    span: ({max_link_ratio}) => [1, Math.max(1.25 * (max_link_ratio ?? 20), 4)],
    levels: ([, to]) => [2, 3, 5, 8, 12].filter((level) => level < to),
  },
  longest_link: {
    text: "region.by_size",
    short: "region.by_size",
    term: null,
    larger_is_better: false,
    requirement: "max_length",
    quantity: "length",
    span: ({max_length}, typical) => [0, 1.25 * (max_length ?? 10 * typical)],
    levels: length_levels,
  },
  min_transmission_angle_full_turn_deg: {
    text: "num.min_turn",
    short: "num.min_turn",
    term: "transmission_angle",
    larger_is_better: true,
    requirement: null,
    quantity: "angle",
    span: angle_span,
    levels: angle_levels,
  },
  driver_sweep_deg: {
    text: "num.sweep",
    short: "num.sweep",
    term: "driver_sweep",
    larger_is_better: true,
    requirement: null,
    quantity: "angle",
    span: () => [0, 360],
    levels: () => [45, 90, 135, 180, 270],
  },
  ...own_descriptions,
} as Record<Property, PropertyDescription>;
/** In the order in which C walks through them. */
export function colorings_of(task: Task): Coloring[] {
  return ["type", ...properties_of(task)];
}

export function coloring_text(coloring: Coloring): TextKey {
  return coloring === "type" ? "region.by_type" : descriptions[coloring].short;
}

export function term_of(coloring: Coloring): TermName | null {
  return coloring === "type" ? null : descriptions[coloring].term;
}
/** Known of cells that meet everything only. */
export function is_of_meeting(coloring: Coloring): boolean {
  return coloring !== "type" && (descriptions[coloring].of_meeting ?? false);
}

/** What the scale bar spans. `typical`: a length of the task's size. */
export function domain(property: Property, requirements: Requirements, typical: number): [number, number] {
  return descriptions[property].span(requirements, typical);
}

/** The requirement's threshold on this property, where there is one that can be moved. */
export function threshold(property: Property, requirements: Requirements): number | null {
  const key = descriptions[property].requirement;
  if (!key || (key === "min_transmission_angle_deg" && requirements.no_defects === false)) return null;
  return requirements[key] ?? (key === "min_transmission_angle_deg" ? 0 : null);
}
export function held_threshold(property: Property, value: number): number {
  const {quantity} = descriptions[property];
  if (quantity === "angle") return Math.min(Math.max(Math.round(value), 0), 89);
  if (quantity === "ratio") return Math.max(Math.round(value * 10) / 10, 1);
  const step = round_step(value / 200);
  return Number(Math.max(Math.round(value / step) * step, step).toPrecision(9));
}

export function value_text(property: Property, value: number, unit: string): string {
  const {quantity} = descriptions[property];
  if (quantity === "angle") return degrees_text(value, 0);
  if (quantity === "fine_angle") return `${significant(value, 2)}°`;
  return quantity === "ratio" ? significant(value, 3) : `${significant(value, 3)} ${unit}`.trim();
}

/** Ends for the painter: from the bad one to the good one. */
export function painted_range(property: Property, ends: readonly [number, number]): Range {
  return descriptions[property].larger_is_better ? {from: ends[0], to: ends[1]} : {from: ends[1], to: ends[0]};
}

/** Contour levels, the requirement's own among them. */
export function contour_levels(
  property: Property,
  requirements: Requirements,
  typical: number,
): {level: number; bold: boolean}[] {
  const bold = threshold(property, requirements);
  const levels = new Set(descriptions[property].levels(domain(property, requirements, typical)));
  if (bold !== null && bold > 0) levels.add(bold);
  return [...levels].sort((a, b) => a - b).map((level) => ({level, bold: level === bold}));
}
export function type_text(type: LinkageType): TextKey {
  return `type.${type}`;
}
