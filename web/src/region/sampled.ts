// Which cells of a map have a yield of their own.
import type {MapAnswer} from "../contract/messages";

const coarsest = 16; // cells a side

/** 1 where a cell is among the first `done` that the engine samples (src/solve/yield_map.cpp): of those that fail
 *  nothing but `ignored` (bits) every 16th row and column, then every 8th, and at last all. */
export function sampled_cells(
  {rows, columns, fails}: Pick<MapAnswer, "rows" | "columns" | "fails">,
  done: number,
  ignored: number,
): Uint8Array {
  const sampled = new Uint8Array(rows * columns);
  let left = done;
  for (let side = coarsest; side > 0; side >>= 1)
    for (let row = 0; row < rows; row += side)
      for (let column = 0; column < columns; column += side) {
        const cell = row * columns + column;
        if (sampled[cell] || (fails[cell]! & ~ignored) !== 0) continue;
        if (left-- <= 0) return sampled;
        sampled[cell] = 1;
      }
  return sampled;
}
