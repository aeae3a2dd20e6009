// Contour lines of the map's values: marching squares over the cells' middles, chained into polylines.

/** Points as (column, row), in cells from the middle of the first. */
export interface Contour {
  level: number;
  lines: Float32Array[];
}
export interface Field {
  rows: number;
  columns: number;
  value: ArrayLike<number>;
  /** A square with a corner that is not counted is left out. */
  counts(index: number): boolean;
  /** Rows (columns) k where cell k − 1 and k lie in different blocks. */
  row_breaks: ReadonlySet<number>;
  column_breaks: ReadonlySet<number>;
  stride: number;
}

export function contours(field: Field, levels: readonly number[]): Contour[] {
  const grid = thinned(field);
  return levels.map((level) => ({level, lines: chained(segments(grid, level), grid, level)}));
}

interface Grid {
  rows: Int32Array; // indices into the field
  columns: Int32Array;
  value: Float32Array; // NaN where not counted
  row_cut: Uint8Array;
  column_cut: Uint8Array; // 1: no squares between k − 1 and k
}
function thinned({value, counts, row_breaks, column_breaks, stride, ...field}: Field): Grid {
  const every = (count: number) =>
    Int32Array.from({length: Math.floor((count - 1) / stride) + 1}, (_, i) => i * stride);
  const rows = every(field.rows),
    columns = every(field.columns),
    values = new Float32Array(rows.length * columns.length);
  for (let r = 0; r < rows.length; ++r) {
    for (let c = 0; c < columns.length; ++c) {
      const index = rows[r]! * field.columns + columns[c]!;
      values[r * columns.length + c] = counts(index) ? value[index]! : NaN;
    }
  }
  const cut = (kept: Int32Array, breaks: ReadonlySet<number>) => {
    const cuts = new Uint8Array(kept.length);
    for (let k = 1; k < kept.length; ++k)
      for (let j = kept[k - 1]! + 1; j <= kept[k]!; ++j) if (breaks.has(j)) cuts[k] = 1;
    return cuts;
  };
  return {rows, columns, value: values, row_cut: cut(rows, row_breaks), column_cut: cut(columns, column_breaks)};
}

// Edges of the grid of m columns: 2 (r m + c) from (r, c) to the next column, + 1 to the next row. By the corners above the level
// (1 lower left, 2 lower right, 4 upper right, 8 upper left): pairs of the square's edges, 0 bottom, 1 right, 2 top, 3 left.
const cases: readonly (readonly number[])[] = [
  [],
  [3, 0],
  [0, 1],
  [3, 1],
  [1, 2],
  [3, 0, 1, 2],
  [0, 2],
  [3, 2],
  [2, 3],
  [0, 2],
  [0, 1, 2, 3],
  [1, 2],
  [3, 1],
  [0, 1],
  [3, 0],
  [],
];

function segments({rows, columns: {length: n}, value, row_cut, column_cut}: Grid, level: number): number[] {
  const found: number[] = [];
  for (let r = 0; r + 1 < rows.length; ++r) {
    if (row_cut[r + 1]) continue;
    for (let c = 0; c + 1 < n; ++c) {
      const at = r * n + c,
        a = value[at],
        b = value[at + 1],
        d = value[at + n],
        e = value[at + n + 1];
      const code = (a! >= level ? 1 : 0) | (b! >= level ? 2 : 0) | (e! >= level ? 4 : 0) | (d! >= level ? 8 : 0);
      if (code === 0 || code === 15 || column_cut[c + 1] || a !== a || b !== b || d !== d || e !== e) continue;
      const edges = [2 * at, 2 * (at + 1) + 1, 2 * (at + n), 2 * at + 1];
      for (const side of cases[code]!) found.push(edges[side]!);
    }
  }
  return found;
}

function chained(pairs: readonly number[], grid: Grid, level: number): Float32Array[] {
  const touching = new Map<number, number[]>(); // edge → segments
  for (let s = 0; s < pairs.length; ++s) {
    const list = touching.get(pairs[s]!);
    if (list) list.push(s >> 1);
    else touching.set(pairs[s]!, [s >> 1]);
  }
  const used = new Uint8Array(pairs.length >> 1),
    lines: Float32Array[] = [];
  const run = (segment: number, start: number): number[] => {
    const edges = [start];
    for (let edge = start, next: number | undefined = segment; next !== undefined;) {
      used[next] = 1;
      edge = (pairs[2 * next] === edge ? pairs[2 * next + 1] : pairs[2 * next])!;
      edges.push(edge);
      next = touching.get(edge)!.find((other) => !used[other]);
    }
    return edges;
  };
  const open_first = [...touching].flatMap(([edge, [segment, ...more]]) =>
    segment === undefined || more.length > 0 ? [] : [{segment, edge}],
  );
  for (const {segment, edge} of open_first) if (!used[segment]) lines.push(points(run(segment, edge), grid, level));
  for (let s = 0; s < used.length; ++s) if (!used[s]) lines.push(points(run(s, pairs[2 * s]!), grid, level));
  return lines;
}

function points(edges: readonly number[], {value, rows, columns}: Grid, level: number): Float32Array {
  const n = columns.length;
  const line = new Float32Array(2 * edges.length);
  edges.forEach((edge, i) => {
    const at = edge >> 1,
      next = edge & 1 ? at + n : at + 1;
    const share = (level - value[at]!) / (value[next]! - value[at]!);
    const row = Math.floor(at / n),
      column = at % n;
    const along = (kept: Int32Array, k: number, on: boolean) => kept[k]! + (on ? share * (kept[k + 1]! - kept[k]!) : 0);
    line[2 * i] = along(columns, column, !(edge & 1));
    line[2 * i + 1] = along(rows, row, (edge & 1) === 1);
  });
  return line;
}

/** Where a line is straightest over about `length`: middle and direction; nothing if it is shorter. */
export function straightest(line: ArrayLike<number>, length: number): {x: number; y: number; angle: number} | null {
  const count = line.length / 2;
  let best: {x: number; y: number; angle: number} | null = null,
    straightness = 0.9;
  for (let i = 0, j = 0, arc = 0; i < count; ++i) {
    while (j + 1 < count && arc < length) {
      arc += Math.hypot(line[2 * j + 2]! - line[2 * j]!, line[2 * j + 3]! - line[2 * j + 1]!);
      ++j;
    }
    if (arc < length) break;
    const dx = line[2 * j]! - line[2 * i]!,
      dy = line[2 * j + 1]! - line[2 * i + 1]!,
      chord = Math.hypot(dx, dy);
    if (chord / arc > straightness) {
      straightness = chord / arc;
      const middle = (i + j) >> 1;
      best = {x: line[2 * middle]!, y: line[2 * middle + 1]!, angle: Math.atan2(dy, dx)};
    }
    arc -= i + 1 < count ? Math.hypot(line[2 * i + 2]! - line[2 * i]!, line[2 * i + 3]! - line[2 * i + 1]!) : 0;
  }
  return best;
}
