// The engine's refusals, by place in the problem file.
import type {Mistake} from "../contract/messages";
import {mistake_text} from "../texts/mistakes";
import {unbroken} from "../texts/numbers";
import {t} from "../texts/texts.svelte";

/** The sentence of a mistake, its positions counted from 1. */
export function mistake_sentence(mistake: Mistake): string {
  const {code, place} = mistake,
    words = unbroken(mistake_text({...mistake, place: ""}));
  const position = place_of_pose(place)?.index;
  if (code === "repeated_pose" && position !== undefined) return t("task.same_position", {j: position + 1});
  return position === undefined ? words : `${t("task.position")} ${position + 1}: ${words}`;
}
export function place_of_pose(place: string): {index: number; key: string | null} | null {
  const match = /^task\.poses\[(\d+)\](?:\.(\w+))?/.exec(place);
  return match && {index: Number(match[1]), key: match[2] ?? null};
}
/** Whether a cell of the table (a pose's x, y or theta_deg) has part in what was refused. */
export function cell_is_refused(mistakes: readonly Mistake[] | null, index: number, key: string): boolean {
  return (mistakes ?? []).some(({place}) => {
    const at = place_of_pose(place);
    return at?.index === index && (at.key === null || at.key === key);
  });
}
