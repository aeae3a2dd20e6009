// A linkage in words, for the card and for those who listen.
import type {Linkage} from "../contract/messages";
import {defect_key, has_defect, linkage_name} from "../numbers/linkage_words";
import type {Task} from "../state/task";
import {told} from "../kinds/kind_dispatch";
import {degrees_text, fixed, significant} from "../texts/numbers";
import {t} from "../texts/texts.svelte";
import {type_text} from "./property";

function within(text: string): string {
  return text.charAt(0).toLowerCase() + text.slice(1);
}

/** "Double crank, transmission angle 82.6 degrees, no defects" */
export function spoken(linkage: Linkage, task: Task): string {
  const type = linkage_name(linkage);
  if (linkage.type === "degenerate") return linkage.reason ? told(task, linkage.reason) : type;
  const defects = within(t(defect_key(linkage.defects))),
    angle = linkage.min_transmission_angle_deg;
  if (has_defect(linkage) || angle === null) return t("region.spoken_bare", {type, defects});
  return t("region.spoken", {type, angle: fixed(angle, 1), defects});
}

/** "γ 72.7° · ratio 4.6 · 258 mm" */
export function figures(
  of: {min_transmission_angle_deg: number | null; link_ratio: number | null; longest: number | null},
  unit: string,
): string {
  const parts: string[] = [];
  if (of.min_transmission_angle_deg !== null) parts.push(`γ ${degrees_text(of.min_transmission_angle_deg)}`);
  if (of.link_ratio !== null)
    parts.push(
      t("region.ratio_value", {value: of.link_ratio < 100 ? fixed(of.link_ratio, 1) : significant(of.link_ratio, 2)}),
    );
  if (of.longest !== null)
    parts.push(
      `${of.longest < 1e6 && of.longest >= 100 ? fixed(of.longest, 0) : significant(of.longest, 3)} ${unit}`.trim(),
    );
  return parts.join(" · ");
}

export function mirror_text({swapped}: Linkage): string | null {
  if (!swapped) return null;
  const angle = swapped.min_transmission_angle_deg;
  const good = () => within(t(type_text(swapped.type))) + (angle === null ? "" : `, γ ${degrees_text(angle)}`);
  return t("region.mirror", {what: has_defect(swapped) ? within(t(defect_key(swapped.defects))) : good()});
}
