// What tolerances do to a linkage, in a line.
import type {ToleranceFigures} from "../engine/protocol";
import {percent_text, significant, with_unit} from "../texts/numbers";
import {t} from "../texts/texts.svelte";

/** "0.66 mm": where the linear figure is off, the sampled one. */
export function error_text(of: ToleranceFigures, unit: string): string {
  const error = of.beyond_first_order ? of.error_sampled : of.error;
  return with_unit(significant(error, 3), of.unit === "degrees" ? "°" : unit);
}
/** "± 0.66 mm · yield 98.4 %" */
export function figures_text(of: ToleranceFigures, unit: string): string {
  const error = error_text(of, unit);
  if (of.yield === null) return t("tolerance.figures", {error});
  return t("tolerance.figures_yield", {error, yield: percent_text(of.yield)});
}
