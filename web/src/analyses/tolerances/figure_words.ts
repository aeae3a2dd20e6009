// How tolerances and the errors that they make are said.
import type {Linkage, ToleranceFigures} from "../../contract/messages";
import {limit_of, type Tolerances} from "./block";
import {joints_of, lengths_of} from "../../kinds/kind_dispatch";
import {percent_text, significant, with_unit} from "../../texts/numbers";
import {known_text, t, type TextKey} from "../../texts/texts.svelte";

const digits = 3;

export function error_text(error: number, of: ToleranceFigures["unit"], unit: string): string {
  return of === "degrees" ? `${significant(error, digits)}°` : with_unit(significant(error, digits), unit);
}
/** Where the linear figure is off, the sampled one. */
const listed_error = (of: ToleranceFigures) => (of.beyond_first_order ? of.error_sampled : of.error);
/** "0.66 mm RMS, 5.1 mm at worst · yield 98.4 %" */
export function figures_text(of: ToleranceFigures, unit: string): string {
  const [error, worst] = [listed_error(of), of.worst_case].map((value) => error_text(value, of.unit, unit)) as [
    string,
    string,
  ];
  if (of.yield === null) return t("tolerance.figures", {error, worst});
  return t("tolerance.figures_yield", {error, worst, yield: percent_text(of.yield)});
}
/** "82.9 %"; next to 1 it keeps the digits in which it differs from it. */
export function share_text(share: number, certain = digits): string {
  return `${significant(100 * share, share >= 0.99 && share < 1 ? certain + 2 : certain)} %`;
}
/** "output link", "fixed pivot of the input, x". */
export function dimension_name(parameter: string, hand: Linkage): string {
  const own = lengths_of(hand)?.find(({key}) => key === parameter || `length ${key}` === parameter);
  if (own) return own.name;
  const [, center, axis] = /^(.*)_([xy])$/.exec(parameter) ?? [];
  if (center && axis) return t(axis === "x" ? "study.axis_x" : "study.axis_y", {name: pivot_name(center, hand)});
  return known_text(`study.of_${parameter}`) ?? known_text(`num.${parameter}`) ?? parameter;
}
function pivot_name(center: string, hand: Linkage): string {
  const joint = joints_of(hand)?.find(({key}) => `center_${key}` === center);
  return joint?.name ?? known_text(`study.of_${center}`) ?? center;
}
/** Of the tolerances: "2 mm", "0.5°". */
export function limit_text(tolerances: Tolerances, unit: string): string {
  const limit = limit_of(tolerances);
  return limit ? error_text(limit.value, limit.kind === "angle_deg" ? "degrees" : "length", unit) : "";
}
/** In the unit of the errors; nothing where it is of something else. */
export function limit_on_scale(tolerances: Tolerances, of: ToleranceFigures["unit"]): number | null {
  const limit = limit_of(tolerances);
  return limit && (limit.kind === "angle_deg") === (of === "degrees") ? limit.value : null;
}
/** What stands on the printed sheet and in the card: name and value. */
export function figure_rows(figures: ToleranceFigures, unit: string): {key: TextKey; value: string}[] {
  const error = (value: number) => error_text(value, figures.unit, unit);
  const [low, high] = figures.yield_interval ?? [0, 0];
  return [
    {
      key: "study.error",
      value: t("study.error_text", {error: error(listed_error(figures))}),
    },
    ...(figures.error_realigned === undefined
      ? []
      : [{key: "study.realigned" as const, value: t("study.error_text", {error: error(figures.error_realigned)})}]),
    {key: "study.worst_case", value: error(figures.worst_case)},
    {key: "study.three_sigma", value: error(figures.mean_plus_3_sigma)},
    ...(figures.yield === null
      ? []
      : [
          {
            key: "study.yield" as const,
            value: t("study.yield_text", {
              share: share_text(figures.yield),
              low: share_text(low),
              high: share_text(high),
            }),
          },
        ]),
  ];
}
