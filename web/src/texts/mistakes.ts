// What is wrong with a file, in the language in force.
import type {Mistake} from "../contract/messages";
import {preferences} from "../state/preferences.svelte";
import {notice_text, t} from "./texts.svelte";

/** "line 3, column 7" and "line 3" in the language in force; places in the file's own words stay. */
function place_text(place: string): string {
  const [at, line, column] = /^line (\d+)(?:, column (\d+))?$/.exec(place) ?? [];
  if (!at) return place;
  return column ? t("mistakes.line", {line: line!, column}) : t("mistakes.whole_line", {line: line!});
}

/** Its place and its sentence. */
export function mistake_text(mistake: Mistake): string {
  const {code, place} = mistake;
  const before = place ? `${place_text(place)}${t("mistakes.after_place")}` : "";
  return before + notice_text(mistake, `mistake.${code}`);
}

const most_told = 3;
/** What is wrong with a file: the first mistakes, and how many more. A sentence, or several. */
export function mistakes_text(mistakes: readonly Mistake[]): string {
  const told = mistakes.slice(0, most_told).map(mistake_text);
  if (mistakes.length > most_told) told.push(t("mistake.more_mistakes", {count: mistakes.length - most_told}));
  return told
    .map((text) => (/[.。…]$/.test(text) ? text : text + t("mistakes.full_stop")))
    .join(preferences.language === "zh" ? "" : " ");
}
