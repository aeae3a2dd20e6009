// The map as pixels: one per cell in a bitmap, defect cells left clear so that hatching drawn in screen pixels shows.
import type {MapAnswer, MapWindow} from "../contract/messages";
import {ramp_steps, ramp_table, type_table, type Look} from "./palette";
import {pixel_of, type Piece, type Scale} from "./scale";
import type {ValueRange} from "./value_range";

/** With rows and columns exchanged, where there is one of either. */
export function on_its_side(map: MapAnswer): MapAnswer {
  const {rows, columns, window, input_tau, output_tau} = map;
  return {
    ...map,
    rows: columns,
    columns: rows,
    window: {input: window.output, output: window.input},
    input_tau: output_tau,
    output_tau: input_tau,
  };
}

/** Fills columns × rows pixels, row 0 of the map at the bottom. */
export function paint_types(map: MapAnswer, look: Look, out: Uint32Array): void {
  const table = type_table(look),
    {rows, columns, type, defects, fails} = map;
  for (let row = 0; row < rows; ++row) {
    let from = row * columns,
      to = (rows - 1 - row) * columns;
    for (const end = from + columns; from < end; ++from, ++to) {
      out[to] = table[type[from]! | (fails[from] === 0 ? 16 : 0) | (defects[from]! << 5)]!;
    }
  }
}
/** `known`: 1 where the value is a cell's own; where it stands for another's it is drawn pale. Without it all are. */
export function paint_values(
  map: MapAnswer,
  look: Look,
  range: ValueRange,
  out: Uint32Array,
  known: Uint8Array | null = null,
): void {
  const table = ramp_table(look),
    {rows, columns, type, defects, fails} = map,
    [value, ends] = range.logarithmic ? in_logarithms(map.value, range) : [map.value, range];
  const scale = (ramp_steps - 1) / (ends.to - ends.from || 1),
    top = ramp_steps - 1;
  for (let row = 0; row < rows; ++row) {
    let from = row * columns,
      to = (rows - 1 - row) * columns;
    for (const end = from + columns; from < end; ++from, ++to) {
      const step = (value[from]! - ends.from) * scale;
      const kind = type[from]! | (fails[from] === 0 ? 16 : 0) | (defects[from]! << 5) | (known?.[from] === 0 ? 256 : 0);
      out[to] = table.pixels[table.rows[kind]! + (step > 0 ? (step < top ? step | 0 : top) : 0)]!;
    }
  }
}
/** What is not defined is as bad as can be. */
function in_logarithms(value: Float32Array, {from, to}: ValueRange): [Float32Array, ValueRange] {
  const worst = Math.log(from);
  return [value.map((of) => (of > 0 ? Math.log(of) : worst)), {from: worst, to: Math.log(to)}];
}
/** Opaque where a cell has exactly this kind of defect as its worst: for hatching by kind. */
export function paint_defect_mask(map: MapAnswer, kind: DefectKind, out: Uint32Array): void {
  const {rows, columns, defects} = map;
  for (let row = 0; row < rows; ++row) {
    let from = row * columns,
      to = (rows - 1 - row) * columns;
    for (const end = from + columns; from < end; ++from, ++to)
      out[to] = worst_kind[defects[from]! & 7] === kind ? 0xff000000 : 0;
  }
}
export type DefectKind = 0 | 1 | 2 | 3; // none, order, branch, circuit
/** By defect bits; circuit implies branch. */
const worst_kind: readonly DefectKind[] = [0, 1, 2, 2, 3, 3, 3, 3];

export interface Bitmap {
  canvas: HTMLCanvasElement;
  pixels: ImageData;
  words: Uint32Array;
}
export function sized_bitmap(before: Bitmap | null, {rows, columns}: Pick<MapAnswer, "rows" | "columns">): Bitmap {
  if (before && before.canvas.width === columns && before.canvas.height === rows) return before;
  const canvas = document.createElement("canvas");
  canvas.width = columns;
  canvas.height = rows;
  const pixels = canvas.getContext("2d")!.createImageData(columns, rows);
  return {canvas, pixels, words: new Uint32Array(pixels.data.buffer)};
}
export function put(bitmap: Bitmap): void {
  bitmap.canvas.getContext("2d")!.putImageData(bitmap.pixels, 0, 0);
}

export interface Frame {
  up: Scale; // input, from the bottom
  across: Scale; // output
}
interface Part {
  source: number;
  source_size: number;
  start: number;
  size: number;
}
function part(piece: Piece, scale: Scale, span: readonly [number, number], n: number): Part | null {
  const from = Math.max(piece.from, span[0]),
    to = Math.min(piece.to, span[1]);
  if (to <= from) return null;
  const per_place = n / (span[1] - span[0]);
  const start = piece.start + (from - piece.from) * scale.per_place;
  return {
    source: (from - span[0]) * per_place,
    source_size: (to - from) * per_place,
    start,
    size: (to - from) * scale.per_place,
  };
}

/** Draws the bitmap of the part `window` of the region, wherever that part lies in the frame. */
export function draw_bitmap(
  context: CanvasRenderingContext2D,
  {canvas}: Bitmap,
  window: MapWindow,
  frame: Frame,
): void {
  const {up, across} = frame,
    {width: columns, height: rows} = canvas;
  const ratio = context.getTransform().a; // device pixels
  const crowded = (count: number, scale: Scale, [from, to]: readonly [number, number]) =>
    count > scale.per_place * ratio * (to - from) * 1.3;
  context.imageSmoothingEnabled = crowded(rows, up, window.input) || crowded(columns, across, window.output);
  for (const row of up.pieces) {
    const v = part(row, up, window.input, rows);
    if (!v) continue;
    for (const column of across.pieces) {
      const h = part(column, across, window.output, columns);
      if (!h) continue;
      context.drawImage(
        canvas,
        h.source,
        rows - v.source - v.source_size,
        h.source_size,
        v.source_size,
        h.start,
        up.size - v.start - v.size,
        h.size,
        v.size,
      );
    }
  }
}

/** Calls back with the rectangle of every pair of blocks. */
export function for_each_block(
  frame: Frame,
  draw: (x: number, y: number, width: number, height: number) => void,
): void {
  for (const row of frame.up.pieces) {
    for (const column of frame.across.pieces) {
      draw(column.start, frame.up.size - row.end, column.end - column.start, row.end - row.start);
    }
  }
}

/** Where the two axes show the same place: ends of the diagonal's stretches, pixels from the top left. */
export function diagonal(frame: Frame): [x1: number, y1: number, x2: number, y2: number][] {
  const lines: [number, number, number, number][] = [];
  const {up, across} = frame;
  for (const row of up.pieces) {
    for (const column of across.pieces) {
      const from = Math.max(row.from, column.from),
        to = Math.min(row.to, column.to);
      if (row.block !== column.block || to <= from) continue;
      const x = (place: number) => column.start + (place - column.from) * across.per_place;
      const y = (place: number) => up.size - (row.start + (place - row.from) * up.per_place);
      lines.push([x(from), y(from), x(to), y(to)]);
    }
  }
  return lines;
}

export function point_of(frame: Frame, place: readonly [number, number]): [x: number, y: number] {
  return [pixel_of(frame.across, place[1]), frame.up.size - pixel_of(frame.up, place[0])];
}

/** FNV-1a of the words: tells two pictures apart. */
export function hash_of(words: Uint32Array): string {
  let hash = 0x811c9dc5;
  for (const word of words) hash = Math.imul(hash ^ word, 0x01000193);
  return (hash >>> 0).toString(16).padStart(8, "0");
}
