// What a drawing of another program is made of, whatever its format: runs of straight strokes, y up, in the file's unit.
// Curves are flattened: no chord leaves its curve by more than a thousandth of the curve's size.
import type {Point} from "../../contract/messages";

export interface Stroke {
  points: Point[];
  /** The last point joins to the first. */
  closed: boolean;
}
export interface Drawn {
  strokes: Stroke[];
  /** Millimetres to a unit of the file; null where it does not say. */
  unit_mm: number | null;
  /** The sheet that the file declares, as an extent of x and of y. */
  sheet: readonly [number, number] | null;
}

/** Why a file gives no outline: these are keys of the texts, after "drawing.outline_". */
export type Refusal = "none" | "unreadable" | "binary" | "huge";
export class Refused extends Error {
  constructor(readonly why: Refusal) {
    super(why);
  }
}

const flatness = 1e-3,
  most_points = 100_000,
  most_halvings = 7;

/** Collects the strokes of one file, and refuses a file that has too many. */
export class Strokes {
  readonly list: Stroke[] = [];
  private points = 0;
  private steps = 0;

  /** One thing of the file has been looked at, whether it is drawn or not. */
  step(): void {
    if (++this.steps > most_points) throw new Refused("huge");
  }
  add(points: readonly Point[], closed: boolean): void {
    this.step();
    this.points += points.length;
    if (this.points > most_points) throw new Refused("huge");
    const kept = without_repeats(points.filter(([x, y]) => is_coordinate(x) && is_coordinate(y)));
    if (kept.length < points.length / 2 || kept.length < 2) return; // mostly not numbers, or no length
    this.list.push({points: kept, closed});
  }
}
function is_coordinate(value: number): boolean {
  return Math.abs(value) < 1e12;
}
function without_repeats(points: readonly Point[]): Point[] {
  const kept: Point[] = [];
  for (const point of points) {
    const last = kept.at(-1);
    if (!last || last[0] !== point[0] || last[1] !== point[1]) kept.push(point);
  }
  return kept;
}

/** Points of a curve from one end of its parameter to the other, both ends in; `pieces`: how many it has at least. */
export function flattened(at: (t: number) => Point, from: number, to: number, pieces = 4): Point[] {
  const ends = Array.from({length: pieces + 1}, (_, i) => {
    const t = i === pieces ? to : from + ((to - from) * i) / pieces;
    return {t, point: at(t)};
  });
  const tolerance = flatness * size_of(ends.map(({point}) => point));
  const points: Point[] = [];
  const halve = (t0: number, p0: Point, t1: number, p1: Point, left: number): void => {
    const middle = (t0 + t1) / 2,
      point = at(middle);
    const straight = [(t0 + middle) / 2, (middle + t1) / 2].every((t) => off_chord(at(t), p0, p1) <= tolerance);
    if (left === 0 || (straight && off_chord(point, p0, p1) <= tolerance)) return void points.push(p1);
    halve(t0, p0, middle, point, left - 1);
    halve(middle, point, t1, p1, left - 1);
  };
  let before = ends[0];
  if (!before) return [];
  points.push(before.point);
  for (const end of ends.slice(1)) {
    halve(before.t, before.point, end.t, end.point, most_halvings);
    before = end;
  }
  return points;
}
export function size_of(points: readonly Point[]): number {
  let [x0, y0, x1, y1] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [x, y] of points) [x0, y0, x1, y1] = [Math.min(x0, x), Math.min(y0, y), Math.max(x1, x), Math.max(y1, y)];
  return Math.max(x1 - x0, y1 - y0, 0);
}
/** How far a point is from the straight line between two others, or from the nearer of them. */
export function off_chord([x, y]: Point, [ax, ay]: Point, [bx, by]: Point): number {
  const dx = bx - ax,
    dy = by - ay,
    length = dx * dx + dy * dy;
  const t = length > 0 ? Math.min(Math.max(((x - ax) * dx + (y - ay) * dy) / length, 0), 1) : 0;
  return Math.hypot(x - ax - t * dx, y - ay - t * dy);
}
