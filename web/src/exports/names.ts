// What exported files are called: the task's title and the pin's name, or what the linkage is.
import type {LinkageType, TauPair} from "../contract/messages";
import type {Pin, Problem} from "../state/problem";
import {name_of} from "../kinds/kind_dispatch";

const longest_stem = 60;

/** Letters of any script, digits and single hyphens: safe as a file name anywhere. */
function safe(text: string): string {
  const plain = text
    .normalize("NFC")
    .replace(/[^\p{L}\p{N}\p{M}_]+/gu, "-")
    .replace(/^-+|-+$/g, "");
  return [...plain].slice(0, longest_stem).join("").replace(/-+$/, "");
}
export function slug(title: string): string {
  return safe(title.replaceAll("_", "-").toLowerCase()) || "linkage";
}
/** An extension may have its dot or not. */
export function file_name(stem: string, extension: string): string {
  return `${stem}.${extension.replace(/^\./, "")}`;
}
export function pin_of(tau: TauPair, pins: readonly Pin[]): Pin | null {
  return pins.find((pin) => Math.hypot(pin.tau[0] - tau[0], pin.tau[1] - tau[1]) < 1e-9) ?? null;
}
export function file_stem(
  {title, task}: Pick<Problem, "title" | "task">,
  linkage: {tau: TauPair; type: LinkageType} | null,
  pins: readonly Pin[] = [],
): string {
  const pinned = linkage && safe(pin_of(linkage.tau, pins)?.name ?? "");
  const name = linkage && (pinned || name_of(task, linkage.type).replace(/^.*\./, ""));
  return slug(title ?? "") + (name ? `-${name}` : "");
}
