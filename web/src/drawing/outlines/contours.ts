// Where more than two ends of chains meet: the closed lines around all that hangs together there.
import type {Point} from "../../contract/messages";
import type {Stroke} from "./strokes";

/** A chain in one direction: `2 * chain`, or `+ 1` from its last point. */
type Way = number;

/** Lines within, as those along which a sheet is folded, do not cut the contour, whatever the order of the chains. `reach`: how
 *  far apart ends may be that meet. */
export function outer_contours(chains: readonly Stroke[], reach: number): Stroke[] {
  return new ChainGraph(chains, reach).outer_contours();
}

class ChainGraph {
  /** By way: the node where it begins. */
  private readonly from: number[] = [];
  /** By node: the ways that begin there, by their angle. */
  private readonly leaving: Way[][];
  private readonly left: boolean[];

  constructor(
    private readonly chains: readonly Stroke[],
    private readonly reach: number,
  ) {
    const nodes = new Nodes(reach);
    for (const {points} of chains) this.from.push(nodes.at(points[0]!), nodes.at(points.at(-1)!));
    this.leaving = Array.from({length: nodes.count}, () => []);
    this.left = chains.map(() => true);
    this.from.forEach((node, way) => this.leaving[node]!.push(way));
    this.leave_out_dead_ends();
    this.leaving = this.leaving.map((ways) =>
      ways.filter((way) => this.is_left(way)).toSorted((a, b) => this.angle(a) - this.angle(b)),
    );
  }

  outer_contours(): Stroke[] {
    const walked = new Set<Way>();
    return this.from.flatMap((_, way) => {
      if (!this.is_left(way) || walked.has(way)) return [];
      const face = this.face_left_of(way);
      for (const each of face) walked.add(each);
      if (area_of(this.points_of(face)) >= 0) return []; // a face within
      return this.simple_loops(face).map((loop) => ({points: this.points_of(loop), closed: true}));
    });
  }

  private is_left(way: Way): boolean {
    return this.left[way >> 1]!;
  }
  private to(way: Way): number {
    return this.from[way ^ 1]!;
  }
  /** Chains with a free end border no face. */
  private leave_out_dead_ends(): void {
    const degree = this.leaving.map((ways) => ways.length),
      ends = degree.flatMap((count, node) => (count === 1 ? [node] : []));
    for (let node = ends.pop(); node !== undefined; node = ends.pop())
      for (const way of this.leaving[node]!) {
        if (!this.is_left(way)) continue;
        this.left[way >> 1] = false;
        --degree[node]!;
        if (--degree[this.to(way)]! === 1) ends.push(this.to(way));
      }
  }
  /** Of the way's beginning, beyond what may be drawn badly. */
  private angle(way: Way): number {
    const points = this.along(way),
      [x, y] = points[0]!;
    const clear = points.slice(1).find((point) => Math.hypot(point[0] - x, point[1] - y) > 10 * this.reach),
      [to_x, to_y] = clear ?? points.at(-1)!;
    return Math.atan2(to_y - y, to_x - x);
  }
  private along(way: Way): readonly Point[] {
    const {points} = this.chains[way >> 1]!;
    return way & 1 ? points.toReversed() : points;
  }
  private points_of(ways: readonly Way[]): Point[] {
    return ways.flatMap((way) => this.along(way).slice(0, -1));
  }
  /** At each node the next way clockwise from where it came from. */
  private face_left_of(first: Way): Way[] {
    const face: Way[] = [];
    let way = first;
    do {
      face.push(way);
      const ways = this.leaving[this.to(way)]!;
      way = ways.at(ways.indexOf(way ^ 1) - 1)!;
    } while (way !== first && face.length <= this.from.length);
    return face;
  }
  /** Cut where the walk comes to a node a second time; a chain that is walked to and fro borders nothing. */
  private simple_loops(walk: readonly Way[]): Way[][] {
    const loops: Way[][] = [],
      open: Way[] = [],
      begun = new Map<number, number>();
    for (const way of walk) {
      if (!begun.has(this.from[way]!)) begun.set(this.from[way]!, open.length);
      open.push(way);
      const begin = begun.get(this.to(way));
      if (begin === undefined) continue;
      const loop = open.splice(begin);
      for (const closed of loop) begun.delete(this.from[closed]!);
      if (loop.length !== 2 || loop[0]! >> 1 !== loop[1]! >> 1) loops.push(loop);
    }
    return loops;
  }
}

/** Numbers for places where ends meet. */
class Nodes {
  count = 0;
  private readonly cells = new Map<string, {place: Point; node: number}[]>();

  constructor(private readonly reach: number) {}

  at(point: Point): number {
    const width = this.reach || 1,
      [column, row] = point.map((x) => Math.floor(x / width)) as [number, number];
    for (const dx of [0, -1, 1])
      for (const dy of [0, -1, 1])
        for (const {place, node} of this.cells.get(`${column + dx},${row + dy}`) ?? [])
          if (Math.hypot(place[0] - point[0], place[1] - point[1]) <= this.reach) return node;
    const key = `${column},${row}`;
    this.cells.set(key, [...(this.cells.get(key) ?? []), {place: point, node: this.count}]);
    return this.count++;
  }
}

function area_of(points: readonly Point[]): number {
  const [x0, y0] = points[0] ?? [0, 0];
  return points.reduce((twice, [x, y], i) => {
    const [nx, ny] = points[(i + 1) % points.length]!;
    return twice + (x - x0) * (ny - y0) - (y - y0) * (nx - x0);
  }, 0);
}
