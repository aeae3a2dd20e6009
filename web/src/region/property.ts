// What a colour of the map can stand for: its words, its range, which end is good, its requirement.
import type {LinkageType, Property, Requirements} from "../engine/protocol";
import {round_step} from "../state/problem";
import type {Task} from "../state/task";
import {properties_of} from "../tasks/kinds";
import type {TextKey} from "../texts/texts.svelte";
import {degrees_text, significant} from "../texts/numbers";
import type {Range} from "./painter";

export type Coloring = "type" | Property;
interface Description {
  text: TextKey;
  short: TextKey;
  larger_is_better: boolean;
  requirement: "min_transmission_angle_deg" | "max_link_ratio" | "max_length" | null;
  quantity: "angle" | "fine_angle" | "ratio" | "length";
}
export const descriptions: Record<Property, Description> = {
  min_transmission_angle_deg: {
    text: "region.by_transmission",
    short: "region.short_transmission",
    larger_is_better: true,
    requirement: "min_transmission_angle_deg",
    quantity: "angle",
  },
  link_ratio: {
    text: "region.by_ratio",
    short: "region.short_ratio",
    larger_is_better: false,
    requirement: "max_link_ratio",
    quantity: "ratio",
  },
  longest_link: {
    text: "region.by_size",
    short: "region.by_size",
    larger_is_better: false,
    requirement: "max_length",
    quantity: "length",
  },
  min_transmission_angle_full_turn_deg: {
    text: "num.min_turn",
    short: "num.min_turn",
    larger_is_better: true,
    requirement: null,
    quantity: "angle",
  },
  pose_miss: {
    text: "region.by_miss",
    short: "region.by_miss",
    larger_is_better: false,
    requirement: null,
    quantity: "length",
  },
  driver_sweep_deg: {
    text: "num.sweep",
    short: "num.sweep",
    larger_is_better: true,
    requirement: null,
    quantity: "angle",
  },
  max_structural_error_deg: {
    text: "function.max_error",
    short: "function.error",
    larger_is_better: false,
    requirement: null,
    quantity: "fine_angle",
  },
};
/** In the order in which C walks through them. */
export function colorings_of(task: Task): Coloring[] {
  return ["type", ...properties_of(task)];
}

export function coloring_text(coloring: Coloring): TextKey {
  return coloring === "type" ? "region.by_type" : descriptions[coloring].short;
}

/** What the scale bar spans. `typical`: a length of the task's size. */
export function domain(property: Property, requirements: Requirements, typical: number): [number, number] {
  if (property === "driver_sweep_deg") return [0, 360];
  if (property === "max_structural_error_deg") return [0, 2];
  if (property === "link_ratio") return [1, Math.max(1.25 * (requirements.max_link_ratio ?? 20), 4)];
  if (property === "pose_miss") return [0, 0.2 * typical];
  if (property === "longest_link") return [0, 1.25 * (requirements.max_length ?? 10 * typical)];
  return [0, 90];
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
  const levels = new Set(plain_levels(property, domain(property, requirements, typical)));
  if (bold !== null && bold > 0) levels.add(bold);
  return [...levels].sort((a, b) => a - b).map((level) => ({level, bold: level === bold}));
}
function plain_levels(property: Property, [from, to]: [number, number]): number[] {
  if (property === "link_ratio") return [2, 3, 5, 8, 12].filter((level) => level < to);
  if (property === "max_structural_error_deg") return [0.1, 0.2, 0.5, 1];
  if (property === "driver_sweep_deg") return [45, 90, 135, 180, 270];
  if (property !== "longest_link" && property !== "pose_miss") return [30, 45, 60, 75];
  const step = round_step((to - from) / 8);
  return [1, 2, 3, 4, 5, 6].map((k) => k * step).filter((level) => level < to);
}

export function type_text(type: LinkageType): TextKey {
  return `type.${type}`;
}
