// The colours of a small map: in full what meets everything, washed what is only free of defects, grey the rest.
import {linkage_types, requirement_keys} from "../engine/protocol";
import type {Thumbnail} from "../engine/stored";

const degenerate = linkage_types.indexOf("degenerate");
const defect = 1 << requirement_keys.indexOf("no_defects");
const washed = 0.3;

type Color = readonly [number, number, number];
function color_of(hex: string): Color {
  const number = parseInt(hex.replace("#", ""), 16);
  return [(number >> 16) & 255, (number >> 8) & 255, number & 255];
}
function mixed(a: Color, b: Color, share: number): Color {
  return [0, 1, 2].map((i) => Math.round(share * a[i] + (1 - share) * b[i])) as unknown as Color;
}

/** Pixels from the top: the input's place upwards, the output's to the right. */
export function painted({samples, type, fails}: Pick<Thumbnail, "samples" | "type" | "fails">, colors: Record<string, string>): Uint8ClampedArray<ArrayBuffer> {
  const paper = color_of(colors.paper), grey = color_of(colors.hatch);
  const full = linkage_types.map((name) => color_of(colors[name])), faint = full.map((color) => mixed(color, paper, washed));
  const pixels = new Uint8ClampedArray(4 * samples * samples);
  for (let row = 0; row < samples; ++row) {
    for (let column = 0; column < samples; ++column) {
      const cell = row * samples + column, at = 4 * ((samples - 1 - row) * samples + column);
      const color = type[cell] === degenerate ? paper : fails[cell] === 0 ? full[type[cell]] : fails[cell] & defect ? grey : faint[type[cell]];
      pixels.set(color, at);
      pixels[at + 3] = 255;
    }
  }
  return pixels;
}
