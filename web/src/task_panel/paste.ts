// A block of numbers from a spreadsheet or a text file, as it comes from the clipboard.
import {evaluated, type Quantity} from "./arithmetic";

export type Block =
  {rows: number[][]; from_points?: boolean} | {fault: {row: number; column: number; text: string}} | {too_many: number}; // rows

export const most_pasted_rows = 100;

/** Cells of the text, by rows. Separators in order of certainty: tab, semicolon, comma with a space, space, comma. */
export function cells_of(text: string): string[][] {
  const lines = text
    .split(/\r\n|\r|\n/)
    .map((line) => line.replace(/[ \u00a0]+$/, ""))
    .filter((line) => line.trim() !== "");
  const separator = separator_of(lines);
  return lines.map((line) => (separator === "\t" ? line : line.trim()).split(separator).map((cell) => cell.trim()));
}
function separator_of(lines: string[]): string | RegExp {
  if (lines.some((line) => line.includes("\t"))) return "\t";
  if (lines.some((line) => line.includes(";"))) return /\s*;\s*/;
  if (lines.some((line) => /,\s/.test(line))) return /,\s+/;
  if (lines.some((line) => /\S\s+\S/.test(line.trim()))) return /\s+/;
  return ",";
}

/** Whether the text is more than one number: only then a paste is a block. "1,5" and "1 234,5" are one number each. */
export function is_block(text: string): boolean {
  const [row, ...more] = cells_of(text);
  if (!row || more.length > 0) return more.length > 0;
  if (/[\t;]/.test(text.trim())) return row.length > 1;
  if (!row.every((cell) => "value" in evaluated(cell, "angle"))) return false;
  const one = /^[-−]?\d{1,3}[\s\u202f]\d{3}([.,]\d+)?$|^[^\s]*,[^\s,]*$/.test(text.trim());
  return row.length > 2 || (row.length === 2 && !one);
}

/** Numbers of the block whose first column is column `from` of x, y, θ. A heading and a counting first column are left
 *  out. Four columns x₁ y₁ x₂ y₂ that keep their distance from row to row are two points of the body: its place is the
 *  first, its direction that to the second. */
export function block_of(text: string, from = 0, unit = ""): Block {
  let cells = cells_of(text);
  const [head, ...body] = cells;
  const skipped = head && body.length > 0 && head.every((cell) => !("value" in evaluated(cell, "angle", unit))) ? 1 : 0;
  cells = without_numbering(cells.slice(skipped), 3 - from);
  if (cells.length > most_pasted_rows) return {too_many: cells.length};
  const points = from === 0 ? two_points_of(cells, unit) : null;
  if (points) return {rows: points, from_points: true};
  const rows: number[][] = [];
  for (const [r, row] of cells.entries()) {
    const numbers: number[] = [];
    for (const [c, cell] of row.slice(0, 3 - from).entries()) {
      const quantity: Quantity = from + c === 2 ? "angle" : "length";
      const reading = evaluated(cell, quantity, unit);
      if ("fault" in reading) return {fault: {row: r + skipped + 1, column: c + 1, text: cell}};
      numbers.push(reading.value);
    }
    rows.push(numbers);
  }
  return {rows};
}
function two_points_of(cells: string[][], unit: string): number[][] | null {
  const within = 0.01, // of the distance, as drawings are measured
    quads: number[][] = [];
  for (const row of cells) {
    const numbers = row.map((cell) => evaluated(cell, "length", unit));
    if (row.length !== 4 || !numbers.every((reading) => "value" in reading)) return null;
    quads.push(numbers.map(({value}) => value));
  }
  const lengths = quads.map(([x1, y1, x2, y2]) => Math.hypot(x2! - x1!, y2! - y1!)),
    [first] = lengths;
  if (quads.length < 2 || !lengths.every((length) => length > 0 && Math.abs(length - first!) <= within * first!))
    return null;
  return quads.map(([x1, y1, x2, y2]) => [x1!, y1!, (Math.atan2(y2! - y1!, x2! - x1!) * 180) / Math.PI]);
}
function without_numbering(cells: string[][], wanted: number): string[][] {
  const counts =
    cells.length > 0 &&
    cells.every((row, i) => row.length === wanted + 1 && row[0]?.replace(/\D+/g, "") === String(i + 1));
  return counts ? cells.map((row) => row.slice(1)) : cells;
}
