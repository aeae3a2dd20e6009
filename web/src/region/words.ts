// A linkage in words, for the card and for those who listen.
import type {Defects, Linkage, RequirementKey} from "../engine/protocol";
import {requirement_keys} from "../engine/protocol";
import {degrees_text, fixed, significant} from "../texts/numbers";
import {notice_text, t, type TextKey} from "../texts/texts.svelte";
import {requirement_texts, type_text} from "./property";

export function defect_key(defects: Defects): TextKey | null {
  return defects.circuit ? "defect.circuit" : defects.branch ? "defect.branch" : defects.order ? "defect.order" : null;
}
function within(text: string): string {
  return text.charAt(0).toLowerCase() + text.slice(1);
}

/** "Double crank, transmission angle 82.6 degrees, no defects" */
export function spoken(linkage: Linkage): string {
  const type = t(type_text(linkage.type)), key = defect_key(linkage.defects);
  if (linkage.type === "degenerate") return linkage.reason ? notice_text(linkage.reason) : type;
  const defects = key ? within(t(key)) : t("region.no_defects"), angle = linkage.min_transmission_angle_deg;
  if (key || angle === null) return t("region.spoken_bare", {type, defects});
  return t("region.spoken", {type, angle: fixed(angle, 1), defects});
}

/** "γ 72.7° · ratio 4.6 · 258 mm" */
export function figures(of: {min_transmission_angle_deg: number | null; link_ratio: number | null; longest: number | null}, unit: string): string {
  const parts: string[] = [];
  if (of.min_transmission_angle_deg !== null) parts.push(`γ ${degrees_text(of.min_transmission_angle_deg)}`);
  if (of.link_ratio !== null) parts.push(t("region.ratio_value", {value: of.link_ratio < 100 ? fixed(of.link_ratio, 1) : significant(of.link_ratio, 2)}));
  if (of.longest !== null) parts.push(`${of.longest < 1e6 && of.longest >= 100 ? fixed(of.longest, 0) : significant(of.longest, 3)} ${unit}`.trim());
  return parts.join(" · ");
}

export function mirror_text({swapped}: Linkage): string | null {
  if (!swapped) return null;
  const key = defect_key(swapped.defects), angle = swapped.min_transmission_angle_deg;
  const good = () => within(t(type_text(swapped.type))) + (angle === null ? "" : `, γ ${degrees_text(angle)}`);
  return t("region.mirror", {what: key ? within(t(key)) : good()});
}

/** Requirements that a linkage without defects fails. */
export function unmet_text(fails: number): string | null {
  const names = requirement_keys.filter((key: RequirementKey, bit) => key !== "no_defects" && fails & (1 << bit));
  if (names.length === 0) return null;
  return t("region.unmet", {names: names.map((key) => within(t(requirement_texts[key]))).join(t("region.list_comma"))});
}
