// Contacts of a path with its line: four points in all, in one of few patterns.
import type {Contact} from "./task";

/** Multiplicities, one after the other along the line. */
export const patterns = ["P-P-P-P", "PP-P-P", "P-PP-P", "P-P-PP", "PP-PP", "PPP-P", "P-PPP"] as const;

export function pattern_of_contacts(contacts: readonly Contact[]): string {
  return contacts.map(({multiplicity}) => "P".repeat(Math.min(Math.max(multiplicity, 1), 9))).join("-");
}
/** From the first to the last as before; as many as there were stay where they are, others lie evenly between. */
export function with_pattern(contacts: readonly Contact[], pattern: string): Contact[] {
  const multiplicities = pattern.split("-").map((points) => points.length),
    first = contacts[0]?.s ?? 0,
    last = contacts.at(-1)?.s ?? first + 1,
    keeps = multiplicities.length === contacts.length;
  return multiplicities.map((multiplicity, i) => {
    const even = Number((first + ((last - first) * i) / (multiplicities.length - 1)).toPrecision(6)),
      before = keeps ? contacts[i] : undefined;
    return {...before, s: before?.s ?? even, multiplicity};
  });
}
