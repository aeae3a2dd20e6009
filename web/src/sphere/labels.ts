// Where the labels of a view stand: beside their points, outwards, none upon another.
import type {Size, Spot} from "./view";

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
/** The middle of each label, from the middle of the view outwards but within it; the first ones have the first choice. */
export function placed_labels(asked: readonly Asked[], size: Size): Placed[] {
  const middle = {x: size.width / 2, y: size.height / 2},
    within = (x: number, room: number, most: number) => Math.min(Math.max(x, room), most - room);
  const done: (Asked & Placed)[] = [];
  for (const label of asked) {
    const [dx, dy] = [label.x - middle.x, label.y - middle.y],
      away = Math.hypot(dx, dy),
      [ox, oy] = away > 4 ? [dx / away, dy / away] : [0.7, -0.7];
    const tries = [
      [1, 0],
      [1, 1],
      [1, -1],
      [0, 1.3],
      [0, -1.3],
      [2.2, 0],
      [2, 1.5],
      [2, -1.5],
    ].map(([out, aside]) => {
      const [tx, ty] = [out! * ox - aside! * oy, out! * oy + aside! * ox];
      return {
        ...label,
        x: within(label.x + tx * (gap + label.width / 2 - 6), label.width / 2 + 2, size.width),
        y: within(label.y + ty * gap, height / 2 + 2, size.height),
      };
    });
    const cost = (one: Asked) => done.reduce((sum, other) => sum + overlap(one, other), 0);
    done.push(tries.find((one) => cost(one) === 0) ?? tries.reduce((a, b) => (cost(b) < cost(a) ? b : a)));
  }
  return done.map(({key, x, y}) => ({key, x, y}));
}
