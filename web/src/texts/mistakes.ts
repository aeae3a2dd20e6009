// The engine's sentences about a file: in English as the command line prints them, in other languages by what they say.
import type {Mistake} from "../engine/protocol";
import {preferences} from "../state/preferences.svelte";
import {known_text, t, type TextKey, type Values} from "./texts.svelte";

/** First match wins; named groups are the values of the text. */
const readings: readonly (readonly [RegExp, TextKey])[] = [
  [/^either .+ belongs here, not both$/, "mistake.one_of_two"],
  [/^(?<wanted>.+) belongs? here, not (?<found>.+)$/, "mistake.wrong_type"],
  [/^two numbers \[low, high\] belong here$/, "mistake.interval"],
  [/^two numbers \[.*\] belong here$/, "mistake.two_numbers"],
  [/^this is missing/, "mistake.missing_key"],
  [/^this key is not known here; the nearest known one is "(?<name>.+)"$/, "mistake.unknown_key"],
  [/^this key is given twice/, "mistake.duplicate_key"],
  [/^(?<given>".*") is not known here; the nearest known name is "(?<name>.+)"$/, "mistake.unknown_name"],
  [/^(?<given>".*") is listed twice/, "mistake.repeated_type"],
  [/^(?<given>".*") is too large for a number/, "mistake.number_too_large"],
  [/is not available in this version|are not available in this version/, "mistake.not_available"],
  [
    /^(?<count>\d+) (?:poses|positions) (?:were|was|are) given.* (?<least>\d) to \d are needed/,
    "mistake.too_few_poses",
  ],
  [/^(?<count>\d+) (?:poses|positions) (?:were|was|are) given/, "mistake.too_many_poses"],
  [/^(?<count>\d+) pairs? (?:were|was) given.* are needed/, "mistake.too_few_pairs"],
  [/^(?<count>\d+) pairs (?:were|are) given/, "mistake.too_many_pairs"],
  [/^an instant centre goes with/, "mistake.unneeded_center"],
  [/^a centre at infinity needs/, "mistake.center_direction"],
  [/a centre at infinity is given by/, "mistake.center_range"],
  [/^the angle between the side links is/, "mistake.side_angle_range"],
  [/^its borders must be/, "mistake.box_range"],
  [/^the number of chains to try lies between (?<low>\d+) and (?<high>\d+)/, "mistake.effort_range"],
  [/^a structural error belongs/, "mistake.objective_of_function"],
  [/^a seed is/, "mistake.seed_range"],
  [/^an elbow is/, "mistake.elbow_range"],
  [/^pairs count from|^there are only \d+ pairs/, "mistake.pair_number"],
  [/^the output's travel is multiplied/, "mistake.scale_range"],
  [/^the range is \[low, high\]|^the range is written/, "mistake.range_order"],
  [/^the input's dial has/, "mistake.dial_turn"],
  [/^a range is two/, "mistake.range_numbers"],
  [/^four or five precision points/, "mistake.precision_points"],
  [/^the point lies outside/, "mistake.point_outside"],
  [/^x and y must be/, "mistake.table_numbers"],
  [/is not understood from character (?<at>\d+) on/, "mistake.formula_place"],
  [/^the length of a side link is/, "mistake.side_length_range"],
  [/^(?<count>\d+) derivatives are given/, "mistake.too_many_derivatives"],
  [/^poses\[(?<i>\d+)\] and poses\[(?<j>\d+)\] are the same/, "mistake.same_poses"],
  [/^(?<name>\S+) must be a number between/, "mistake.number_range"],
  [/first derivative is zero/, "mistake.zero_derivative"],
  [/^the transmission angle lies between/, "mistake.transmission_angle_range"],
  [/^the transmission angle over the task is defined only/, "mistake.transmission_angle_defects"],
  [/^the longest over the shortest/, "mistake.link_ratio_range"],
  [/^the longest link must be allowed/, "mistake.max_length_range"],
  [/^the shortest link must be/, "mistake.min_length_range"],
  [/^the shortest link is asked to be longer/, "mistake.min_length_order"],
  [/^the limits must be finite/, "mistake.limits_finite"],
  [/^the lower limit is above/, "mistake.limits_order"],
  [/^a degenerate linkage cannot be wanted/, "mistake.degenerate_wanted"],
  [/^the region takes (?<low>\d+) to (?<high>\d+) samples/, "mistake.samples_range"],
  [/^the number of linkages to return/, "mistake.best_range"],
  [/^each interval of the window/, "mistake.window_range"],
  [/^there is no version (?<version>[\d.e+-]+)/, "mistake.unknown_version"],
  [/^this file was written by a newer/, "mistake.newer_version"],
  [/^this file is larger than/, "mistake.file_too_large"],
  [/^this file is empty/, "mistake.empty_file"],
  [/zero byte/, "mistake.zero_byte"],
  [/nested deeper than (?<most>\d+)/, "mistake.nested_too_deep"],
  [/breaks off inside a text/, "mistake.cut_in_text"],
  [/breaks off here/, "mistake.cut_short"],
  [/not UTF-8/, "mistake.not_utf8"],
  [/line break or tab/, "mistake.line_break"],
  [/half of a pair|no such escape|hexadecimal digits/, "mistake.escape"],
  [/JSON numbers are finite/, "mistake.json_number"],
  [/comment is not closed/, "mistake.open_comment"],
  [/something follows the end/, "mistake.two_documents"],
  [/colon is missing/, "mistake.colon"],
  [/comma or [}\]] is missing/, "mistake.comma"],
  [/comma stands before|before the closing bracket/, "mistake.trailing_comma"],
  [/stand in double quotes|key in double quotes/, "mistake.quotes"],
  [/not a JSON value|a value is missing/, "mistake.json_value"],
  [/^(?<count>\d+) more mistakes/, "mistake.more"],
  [/no side links to pair/, "mistake.no_dyads"],
];

