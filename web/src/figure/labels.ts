// Where the words of a figure stand: beside what they name, none upon another, nor upon a joint or a sign.
import type {Point} from "../contract/messages";

export interface Asked {
  /** Of what is named, in pixels. */
  at: Point;
  text: string;
  /** Height of the letters. */
  size: number;
  /** From the middle of what is named to the words. */
  gap: number;
}
export interface PlacedText {
  x: number;
  y: number; // the middle line
  anchor: "start" | "middle" | "end";
}
interface Box {
  left: number;
  right: number;
  top: number;
  bottom: number;
}
const sign_radius = 8;
/** To the side, above or below, then the corners; the first is the usual one. */
const ways: readonly (readonly [across: number, down: number])[] = [
  [1, 0],
  [-1, 0],
  [0, -1],
  [0, 1],
  [0.75, -0.75],
  [0.75, 0.75],
  [-0.75, -0.75],
  [-0.75, 0.75],
];

function overlap(a: Box, b: Box): number {
  const across = Math.min(a.right, b.right) - Math.max(a.left, b.left),
    down = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
  return across > 0 && down > 0 ? across * down : 0;
}
function around([x, y]: Point, radius: number): Box {
  return {left: x - radius, right: x + radius, top: y - radius, bottom: y + radius};
}
/** About as wide as its letters, where they are Latin; twice that where they are not. */
function width_of({text, size}: Asked): number {
  return [...text].reduce((sum, letter) => sum + (letter > "\u2e80" ? 1 : 0.56) * size, 0);
}

/** The first ones have the first choice. `signs`: what stands there already. */
export function placed_texts(asked: readonly Asked[], signs: readonly Point[]): PlacedText[] {
  const taken = signs.map((at) => around(at, sign_radius));
  return asked.map((label) => {
    const width = width_of(label),
      [px, py] = label.at;
    const tries = ways.map(([across, down]) => {
      const x = px + across * label.gap,
        y = py + down * (label.gap + (across === 0 ? 2 : 0)),
        anchor = across > 0 ? "start" : across < 0 ? "end" : "middle",
        left = anchor === "start" ? x : anchor === "end" ? x - width : x - width / 2;
      const box = {left, right: left + width, top: y - label.size / 2, bottom: y + label.size / 2};
      return {
        text: {x, y, anchor} as PlacedText,
        box,
        cost: taken.reduce((sum, other) => sum + overlap(box, other), 0),
      };
    });
    const best = tries.reduce((a, b) => (b.cost < a.cost ? b : a));
    taken.push(best.box);
    return best.text;
  });
}
