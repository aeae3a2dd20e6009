// What a linkage does under loads, in words: a line to each read-out, a value to each case.
import type {ReadOut} from "../../contract/problem";
import type {LoadCaseReport, LoadPlace, LoadReport} from "../../contract/result";
import type {Requirements} from "../../contract/messages";
import {mechanical_unit, significant, with_unit} from "../../texts/numbers";
import {t, type TextKey} from "../../texts/texts.svelte";
import type {TermName} from "../../terms/pictures";
import {counts_for, type LoadCase} from "./block";
import {limited_by} from "./criteria";

/** What each is called for short. */
export const read_out_names: Readonly<Record<ReadOut, TextKey>> = {
  max_open_force: "loads.open_short",
  max_close_force: "loads.close_short",
  hand_force: "loads.hand_force",
  hold_open: "loads.hold_open",
  close_start: "loads.close_start",
  hump: "loads.hump",
  pop_up: "loads.pop_up",
  self_rise: "loads.rises_from",
  self_close: "loads.closes_from",
  max_pin_force: "loads.pin_short",
  max_torque: "loads.torque",
  cylinder_force: "loads.cylinder_short",
};
/** What plots show. */
export const shown_names = {
  hand: "loads.hand_force",
  torque: "loads.torque",
  pin: "loads.pin_short",
  shaking: "loads.shaking_short",
} as const;
export interface Told {
  text: string;
  /** What it should be, where it is not that. */
  limit: string | null;
}
export interface ReadOutRow {
  key: string;
  name: string;
  term?: TermName;
  /** The case that decides, where there are several. */
  worst: string | null;
  values: Told[];
}
interface About {
  cases: readonly LoadCase[];
  requirements: Requirements;
  unit: string;
}
type Limited = keyof typeof limited_by;

const digits = 3,
  none = "–";
export function force_text(force: number | null, kept = digits): string {
  return force === null ? none : with_unit(significant(force, kept), "N");
}
export function torque_text(torque: number | null, unit: string, kept = digits): string {
  return torque === null ? none : with_unit(significant(torque, kept), mechanical_unit("torque", unit)!);
}
function place_text(place: LoadPlace | null): string {
  if (!place) return t("loads.never");
  if (Math.abs(place.driver_turn_deg) < 1e-6) return t("loads.all_the_way");
  return `${significant(place.body_turn_deg, digits)}°`;
}
/** Shut is where it begins: what closes from the last position on does so all the way. */
function closing_text(place: LoadPlace | null): string {
  if (place?.path === 1) return t("loads.all_the_way");
  return place ? `${significant(place.body_turn_deg, digits)}°` : t("loads.never");
}

/** How far the body has turned there, either way. */
const turn_of = (place: LoadPlace | null): number | null => place && Math.abs(place.body_turn_deg);

/** The largest of the four, and at which joint. */
export function largest_pin({pins}: LoadCaseReport): {joint: keyof LoadCaseReport["pins"]; force: number} | null {
  const known = (Object.keys(pins) as (keyof typeof pins)[]).flatMap((joint) =>
    pins[joint] ? [{joint, force: pins[joint].max}] : [],
  );
  return known.reduce<(typeof known)[number] | null>(
    (most, pin) => (most && most.force >= pin.force ? most : pin),
    null,
  );
}
/** What a requirement asks that this value is not, and by how much; nothing for a case that does not count. */
export function missed_limit(
  read_out: Limited,
  value: number | null,
  of: LoadCase | undefined,
  {requirements, unit}: Pick<About, "requirements" | "unit">,
): string | null {
  const limit = requirements[limited_by[read_out]] ?? null;
  if (limit === null || value === null || (of && !counts_for(of, read_out as ReadOut))) return null;
  const text = (of: number, kept = digits) =>
    read_out === "max_torque"
      ? torque_text(of, unit, kept)
      : read_out === "self_rise" || read_out === "self_close"
        ? `${significant(of, kept)}°`
        : force_text(of, kept);
  const is_least = read_out === "hold_open" || read_out === "self_close",
    missing = is_least ? limit - value : value - limit;
  if (!(missing > 0)) return null;
  return t(is_least ? "loads.at_least" : "loads.at_most", {limit: text(limit), by: text(missing, 2)});
}

