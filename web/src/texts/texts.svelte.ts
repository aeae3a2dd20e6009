import type {Notice} from "../contract/messages";
import {preferences} from "../state/preferences.svelte";

export type TextKey = keyof typeof import("./en.json");
export type Values = Record<string, string | number>;
type Language = typeof preferences.language;
type Texts = Readonly<Record<string, string>>;

const sources: Record<Language, () => Promise<{default: Texts}>> = {
  en: () => import("./en.json"),
  zh: () => import("./zh.json"),
};
const loaded: Partial<Record<Language, Texts>> = {};
let shown = $state.raw<Language | null>(null);

/** Before the page stands, and whenever another language is wanted: until it is there, the one before stays. False: it
 *  cannot be had, and the one before is the language wanted again. */
export async function load_texts(): Promise<boolean> {
  const {language} = preferences;
  try {
    loaded[language] ??= (await sources[language]()).default;
  } catch (error) {
    if (shown === null) throw error;
    if (preferences.language === language) preferences.language = shown;
    return false;
  }
  if (preferences.language === language) shown = language;
  return true;
}
/** Those in force. */
function texts(): Texts {
  const language = preferences.language in loaded ? preferences.language : shown;
  return (language && loaded[language]) ?? {};
}

const placeholder = /\{(\w+)(?::([^|}]*)\|([^}]*))?\}/g;

/** The text in the language in force, its {placeholders} filled in. Reactive. */
export function t(key: TextKey, values: Values = {}): string {
  return filled(texts()[key] ?? key, values);
}

/** A sentence of the engine: that of the key in the texts, or its English message. */
export function notice_text(notice: Notice, key = `notice.${notice.code}`): string {
  const known = texts()[key];
  return known === undefined ? notice.message : filled(as_far_as_known(known, notice.values), told(notice.values));
}
export function is_text(key: string): key is TextKey {
  return key in texts();
}
/** The text of a key that may be there. */
export function known_text(key: string): string | null {
  return is_text(key) ? t(key) : null;
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
