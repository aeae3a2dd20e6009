// Stored answers (scripts/bake.mjs): what the page shows before its engine has loaded, and the gallery's thumbnails.
import {inflateSync} from "fflate";
import untyped from "./generated/stored.json";
import {
  state_width,
  whole,
  type Linkage,
  type Live,
  type LinkageType,
  type MapAnswer,
  type Point,
  type TaskAnswer,
  type TauPair,
} from "../contract/messages";

/** Arrays are deflated, in base64. */
type Packed<Keys extends string> = Record<Keys, string>;
interface Stored {
  start: {
    name: string;
    task: TaskAnswer;
    curves: Packed<"tau" | "center" | "circle" | "branch">;
    map: Pick<MapAnswer, "samples" | "property" | "census"> & // a square whose axes are alike
      Packed<"tau" | "type" | "defects" | "fails">;
    linkage: Linkage;
    states: string;
    live: Packed<"input" | "output">;
  };
}
type StoredThumbnail = Pick<Thumbnail, "title" | "rows" | "columns" | "linkage"> & Packed<"type" | "fails">;
const stored = untyped as unknown as Stored;

function unpacked(text: string): Uint8Array<ArrayBuffer> {
  return inflateSync(Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0))) as Uint8Array<ArrayBuffer>;
}
/** What cells fail: four bytes each. */
function unpacked_bits(text: string): Uint32Array {
  return new Uint32Array(unpacked(text).slice().buffer);
}
/** The reverse of packed_numbers() in scripts/bake.mjs. */
function unpacked_numbers(text: string, width = 1): Float64Array {
  const bytes = unpacked(text),
    count = bytes.length / 4,
    rows = count / width;
  const bits = new Uint32Array(count);
  for (let column = 0, at = 0; column < width; ++column) {
    for (let row = 0, last = 0; row < rows; ++row, ++at) {
      for (let byte = 0; byte < 4; ++byte) last += bytes[byte * count + at]! * 2 ** (8 * byte);
      bits[row * width + column] = last;
    }
  }
  return Float64Array.from(new Float32Array(bits.buffer));
}

/** What was on screen, or will be once the engine is there. */
export interface StoredView {
  task: TaskAnswer;
  /** Without ridges (all 0). */
  map: MapAnswer;
  linkage: Linkage;
  live: Live | null;
}
/** Of the file of this name as it is; its map has no values of a property (all 0). */
export interface StoredStart extends StoredView {
  name: string;
}
/** Every so many-th row and column of a map, so that there are at most so many of each. Without ridges (all 0). */
export function thinned(map: MapAnswer, most: number): MapAnswer {
  const rows = thinned_indexes(map.rows, most),
    columns = thinned_indexes(map.columns, most),
    cells = rows.flatMap((row) => columns.map((column) => row * map.columns + column));
  return {
    ...map,
    ...no_ridges(rows.length, columns.length),
    samples: Math.min(map.samples, most),
    rows: rows.length,
    columns: columns.length,
    input_tau: Float64Array.from(rows, (row) => map.input_tau[row]!),
    output_tau: Float64Array.from(columns, (column) => map.output_tau[column]!),
    type: Uint8Array.from(cells, (cell) => map.type[cell]!),
    defects: Uint8Array.from(cells, (cell) => map.defects[cell]!),
    fails: Uint32Array.from(cells, (cell) => map.fails[cell]!),
    value: Float32Array.from(cells, (cell) => map.value[cell]!),
  };
}
function thinned_indexes(length: number, most: number): number[] {
  const step = Math.max(Math.ceil(length / most), 1);
  return Array.from({length: Math.ceil(length / step)}, (_, k) => k * step);
}
function no_ridges(rows: number, columns: number): Pick<MapAnswer, "ridge"> {
  const values = (count: number) => new Float32Array(count),
    partners = (count: number) => new Uint32Array(count);
  return {
    ridge: {
      input: values(rows),
      input_partner: partners(rows),
      output: values(columns),
      output_partner: partners(columns),
    },
  };
}

/** The first example, in single precision. */
export function stored_start(): StoredStart {
  const {name, task, curves, map, linkage, states, live} = stored.start;
  const tau = unpacked_numbers(map.tau),
    {samples} = map;
  return {
    name,
    task: {
      ...task,
      curves: {
        ...task.curves,
        tau: unpacked_numbers(curves.tau),
        center: unpacked_numbers(curves.center, 3),
        circle: unpacked_numbers(curves.circle, 3),
        branch: unpacked(curves.branch),
      },
    },
    map: {
      samples,
      rows: samples,
      columns: samples,
      window: whole,
      property: map.property,
      census: map.census,
      input_tau: tau,
      output_tau: tau.slice(),
      type: unpacked(map.type),
      defects: unpacked(map.defects),
      fails: unpacked_bits(map.fails),
      value: new Float32Array(samples ** 2),
      ...no_ridges(samples, samples),
    },
    linkage: {
      ...linkage,
      drive: linkage.drive && {...linkage.drive, width: state_width, states: unpacked_numbers(states, state_width)},
    },
    live: {input: unpacked_bits(live.input), output: unpacked_bits(live.output)},
  };
}

export interface Thumbnail {
  title: string;
  rows: number; // 0: there is no map
  columns: number;
  type: Uint8Array; // as in MapAnswer
  fails: Uint32Array;
  /** The best linkage: centre and circle point of the input, then of the output. */
  linkage: {tau: TauPair; type: LinkageType; pivots: [Point, Point, Point, Point]} | null;
}
/** Of the examples, each by its name (the file's, without .json); nothing for others. Fetched when they are wanted: a first
 *  visit does without. */
export async function load_thumbnails(): Promise<(name: string) => Thumbnail | null> {
  const all = (await import("./generated/thumbnails.json")).default as unknown as Record<string, StoredThumbnail>;
  return (name) => (name in all ? thumbnail_of(all[name]!) : null);
}
function thumbnail_of(found: StoredThumbnail): Thumbnail {
  const has_map = found.rows > 0;
  return {
    ...found,
    type: has_map ? unpacked(found.type) : new Uint8Array(),
    fails: has_map ? unpacked_bits(found.fails) : new Uint32Array(),
  };
}
