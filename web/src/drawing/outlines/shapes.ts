// The shapes of a drawing that can be a body: its strokes joined end to end, the sheet's frame told from the parts.
import type {Point} from "../../contract/messages";
import {outer_contours} from "./contours";
import {off_chord, size_of, type Drawn, type Stroke} from "./strokes";

export interface Shape {
  /** Corners as drawn, in the file's unit. */
  points: readonly Point[];
  /** Else it is closed by a straight edge. */
  closed: boolean;
  /** The edge of the sheet, or the border on it. */
  frame: boolean;
  width: number;
  height: number;
}
const most_shapes = 24,
  most_corners = 200,
  most_looked_at = 4000, // corners of a shape: what is left of them takes the square of their number
  meeting = 1e-5; // of the drawing's size: ends that lie closer are one

/** The largest shapes: parts before open chains before frames. Each has three corners or more. */
export function shapes_of({strokes, sheet}: Drawn): Shape[] {
  const all = chained(strokes)
    .map(shape_of)
    .filter((shape) => shape !== null)
    .sort((a, b) => area(b) - area(a));
  const shapes = with_frames(without_doubles(all), sheet);
  const rank = (shape: Shape) => (shape.frame ? 2 : shape.closed ? 0 : 1);
  return shapes
    .sort((a, b) => rank(a) - rank(b)) // stable: the largest first
    .slice(0, most_shapes);
}
function area({width, height}: Shape): number {
  return width * height;
}
interface Extent {
  x: [number, number];
  y: [number, number];
}
export function extent({points}: Pick<Shape, "points">): Extent {
  const box: Extent = {x: [Infinity, -Infinity], y: [Infinity, -Infinity]};
  for (const [x, y] of points) {
    box.x = [Math.min(box.x[0], x), Math.max(box.x[1], x)];
    box.y = [Math.min(box.y[0], y), Math.max(box.y[1], y)];
  }
  return box;
}
function shape_of({points, closed}: Stroke): Shape | null {
  const near = 1e-9 * size_of(points),
    [first, last] = [points[0], points.at(-1)];
  const meets = first && last && points.length > 3 && Math.hypot(first[0] - last[0], first[1] - last[1]) <= near,
    corners = meets ? points.slice(0, -1) : points;
  if (corners.length < 3) return null;
  const {x, y} = extent({points: corners}),
    [width, height] = [x[1] - x[0], y[1] - y[0]];
  if (!(Math.min(width, height) > 1e-6 * Math.max(width, height)) && is_straight(corners)) return null;
  return {points: corners, closed: closed || meets === true, frame: false, width, height};
}
function is_straight(points: readonly Point[]): boolean {
  const [first, last] = [points[0], points.at(-1)];
  return !first || !last || points.every((point) => off_chord(point, first, last) <= 1e-9 * size_of(points));
}
/** A filled shape and its edge are often drawn one over the other. */
function without_doubles(shapes: readonly Shape[]): Shape[] {
  const seen = new Set<string>();
  return shapes.filter((shape) => {
    const {x, y} = extent(shape),
      digits = (value: number) => (value / (shape.width + shape.height)).toFixed(4);
    const key = [...x, ...y].map(digits).join() + shape.points.length + shape.closed;
    return !seen.has(key) && seen.add(key);
  });
}

// ---- chains ---------------------------------------------------------------------------------------------------------

interface End {
  stroke: Stroke;
  last: boolean;
}
/** Open strokes joined where just two ends meet; and the outer contours of what hangs together at places where more do. */
export function chained(strokes: readonly Stroke[]): Stroke[] {
  const open = strokes.filter(({closed}) => !closed),
    reach = meeting * size_of(open.flatMap(({points}) => points));
  const chains = joined(open, reach);
  const outer = outer_contours(
    chains.filter(({closed}) => !closed),
    reach,
  );
  return [...strokes.filter(({closed}) => closed), ...chains, ...outer];
}
/** Strokes joined where just two ends meet. */
function joined(strokes: readonly Stroke[], reach: number): Stroke[] {
  const ends = new Ends(strokes, reach);
  return strokes.flatMap((stroke) => {
    if (!ends.take(stroke)) return [];
    const points = [...stroke.points];
    ends.extend(points);
    if (!meet(points[0], points.at(-1), reach)) {
      points.reverse();
      ends.extend(points);
      points.reverse();
    }
    const closed = points.length > 3 && meet(points[0], points.at(-1), reach);
    return [{points: closed ? points.slice(0, -1) : points, closed}];
  });
}
function meet(a: Point | undefined, b: Point | undefined, reach: number): boolean {
  return a !== undefined && b !== undefined && Math.hypot(a[0] - b[0], a[1] - b[1]) <= reach;
}
/** The ends of strokes by the cell that they lie in; a cell is as wide as ends may be apart. */
class Ends {
  private readonly cells = new Map<string, End[]>();
  private readonly free: Set<Stroke>;

