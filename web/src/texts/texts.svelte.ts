import type {Notice} from "../engine/protocol";
import {preferences} from "../state/preferences.svelte";
import en from "./en.json";
import zh from "./zh.json";

export type TextKey = keyof typeof en;
export type Values = Record<string, string | number>;
const texts: Record<"en" | "zh", Record<string, string>> = {en, zh};
const placeholder = /\{(\w+)(?::([^|}]*)\|([^}]*))?\}/g;

/** The text in the language in force, its {placeholders} filled in. Reactive. */
export function t(key: TextKey, values: Values = {}): string {
  return filled(texts[preferences.language][key] ?? en[key] ?? key, values);
}

/** A sentence of the engine: that of the key in the texts, or its English message. */
export function notice_text(notice: Notice, key = `notice.${notice.code}`): string {
  const known = texts[preferences.language][key];
  return known === undefined ? notice.message : filled(as_far_as_known(known, notice.values), told(notice.values));
}
/** The text of a key that may be there. */
export function known_text(key: string): string | null {
  return key in en ? t(key as TextKey) : null;
}
/** A sentence whose value the engine did not give is left out. */
function as_far_as_known(text: string, values: Values): string {
  return text
    .split(/(?<=\. |。)/)
    .filter((sentence) => [...sentence.matchAll(placeholder)].every(([, name]) => name! in values))
    .join("")
    .trimEnd();
}
/** The engine's values for people: numbers at three digits, its words and lists of numbers in the language in force. */
function told(values: Values): Values {
  const one = (value: string | number) =>
    typeof value === "number"
      ? Number.isInteger(value)
        ? value
        : Number(value.toPrecision(3))
      : known_text(`word.${value}`)
        ? known_text(`word.${value}`)!
        : preferences.language === "zh" && /^\d+(?:(?:, | and )\d+)+$/.test(value)
          ? value.replace(/, | and /g, "、")
          : value;
  return Object.fromEntries(Object.entries(values).map(([name, value]) => [name, one(value)]));
}

/** "{n} {n:four-bar|four-bars}": the first of two wordings where n is 1. */
function filled(text: string, values: Values): string {
  return text.replace(placeholder, (whole, name: string, one?: string, several?: string) =>
    !(name in values)
      ? whole
      : one === undefined
        ? String(values[name])
        : String(values[name]) === "1"
          ? one
          : several!,
  );
}
