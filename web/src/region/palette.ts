// Colours of the map: the page's tokens, and the table from what a cell is to its pixel.
import {degenerate, linkage_types} from "../contract/messages";
import {css_values} from "../state/css_values";

export type Rgb = readonly [number, number, number];
export interface Palette {
  types: Rgb[]; // by type code
  paper: Rgb;
  defect: Rgb;
  hatch: Rgb;
  ink: Rgb;
}

export function rgb_of(hex: string): Rgb {
  const digits = hex.trim().replace("#", "");
  const long = digits.length === 3 ? [...digits].map((d) => d + d).join("") : digits;
  return [0, 2, 4].map((i) => parseInt(long.slice(i, i + 2), 16)) as unknown as Rgb;
}
export function read_palette(): Palette {
  const values = css_values(document.documentElement, [...linkage_types, "paper", "defect", "hatch", "ink"]),
    token = (name: keyof typeof values) => rgb_of(values[name]);
  return {
    types: linkage_types.map(token),
    paper: token("paper"),
    defect: token("defect"),
    hatch: token("hatch"),
    ink: token("ink"),
  };
}

export function mixed(color: Rgb, ground: Rgb, share: number): Rgb {
  return color.map((c, i) => Math.round(share * c + (1 - share) * ground[i]!)) as unknown as Rgb;
}
export function css(color: Rgb, alpha = 1): string {
  return `rgba(${color.join(",")},${alpha})`;
}
/** As a pixel of an ImageData seen as Uint32 (little endian). */
export function pixel(color: Rgb, alpha = 255): number {
  return ((alpha << 24) | (color[2] << 16) | (color[1] << 8) | color[0]) >>> 0;
}

const ramp_stops = ["2b1d5c", "3a4a9c", "2f7fb0", "3faea0", "9ad07a", "fbe886"].map(rgb_of);
/** Sequential ramp, 0 bad and dark … 1 good and light. */
export function ramp(share: number): Rgb {
  const x = Math.min(Math.max(share, 0), 1) * (ramp_stops.length - 1);
  const k = Math.min(Math.floor(x), ramp_stops.length - 2);
  return mixed(ramp_stops[k + 1]!, ramp_stops[k]!, x - k);
}

/** Half of the way to the grey that is as light. */
export function pale(color: Rgb): Rgb {
  const grey = Math.round(0.3 * color[0] + 0.59 * color[1] + 0.11 * color[2]);
  return mixed(color, [grey, grey, grey], 0.5);
}

export const washed_share = 0.3;
const faded_share = 0.15,
  seen_through = 170;

/** What a cell is: code | 16 if it meets everything | its defect bits << 5 | 256 if its value stands for another's. */
export const cell_kinds = 512;
export function cell_kind(type: number, defects: number, fails: number): number {
  return type | (fails === 0 ? 16 : 0) | (defects << 5);
}

export interface Look {
  palette: Palette;
  only_meeting: boolean;
  type_hover: number | null;
}
type Level = "clear" | "paper" | "full" | "washed" | "through";
function level_of(kind: number, look: Look): Level {
  const type = kind & 15,
    meets = (kind & 16) !== 0,
    defects = (kind >> 5) & 7;
  if (type === degenerate) return "paper";
  if (look.only_meeting && !meets) return "paper";
  if (defects) return meets ? "through" : "clear"; // the hatching below shows
  return meets ? "full" : "washed";
}
function shown(color: Rgb, level: Level, faded: boolean, paper: Rgb): number {
  const strength = (level === "washed" ? washed_share : 1) * (faded ? faded_share : 1);
  if (level === "clear") return 0;
  if (level === "paper") return pixel(paper);
  return pixel(mixed(color, paper, strength), level === "through" ? seen_through : 255);
}
function faded(kind: number, look: Look): boolean {
  return look.type_hover !== null && (kind & 15) !== look.type_hover;
}

/** Pixels by kind of cell, coloured by type. */
export function type_table(look: Look): Uint32Array {
  const {palette} = look;
  return Uint32Array.from({length: cell_kinds}, (_, kind) =>
    shown(palette.types[kind & 15] ?? palette.paper, level_of(kind, look), faded(kind, look), palette.paper),
  );
}

export const ramp_steps = 256;
/** Pixels by (row of the kind, step of the ramp): rows[kind] is the offset of its row in `pixels`. */
export function ramp_table(look: Look): {rows: Uint32Array; pixels: Uint32Array} {
  const {paper} = look.palette;
  const rows = new Uint32Array(cell_kinds),
    known = new Map<string, number>(),
    pixels: number[] = [];
  for (let kind = 0; kind < cell_kinds; ++kind) {
    const level = level_of(kind, look),
      dim = faded(kind, look),
      of_another = kind >= 256,
      name = `${level} ${dim} ${of_another}`;
    if (!known.has(name)) {
      known.set(name, pixels.length);
      for (let i = 0; i < ramp_steps; ++i) {
        const color = ramp(i / (ramp_steps - 1));
        pixels.push(shown(of_another ? pale(color) : color, level, dim, paper));
      }
    }
    rows[kind] = known.get(name)!;
  }
  return {rows, pixels: Uint32Array.from(pixels)};
}