  constructor(
    strokes: readonly Stroke[],
    private readonly reach: number,
  ) {
    this.free = new Set(strokes);
    for (const stroke of strokes)
      for (const last of [false, true]) {
        const key = this.key(end_point({stroke, last}), 0, 0),
          cell = this.cells.get(key);
        if (cell) cell.push({stroke, last});
        else this.cells.set(key, [{stroke, last}]);
      }
  }
  private key([x, y]: Point, dx: number, dy: number): string {
    const width = this.reach || 1;
    return `${Math.floor(x / width) + dx},${Math.floor(y / width) + dy}`;
  }
  take(stroke: Stroke): boolean {
    return this.free.delete(stroke);
  }
  /** Goes on from the last point as long as another stroke begins there, or the chain is closed. */
  extend(points: Point[]): void {
    for (;;) {
      const at = points.at(-1);
      if (!at || (points.length > 2 && meet(points[0], at, this.reach)) || this.is_crowded(at)) return;
      const found = this.free_end(at);
      if (!found) return;
      this.free.delete(found.stroke);
      const next = found.last ? found.stroke.points.toReversed() : found.stroke.points;
      for (const point of next.slice(1)) points.push(point);
    }
  }
  private *near(at: Point): Generator<End[]> {
    for (const dx of [0, -1, 1])
      for (const dy of [0, -1, 1]) {
        const cell = this.cells.get(this.key(at, dx, dy));
        if (cell) yield cell;
      }
  }
  private is_crowded(at: Point): boolean {
    let count = 0;
    for (const cell of this.near(at))
      for (const end of cell) if (meet(end_point(end), at, this.reach) && ++count > 2) return true;
    return false;
  }
  private free_end(at: Point): End | null {
    for (const cell of this.near(at)) {
      const end = cell.findLast((each) => this.free.has(each.stroke) && meet(end_point(each), at, this.reach));
      if (end) return end;
    }
    return null;
  }
}
function end_point({stroke: {points}, last}: End): Point {
  return points.at(last ? -1 : 0) ?? [NaN, NaN];
}

// ---- frames ---------------------------------------------------------------------------------------------------------

const sheet_ratios = [Math.SQRT2, 277 / 180, 11 / 8.5, 17 / 11]; // ISO; A4 within its border; ANSI

/** From the outside in: an upright rectangle around all else that has a sheet's proportions, lies along the edge of the
 *  declared sheet, or along another frame. A lone rectangle is a part. */
function with_frames(shapes: readonly Shape[], sheet: readonly [number, number] | null): Shape[] {
  const frames = new Set<Shape>();
  let around = sheet;
  for (const [i, shape] of shapes.entries()) {
    const inside = shapes.slice(i + 1);
    if (inside.length === 0 || !is_rectangle(shape) || !inside.every((other) => contains(shape, other))) break;
    if (!has_sheet_ratio(shape) && !(around && lies_along(shape, around))) break;
    frames.add(shape);
    around = [shape.width, shape.height];
  }
  return shapes.map((shape) => (frames.has(shape) ? {...shape, frame: true} : shape));
}
function is_rectangle({points, closed, width, height}: Shape): boolean {
  if (!closed || points.length !== 4) return false;
  const near = 1e-4 * (width + height);
  return points.every(([x, y], i) => {
    const [nx, ny] = points[(i + 1) % 4] ?? [x, y];
    return Math.abs(nx - x) < near || Math.abs(ny - y) < near;
  });
}
function contains(outer: Shape, inner: Shape): boolean {
  const [a, b] = [extent(outer), extent(inner)],
    near = 1e-4 * (outer.width + outer.height);
  return (["x", "y"] as const).every((axis) => a[axis][0] - near <= b[axis][0] && b[axis][1] <= a[axis][1] + near);
}
function has_sheet_ratio({width, height}: Shape): boolean {
  const ratio = Math.max(width, height) / Math.min(width, height);
  return sheet_ratios.some((of) => Math.abs(ratio / of - 1) < 0.015);
}
function lies_along({width, height}: Shape, [around_width, around_height]: readonly [number, number]): boolean {
  return width > 0.85 * around_width && height > 0.85 * around_height;
}

// ---- corners --------------------------------------------------------------------------------------------------------

/** With no more corners than a body may have: those that matter least are left out. */
export function simplified(points: readonly Point[]): Point[] {
  const every = Math.ceil(points.length / most_looked_at),
    looked_at = points.filter((_, i) => i % every === 0);
  let kept = looked_at;
  for (let tolerance = 1e-4 * size_of(points); kept.length > most_corners; tolerance *= 1.5)
    kept = within(looked_at, tolerance);
  return kept;
}
/** Ramer's algorithm on a closed line, cut at two corners far apart. */
function within(points: readonly Point[], tolerance: number): Point[] {
  const first = points[0];
  if (!first) return [];
  let far = 0,
    most = -1;
  points.forEach(([x, y], i) => {
    const distance = Math.hypot(x - first[0], y - first[1]);
    if (distance > most) [far, most] = [i, distance];
  });
  const halves = [points.slice(0, far + 1), [...points.slice(far), first]];
  return halves.flatMap((half) => line_within(half, tolerance).slice(0, -1));
}
function line_within(points: readonly Point[], tolerance: number): Point[] {
  const kept = new Set([0, points.length - 1]),
    waiting: [number, number][] = [[0, points.length - 1]];
  for (let span = waiting.pop(); span; span = waiting.pop()) {
    const [from, to] = span,
      [a, b] = [points[from], points[to]];
    let at = -1,
      most = tolerance;
    for (let i = from + 1; a && b && i < to; ++i) {
      const point = points[i],
        distance = point ? off_chord(point, a, b) : 0;
      if (distance > most) [at, most] = [i, distance];
    }
    if (at < 0) continue;
    kept.add(at);
    waiting.push([from, at], [at, to]);
  }
  return points.filter((_, i) => kept.has(i));
}
