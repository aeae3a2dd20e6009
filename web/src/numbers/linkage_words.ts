// How the numbers of a linkage are said.
import type {Linkage, LinkageType, Pivot, RequirementKey, Requirements, TaskAnswer} from "../contract/messages";
import {value_text, type Units} from "../requirements/requirements";
import {preferences} from "../state/preferences.svelte";
import {screen_size} from "../state/screen.svelte";
import type {Task} from "../state/task";
import {called, made_up, name_of, requirement_descriptions} from "../kinds/kind_dispatch";
import {degrees_text, fixed, length_text, significant} from "../texts/numbers";
import {is_text, t, type TextKey} from "../texts/texts.svelte";

/** What stands where no linkage is in hand. */
export function no_linkage_text(
  {incomplete, task}: {incomplete: object | null; task: Pick<TaskAnswer, "status"> | null},
  otherwise: TextKey,
): string {
  if (incomplete) return t("num.not_yet");
  return t(task && task.status !== "solved" ? "num.no_linkage" : by_hand(otherwise));
}
/** On a phone no key can be pressed. */
export function by_hand(key: TextKey): TextKey {
  const touched = `${key}_touch`;
  return screen_size.kind === "phone" && is_text(touched) ? touched : key;
}
/** A name that fits a table. */
export function short_type(type: LinkageType): string {
  const short = `region.short.${type}`;
  return t(is_text(short) ? short : (`type.${type}` as TextKey));
}
/** Of a linkage of a task: a longer one than a four-bar is called by its make-up. */
export function short_name(task: Task, type: LinkageType): string {
  const name = name_of(task, type);
  return name === `type.${type}` ? short_type(type) : t(name);
}
/** "Crank-rocker", "Watt I". */
export function linkage_name(linkage: Pick<Linkage, "type">): string {
  return t(called(linkage));
}
/** That fits a line. */
export function short_linkage_name(linkage: Pick<Linkage, "type">): string {
  const name = made_up(linkage);
  return name ? t(name) : short_type(linkage.type);
}
/** With the decimals that the user has chosen, else as many as linkages of this size are told with. */
function shown_length(value: number, typical: number): string {
  const {decimals} = preferences;
  return decimals === null ? length_text(value, typical) : fixed(value, decimals);
}
/** Lengths of a linkage, two decimals for links of some hundred millimetres. */
export function link_text(length: number, longest: number): string {
  return shown_length(length, longest / 10);
}
export function point_text(point: Pivot | null, longest: number): string {
  return point ? point.map((value) => shown_length(value, longest)).join(", ") : "∞";
}
/** For a spreadsheet: all digits, set apart by tabs. */
export function row_text(numbers: readonly number[]): string {
  return numbers.join("\t");
}
export function sense_mark(sense: Linkage["drive_sense"]): string {
  return sense === "cw" ? "↻" : sense === "ccw" ? "↺" : sense === "either" ? "↻↺" : "";
}
export function with_unit(text: string, unit: string): string {
  return unit ? `${text} ${unit}` : text;
}
export function residual_text(residual: number, unit: string): string {
  return with_unit(significant(residual, 1), unit);
}
export function has_defect(linkage: {defects: Linkage["defects"]}): boolean {
  return linkage.defects.order || linkage.defects.branch || linkage.defects.circuit;
}
/** The worst defect by name: a circuit defect is a branch defect too. */
export function defect_key(defects: Linkage["defects"]): TextKey {
  return defects.circuit
    ? "defect.circuit"
    : defects.branch
      ? "defect.branch"
      : defects.order
        ? "defect.order"
        : "defect.none";
}

/** "Transmission angle at least 30°" with the value asked for. */
export function requirement_words(key: RequirementKey, requirements: Requirements, units: Units): string {
  const value = requirements[key],
    name = t(requirement_descriptions[key].name);
  return typeof value === "number" ? `${name} ${value_text(key, value, units)}` : name;
}
/** "Crank-rocker, no defects, γ 41.3°": the same bars, driven from the other side. */
export function swapped_words(swapped: NonNullable<Linkage["swapped"]>): string {
  const {type, defects, min_transmission_angle_deg: angle} = swapped;
  const parts = [t(`type.${type}`), t(defect_key(defects))];
  if (angle !== null && !has_defect(swapped)) parts.push(`γ ${degrees_text(angle)}`);
  return parts.join(" · ");
}
