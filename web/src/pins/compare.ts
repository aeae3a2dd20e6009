// Pinned linkages side by side: what is compared, which is best, in which order, and as a table to take away.
import type {Linkage} from "../contract/messages";
import type {Pin} from "../state/problem";
import {lengths_of} from "../kinds/kind_dispatch";
import {least_of, most_of} from "../state/ends";

export const compared = [
  "min_transmission_angle_deg",
  "min_transmission_angle_full_turn_deg",
  "link_ratio",
  "longest",
  "ground",
  "input",
  "coupler",
  "output",
  "driver_sweep_deg",
] as const;
export type Compared = (typeof compared)[number];

/** Which end is the better one; nothing where it is a matter of taste. */
export const better: Partial<Record<Compared, "high" | "low">> = {
  min_transmission_angle_deg: "high",
  min_transmission_angle_full_turn_deg: "high",
  link_ratio: "low",
  longest: "low",
};

export interface Column {
  pin: Pin;
  linkage: Linkage | null; // null: not here yet, or the engine refused it
}

export function value_of({pin, linkage}: Column, key: Compared): number | null {
  if (key === "ground" || key === "input" || key === "coupler" || key === "output")
    return (linkage?.lengths ?? pin.lengths)?.[key] ?? (linkage && own_length(linkage, key));
  if (key === "driver_sweep_deg" || key === "min_transmission_angle_full_turn_deg") return linkage?.[key] ?? null;
  return linkage ? linkage[key] : pin[key];
}

/** As its kind tells it, where it is no four-bar of the plane. */
function own_length(linkage: Linkage, key: string): number | null {
  return lengths_of(linkage)?.find((named) => named.key === key)?.length ?? null;
}

/** Of the values, those that are best; none where all are equal or only one is known. */
export function best_of(values: (number | null)[], end: "high" | "low" | undefined): boolean[] {
  const known = values.filter((v): v is number => v !== null);
  const best = end === "high" ? most_of(known) : least_of(known);
  const none = !end || known.length < 2 || known.every((v) => v === best);
  return values.map((v) => !none && v === best);
}

/** Columns by a row, the better end first (rising where neither is), unknown last; `reversed`: the other end first. */
export function sorted_by(columns: readonly Column[], key: Compared, reversed: boolean): Column[] {
  const sign = (better[key] === "high" ? -1 : 1) * (reversed ? -1 : 1);
  return [...columns].sort((a, b) => {
    const x = value_of(a, key),
      y = value_of(b, key);
    if (x === null || y === null) return Number(x === null) - Number(y === null);
    return sign * (x - y);
  });
}

/** Comma separated, all digits. Names and notes are the user's: quoted, and never a formula. */
export function table_csv(
  columns: readonly Column[],
  headings: {name: string; note: string; type: string; rows: Record<Compared, string>},
  type_name: (c: Column) => string,
): string {
  const rows = [
    [headings.name, ...columns.map((c) => c.pin.name)],
    [headings.type, ...columns.map(type_name)],
    ...compared.map((key) => [headings.rows[key], ...columns.map((c) => String(value_of(c, key) ?? ""))]),
    [headings.note, ...columns.map((c) => c.pin.note ?? "")],
  ];
  return `${rows.map((row) => row.map(csv_cell).join(",")).join("\r\n")}\r\n`;
}
function csv_cell(text: string): string {
  const harmless = /^[=+@\t\r]|^-(?![\d.])/.test(text) ? `'${text}` : text;
  return /[",\r\n;]/.test(harmless) ? `"${harmless.replaceAll('"', '""')}"` : harmless;
}