const words: Record<string, TextKey> = {
  "a number": "word.number",
  "a whole number": "word.whole_number",
  "a text": "word.text",
  "a text in double quotes": "word.text",
  "a list": "word.list",
  "an object": "word.object",
  "an object { … }": "word.object",
  "true or false": "word.flag",
  "a list of poses": "word.poses",
  "a list of linkage types": "word.types",
  "two pairs of bodies": "word.bodies",
  "a pair of intervals [[low, high], [low, high]]": "word.intervals",
};
function in_words(values: Record<string, string>): Values {
  const known = (text: string) =>
    text in words ? t(words[text]!) : text.startsWith("a list of") ? t("word.list") : text;
  return Object.fromEntries(
    Object.entries(values).map(([name, text]) => [name, name === "wanted" || name === "found" ? known(text) : text]),
  );
}

/** "line 3, column 7" in the language in force; places in the file's own words stay. */
function place_text(place: string): string {
  const at = /^line (\d+), column (\d+)$/.exec(place);
  return at ? t("mistake.line", {line: at[1]!, column: at[2]!}) : place;
}

/** In other languages: by what the sentence says, else by the code, whose text says all there is. */
export function mistake_text({code, place, message}: Mistake): string {
  const before = place ? `${place_text(place)}${t("mistake.colon_after_place")}` : "";
  if (preferences.language === "en") return before + message;
  for (const [pattern, key] of readings) {
    const found = pattern.exec(message);
    if (found) return before + t(key, in_words(found.groups ?? {}));
  }
  return before + (known_text(`mistake.${code}`) ?? message);
}

const most_told = 3;
/** What is wrong with a file: the first mistakes, and how many more. A sentence, or several. */
export function mistakes_text(mistakes: readonly Mistake[]): string {
  const told = mistakes.slice(0, most_told).map(mistake_text);
  if (mistakes.length > most_told) told.push(t("mistake.more", {count: mistakes.length - most_told}));
  return told
    .map((text) => (/[.。…]$/.test(text) ? text : text + t("mistake.full_stop")))
    .join(preferences.language === "zh" ? "" : " ");
}
