// Stored answers (scripts/bake.mjs): what the page shows before its engine has loaded, and the gallery's thumbnails.
import {inflateSync} from "fflate";
import untyped from "./generated/stored.json";
import {
  state_width,
  whole,
  type Linkage,
  type LinkageType,
  type MapAnswer,
  type Point,
  type Replies,
  type TaskAnswer,
  type TauPair,
} from "./protocol";

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
/** What cells fail: two bytes each. */
function unpacked_bits(text: string): Uint16Array {
  return new Uint16Array(unpacked(text).slice().buffer);
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

export interface StoredStart {
  /** The example's name: the answers are those of its file as it is. */
  name: string;
  task: TaskAnswer;
  /** Without property values and ridges (all 0). */
  map: MapAnswer;
  linkage: Linkage;
  live: Replies["live"];
}
/** The first example, in single precision. */
export function stored_start(): StoredStart {
  const {name, task, curves, map, linkage, states, live} = stored.start;
  const tau = unpacked_numbers(map.tau),
    {samples} = map;
  const none = () => new Float32Array(samples),
    nobody = () => new Uint32Array(samples);
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
      ridge: {input: none(), input_partner: nobody(), output: none(), output_partner: nobody()},
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
  fails: Uint16Array;
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
    fails: has_map ? unpacked_bits(found.fails) : new Uint16Array(),
  };
}
