// Where both axes have sheets, the map has a part for each pair of them.
import type {Axis, MapAnswer, TaskAnswer, Window} from "../engine/protocol";

export interface Sheet {
  name: string; // I, II, …
  input: number;
  output: number; // blocks
  window: Window;
  empty: boolean;
}
const names = ["I", "II", "III", "IV", "V", "VI", "VII", "VIII"];

function has_sheets(axis: Axis): boolean {
  return axis.blocks.length > 1 && axis.branches.every(({name}) => /^(sheet_|direct$|opposite$)/.test(name));
}
/** `map`: of the whole region. Row by row, as the cells go. */
export function sheets_of({axes: {input, output}}: TaskAnswer, map: MapAnswer | null): Sheet[] {
  if (!has_sheets(input) || !has_sheets(output)) return [];
  const pairs = input.blocks.flatMap((row, i) => output.blocks.map((column, k) => ({row, column, i, k})));
  return pairs.slice(0, names.length).map(({row, column, i, k}, at) => {
    const window: Window = {input: [row.from, row.to], output: [column.from, column.to]};
    return {name: names[at], input: i, output: k, window, empty: map !== null && is_empty(map, window)};
  });
}
function is_empty(map: MapAnswer, {input, output}: Window): boolean {
  const rows = [input[0] * map.rows, input[1] * map.rows].map(Math.round),
    columns = [output[0] * map.columns, output[1] * map.columns].map(Math.round);
  for (let row = rows[0]; row < rows[1]; ++row) {
    for (let column = columns[0]; column < columns[1]; ++column)
      if (map.type[row * map.columns + column] < 9) return false;
  }
  return true;
}
