// A curve as it is drawn by hand, made smooth, and points along it: as many as a fit takes, closer where it bends.
import type {Point} from "../../contract/messages";
import {most_of} from "../../state/ends";

/** So many points describe what is drawn. */
export const drawn_points = 24;

const sharpest_turn = 1.5; // radians that a corner counts at most: the tips of a crescent, and no more

const between = ([x, y]: Point, [u, v]: Point, share: number): Point => [x + share * (u - x), y + share * (v - y)];
const distance = ([x, y]: Point, [u, v]: Point) => Math.hypot(u - x, v - y);
/** Without those at the place of the one before. */
function apart(points: readonly Point[], closed: boolean): Point[] {
  const kept = points.filter((point, i) => i === 0 || distance(point, points[i - 1]!) > 0);
  while (closed && kept.length > 1 && distance(kept[0]!, kept.at(-1)!) === 0) kept.pop();
  return kept;
}
/** The length of a polyline, of a closed one all round. */
export function length_of(points: readonly Point[], closed = false): number {
  const open = points.slice(1).reduce((sum, point, i) => sum + distance(points[i]!, point), 0);
  return closed && points.length > 1 ? open + distance(points.at(-1)!, points[0]!) : open;
}

/** Whether a stroke's end comes back near its beginning: within a share of its length, having gone round. */
export function comes_back(stroke: readonly Point[]): boolean {
  const [first, last] = [stroke[0], stroke.at(-1)],
    near = 0.12 * length_of(stroke);
  if (!first || !last || stroke.length < 8) return false;
  const farthest = most_of(stroke.map((point) => distance(point, first)));
  return distance(first, last) <= Math.min(near, 0.5 * farthest);
}
/** The end led on to the beginning: what runs on past it is left out, and by what the end lies beside it the whole stroke is
 *  bent, a little everywhere. */
export function joined(stroke: readonly Point[]): Point[] {
  const first = stroke[0]!,
    whole = length_of(stroke) || 1,
    [dx, dy] = direction_at_start(stroke, 0.05 * whole);
  const ahead = ([x, y]: Point) => (x - first[0]) * dx + (y - first[1]) * dy;
  let end = stroke.length;
  while (end > stroke.length / 2 && ahead(stroke[end - 1]!) >= 0) --end;
  const kept = stroke.slice(0, end),
    [x, y] = kept.at(-1)!,
    beside = (x - first[0]) * -dy + (y - first[1]) * dx;
  let run = 0;
  const length = length_of(kept) || 1;
  return kept.map(([x, y], i): Point => {
    if (i > 0) run += distance(kept[i - 1]!, [x, y]);
    const by = -(run / length - 0.5) * beside;
    return [x - by * dy, y + by * dx];
  });
}
/** From the beginning to what lies so far on. */
function direction_at_start(stroke: readonly Point[], reach: number): Point {
  const first = stroke[0]!,
    next = stroke.find((point) => distance(point, first) >= reach) ?? stroke.at(-1)!,
    far = distance(next, first) || 1;
  return [(next[0] - first[0]) / far, (next[1] - first[1]) / far];
}

/** Each point goes half the way to the middle of its neighbours, and from it a little more than that, so many times: what
 *  trembles is smoothed, and nothing shrinks (Taubin, A signal processing approach to fair surface design, 1995). The ends of
 *  an open curve stay. */
export function smoothed(points: readonly Point[], closed: boolean, times = 1): Point[] {
  let curve = [...points];
  for (let k = 0; k < times; ++k) curve = led_to_neighbours(led_to_neighbours(curve, closed, 0.5), closed, -0.52);
  return curve;
}
function led_to_neighbours(points: readonly Point[], closed: boolean, share: number): Point[] {
  const n = points.length;
  if (n < 3) return [...points];
  return points.map((point, i) => {
    if (!closed && (i === 0 || i === n - 1)) return point;
    return between(point, between(points[(i + n - 1) % n]!, points[(i + 1) % n]!, 0.5), share);
  });
}

/** Points along a polyline at equal steps. */
export function evenly_spaced(points: readonly Point[], closed: boolean, count: number): Point[] {
  return along(points, closed, count, (length) => length);
}
/** At equal steps of half the arc length and half the turning, each as a share of the whole: by length alone the tips of a
 *  crescent are lost. */
export function resampled(points: readonly Point[], closed: boolean, count = drawn_points): Point[] {
  const line = apart(points, closed),
    turns = turning(line, closed),
    turned = turns.reduce((sum, turn) => sum + turn, 0),
    whole = length_of(line, closed);
  if (!(whole > 0)) return line;
  const half = turned > 1e-9 ? 0.5 : 1;
  return along(line, closed, count, (length, i) => {
    const next = (i + 1) % line.length,
      turn = (turns[i]! + turns[next]!) / 2;
    return (half * length) / whole + (half < 1 ? (half * turn) / turned : 0);
  });
}
/** At each vertex, radians; at the ends of an open polyline none. */
function turning(line: readonly Point[], closed: boolean): number[] {
  const n = line.length;
  return line.map(([x, y], i) => {
    if (n < 3 || (!closed && (i === 0 || i === n - 1))) return 0;
    const [[a, b], [u, v]] = [line[(i + n - 1) % n]!, line[(i + 1) % n]!];
    const [dx, dy, ex, ey] = [x - a, y - b, u - x, v - y];
    return Math.min(Math.abs(Math.atan2(dx * ey - dy * ex, dx * ex + dy * ey)), sharpest_turn);
  });
}
/** At equal steps of what `cost` says of each edge; of an open polyline with both its ends. */
function along(
  points: readonly Point[],
  closed: boolean,
  count: number,
  cost: (length: number, edge: number) => number,
): Point[] {
  const line = apart(points, closed),
    edges = closed ? line.length : line.length - 1;
  if (line.length < 2 || count < 2) return line.slice(0, count);
  const reached = [0];
  for (let i = 0; i < edges; ++i) reached.push(reached[i]! + cost(distance(line[i]!, line[(i + 1) % line.length]!), i));
  const step = reached.at(-1)! / (closed ? count : count - 1);
  let edge = 0;
  return Array.from({length: count}, (_, k) => {
    const to = Math.min(k * step, reached.at(-1)!);
    while (edge < edges - 1 && reached[edge + 1]! < to) ++edge;
    const [from, until] = [reached[edge]!, reached[edge + 1]!];
    return between(line[edge]!, line[(edge + 1) % line.length]!, until > from ? (to - from) / (until - from) : 0);
  });
}

/** A stroke of a hand as the points of a task: evened out, made smooth, closed where its end comes back. */
export function drawn(stroke: readonly Point[]): {points: Point[]; closed: boolean} {
  const closed = comes_back(stroke),
    fine = evenly_spaced(closed ? joined(stroke) : stroke, closed, 4 * drawn_points);
  return {points: resampled(smoothed(fine, closed, 6), closed), closed};
}
