// The colours of a small map: in full what meets everything, washed what is only free of defects, grey the rest.
import {degenerate, linkage_types} from "../contract/messages";
import type {Thumbnail} from "../engine/stored";
import {mixed, rgb_of, washed_share} from "../region/palette";

/** Pixels from the top: the input's place upwards, the output's to the right. `defect`: the bit of what has one. */
export function painted(
  {rows, columns, type, fails}: Pick<Thumbnail, "rows" | "columns" | "type" | "fails">,
  colors: Record<string, string>,
  defect: number,
): Uint8ClampedArray<ArrayBuffer> {
  const paper = rgb_of(colors.paper!),
    grey = rgb_of(colors.hatch!);
  const full = linkage_types.map((name) => rgb_of(colors[name]!)),
    faint = full.map((color) => mixed(color, paper, washed_share));
  const pixels = new Uint8ClampedArray(4 * rows * columns);
  for (let row = 0; row < rows; ++row) {
    for (let column = 0; column < columns; ++column) {
      const cell = row * columns + column,
        at = 4 * ((rows - 1 - row) * columns + column);
      const color =
        type[cell] === degenerate
          ? paper
          : fails[cell] === 0
            ? full[type[cell]!]!
            : fails[cell]! & defect
              ? grey
              : faint[type[cell]!]!;
      pixels.set(color, at);
      pixels[at + 3] = 255;
    }
  }
  return pixels;
}
