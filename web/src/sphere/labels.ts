// Where the labels of a view stand: beside their points, outwards, none upon another.
import type {Spot} from "./view";

export interface Placed extends Spot {
  key: string;
}
export interface Asked extends Spot {
  key: string;
  width: number;
}
const height = 16,
  gap = 13;

function overlap(a: Spot & {width: number}, b: Spot & {width: number}): number {
  const across = Math.min(a.x + a.width / 2, b.x + b.width / 2) - Math.max(a.x - a.width / 2, b.x - b.width / 2),
    down = height - Math.abs(a.y - b.y);
  return across > 0 && down > 0 ? across * down : 0;
}
/** The middle of each label, from the middle of the view outwards; the first ones have the first choice. */
export function placed_labels(asked: readonly Asked[], middle: Spot): Placed[] {
  const done: (Asked & Placed)[] = [];
  for (const label of asked) {
    const [dx, dy] = [label.x - middle.x, label.y - middle.y],
      size = Math.hypot(dx, dy),
      [ox, oy] = size > 4 ? [dx / size, dy / size] : [0.7, -0.7];
    const tries = [
      [1, 0],
      [1, 1],
      [1, -1],
      [0, 1.3],
      [0, -1.3],
      [2.2, 0],
      [2, 1.5],
      [2, -1.5],
    ].map(([out, aside]) => ({
      ...label,
      x: label.x + gap * (out! * ox - aside! * oy) + (out! * ox - aside! * oy) * (label.width / 2 - 6),
      y: label.y + gap * (out! * oy + aside! * ox),
    }));
    const cost = (one: Asked) => done.reduce((sum, other) => sum + overlap(one, other), 0);
    done.push(tries.find((one) => cost(one) === 0) ?? tries.reduce((a, b) => (cost(b) < cost(a) ? b : a)));
  }
  return done.map(({key, x, y}) => ({key, x, y}));
}
