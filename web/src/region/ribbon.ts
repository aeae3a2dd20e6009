// The plot under a map of one column: a property along the coordinate.
import {round_step} from "../state/problem";
import {degenerate} from "../contract/messages";
import type {MapAnswer, Property} from "../contract/messages";
import {pixel_of, type Scale} from "./scale";

export interface RibbonLine {
  /** All its linkages meet the requirements. */
  meets: boolean;
  points: {at: number; value: number}[]; // pixels along the ribbon
}

/** Stretches of linkages with a value, those that meet the requirements apart from the others. */
export function ribbon_lines(map: MapAnswer, scale: Scale): RibbonLine[] {
  const lines: RibbonLine[] = [],
    {
      rows,
      value,
      fails,
      type,
      window: {
        input: [from, to],
      },
    } = map;
  let last: RibbonLine | null = null,
    piece = -1;
  for (let row = 0; row < rows; ++row) {
    const place = from + ((row + 0.5) / rows) * (to - from),
      meets = fails[row] === 0;
    const here = scale.pieces.findIndex((p) => place >= p.from && place <= p.to);
    if (value[row] === 0 || type[row]! === degenerate || here < 0) {
      last = null;
      continue;
    }
    const point = {at: pixel_of(scale, place), value: value[row]!};
    if (!last || piece !== here) lines.push((last = {meets, points: []}));
    else if (last.meets !== meets) {
      const before: RibbonLine = last;
      lines.push((last = {meets, points: before.points.slice(-1)})); // no gap where it changes
    }
    piece = here;
    last.points.push(point);
  }
  return lines.filter(({points}) => points.length > 1);
}

export interface RibbonBar {
  from: number;
  to: number;
  value: number;
  meets: boolean;
}
/** Of a map of one row with a few columns: of those with a value. */
export function ribbon_bars({columns, value, fails, type}: MapAnswer, scale: Scale): RibbonBar[] {
  return scale.pieces
    .slice(0, columns)
    .flatMap(({start, end}, column) =>
      value[column] === 0 || type[column]! === degenerate
        ? []
        : [{from: start, to: end, value: value[column]!, meets: fails[column] === 0}],
    );
}

/** The greatest value shown. Some grow without bound: the rest is to be seen. */
export function axis_top(property: Property, values: readonly number[], limit: number | null): number {
  if (property.startsWith("min_transmission_angle")) return 90;
  if (property === "driver_sweep_deg") return 360;
  const sorted = [...values].sort((a, b) => a - b),
    usual = sorted[Math.floor(0.85 * (sorted.length - 1))] ?? 1;
  return Math.max(1.15 * usual, limit === null ? 0 : Math.min(1.1 * limit, 3 * usual)) || 1;
}
/** Round values from 0 up, as many as there is room for. */
export function even_ticks(top: number, pixels: number): number[] {
  const step = top === 90 ? 30 : top === 360 ? 90 : round_step(top / Math.max(Math.floor(pixels / 28), 1));
  return Array.from({length: Math.floor(top / step + 1e-9) + 1}, (_, i) => Number((i * step).toPrecision(6)));
}