/** Of the spring that leaves it free. */
function strength_rows({cases, best_F1, why_no_F1}: LoadReport, {requirements, unit}: About): ReadOutRow[] {
  if (best_F1 === undefined && why_no_F1 === undefined) return [];
  const told =
    best_F1 === undefined
      ? {text: none, limit: t("loads.no_f1")}
      : {text: force_text(best_F1), limit: missed_limit("best_F1", best_F1, undefined, {requirements, unit})};
  return [{key: "best_F1", worst: null, name: t("loads.best_f1"), values: cases.map(() => told)}];
}
function stroke_rows({cases}: LoadReport, unit: string): ReadOutRow[] {
  const gas = (cases[0]?.springs ?? []).flatMap(({stroke_left}, i) => (stroke_left === null ? [] : [i]));
  return gas.map((i) => ({
    key: `stroke_left_${i + 1}`,
    worst: null,
    name: gas.length > 1 ? t("loads.stroke_left_of", {name: cases[0]!.springs[i]!.name}) : t("loads.stroke_left"),
    values: cases.map(({springs}) => {
      const {stroke_left, bottoms_at} = springs[i]!,
        length = with_unit(significant(stroke_left ?? 0, digits), unit);
      return {text: length, limit: bottoms_at ? t("loads.beyond_stroke", {length}) : null};
    }),
  }));
}
export function read_out_rows(report: LoadReport, about: About): ReadOutRow[] {
  const {cases} = report;
  const worst_of = (read_out: ReadOut) => (cases.length > 1 ? (report.worst[read_out]?.case ?? null) : null);
  const plain = (key: ReadOut, name: string, text: (of: LoadCaseReport) => string): ReadOutRow => ({
    key,
    name,
    worst: worst_of(key),
    values: cases.map((of) => ({text: text(of), limit: null})),
  });
  const limited = (
    read_out: Exclude<Limited, "best_F1">,
    name: string,
    value: (of: LoadCaseReport) => number | null,
    text: (of: LoadCaseReport) => string = (of) => force_text(value(of)),
  ): ReadOutRow => ({
    key: read_out,
    name,
    worst: worst_of(read_out),
    values: cases.map((of, i) => ({
      text: text(of),
      limit: missed_limit(read_out, value(of), about.cases[i], about),
    })),
  });
  const pin_text = (of: LoadCaseReport) => {
    const pin = largest_pin(of);
    return pin ? t("loads.at_pin", {force: force_text(pin.force), pin: t(`loads.pin_${pin.joint}`)}) : none;
  };
  const has = (key: "max_open_force" | "max_torque" | "cylinder_force") => cases.some((of) => of[key] !== null);
  return [
    ...strength_rows(report, about),
    ...(has("max_open_force")
      ? [
          {...limited("max_open_force", t("loads.opens_with"), (of) => of.max_open_force), term: "hand_force" as const},
          limited("max_close_force", t("loads.closes_with"), (of) => of.max_close_force),
          {...limited("hold_open", t("loads.holds_open"), (of) => of.hold_open), term: "hold_open" as const},
          plain("hump", t("loads.hump"), (of) => force_text(of.hump)),
          limited(
            "self_rise",
            t("loads.rises_from"),
            ({self_rise}) => turn_of(self_rise),
            ({self_rise}) => place_text(self_rise),
          ),
          limited(
            "self_close",
            t("loads.closes_from"),
            ({self_close}) => turn_of(self_close) ?? 0,
            ({self_close}) => closing_text(self_close),
          ),
        ]
      : []),
    ...(has("max_torque")
      ? [
          limited(
            "max_torque",
            t("loads.torque"),
            (of) => of.max_torque,
            (of) => torque_text(of.max_torque, about.unit),
          ),
        ]
      : []),
    ...(has("cylinder_force") ? [limited("cylinder_force", t("loads.cylinder_force"), (of) => of.cylinder_force)] : []),
    limited("max_pin_force", t("loads.largest_pin"), (of) => largest_pin(of)?.force ?? null, pin_text),
    ...(cases.some(({shaking}) => shaking)
      ? [
          {
            key: "shaking",
            name: t("loads.shaking"),
            worst: null,
            values: cases.map(({shaking}) => ({text: force_text(shaking?.max ?? null), limit: null})),
          },
        ]
      : []),
    ...stroke_rows(report, about.unit),
  ];
}
