// Where both axes have sheets, the map has a part for each pair of them; where a place has several linkages, one to each
// of its layers.
import {degenerate} from "../contract/messages";
import type {Axis, MapAnswer, TaskAnswer, MapWindow} from "../contract/messages";
import {has_layers} from "./axis_marks";

export interface Sheet {
  name: string; // I, II, …
  input: number;
  output: number; // blocks
  window: MapWindow;
  empty: boolean;
}
const names = ["I", "II", "III", "IV", "V", "VI", "VII", "VIII"];

function has_sheets(axis: Axis): boolean {
  return axis.blocks.length > 1 && axis.branches.every(({name}) => /^(sheet_|direct$|opposite$)/.test(name));
}
/** `map`: of the whole region. Row by row, as the cells go. */
export function sheets_of({axes: {input, output}}: TaskAnswer, map: MapAnswer | null): Sheet[] {
  if (!has_layers(input) && (!has_sheets(input) || !has_sheets(output))) return [];
  const pairs = input.blocks.flatMap((row, i) => output.blocks.map((column, k) => ({row, column, i, k})));
  return pairs.flatMap(({row, column, i, k}, at) => {
    const name = names[at];
    if (!name) return [];
    const window: MapWindow = {input: [row.from, row.to], output: [column.from, column.to]};
    return [{name, input: i, output: k, window, empty: map !== null && is_empty(map, window)}];
  });
}
function is_empty(map: MapAnswer, {input, output}: MapWindow): boolean {
  const last_row = Math.round(input[1] * map.rows),
    last_column = Math.round(output[1] * map.columns);
  for (let row = Math.round(input[0] * map.rows); row < last_row; ++row) {
    for (let column = Math.round(output[0] * map.columns); column < last_column; ++column)
      if (map.type[row * map.columns + column]! !== degenerate) return false;
  }
  return true;
}
