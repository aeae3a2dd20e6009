// What exported files are called: the task's title and the pin's name, or what the linkage is.
import type {LinkageType, TauPair} from "../engine/protocol";
import type {Pin, Problem} from "../state/problem";
import {name_of} from "../tasks/kinds";

const longest_stem = 60;

/** Letters of any script, digits and single hyphens: safe as a file name anywhere. */
export function slug(title: string): string {
  const plain = title.normalize("NFC").toLowerCase().replace(/[^\p{L}\p{N}\p{M}]+/gu, "-").replace(/^-+|-+$/g, "");
  return [...plain].slice(0, longest_stem).join("").replace(/-+$/, "") || "linkage";
}
export function pin_of(tau: TauPair, pins: readonly Pin[]): Pin | null {
  return pins.find((pin) => Math.hypot(pin.tau[0] - tau[0], pin.tau[1] - tau[1]) < 1e-9) ?? null;
}
export function file_stem({title, task}: Pick<Problem, "title" | "task">, linkage: {tau: TauPair; type: LinkageType} | null, pins: readonly Pin[] = []): string {
  const name = linkage && (pin_of(linkage.tau, pins)?.name ?? name_of(task, linkage.type).replace(/^.*\./, ""));
  return slug(title ?? "") + (name ? `-${name}` : "");
}
