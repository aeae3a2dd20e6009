// What is found of a linkage as plates on pins, in words.
import type {MachinePlan, PlateCrossing} from "../contract/messages";
import {degrees_text} from "../texts/numbers";
import {t} from "../texts/texts.svelte";
import type {Mechanism} from "./mechanism";

const most_told = 3;

type Named = Pick<Mechanism, "plate_words">;

export function crossing_text({plate_words}: Named, {body, pin, other, from_deg, to_deg}: PlateCrossing): string {
  const values = {link: plate_words.body(body), from: degrees_text(from_deg, 0), to: degrees_text(to_deg, 0)};
  return pin === undefined
    ? t("solid.cross", {...values, other: plate_words.body(other ?? "")})
    : t("solid.meets_pin", {...values, pin: plate_words.pin(pin)});
}
export function crossings_told(mechanism: Named, {crossings}: MachinePlan): string[] {
  return crossings.slice(0, most_told).map((crossing) => crossing_text(mechanism, crossing));
}
