import type {Curves, Point} from "../contract/messages";

const crowded_length = 0.3,
  crowded_part = 0.03;

/** Share of τ that holds the densest 30 % of what is seen of the curves; their samples lie at `tau`. */
export function crowded_share(curves: Curves, low: Point, high: Point): number {
  const stretches: {length: number; part: number}[] = [];
  let length = 0,
    part = 0;
  for (let i = 0; i + 1 < curves.tau.length; ++i) {
    if (curves.branch[i] !== curves.branch[i + 1]) continue;
    const seen = seen_length(curves.center, i, low, high) + seen_length(curves.circle, i, low, high);
    const step = Math.abs(curves.tau[i + 1]! - curves.tau[i]!);
    stretches.push({length: seen, part: step});
    length += seen;
    part += step;
  }
  stretches.sort((a, b) => b.length * a.part - a.length * b.part);
  let gathered = 0,
    taken = 0;
  for (const stretch of stretches) {
    if (gathered >= crowded_length * length) break;
    gathered += stretch.length;
    taken += stretch.part;
  }
  return part > 0 && length > 0 ? taken / part : 1;
}
export function is_crowded(curves: Curves, low: Point, high: Point): boolean {
  return crowded_share(curves, low, high) < crowded_part;
}

function seen_length(points: Float64Array, i: number, low: Point, high: Point): number {
  const x0 = points[3 * i + 1]! / points[3 * i]!,
    y0 = points[3 * i + 2]! / points[3 * i]!;
  const x1 = points[3 * i + 4]! / points[3 * i + 3]!,
    y1 = points[3 * i + 5]! / points[3 * i + 3]!;
  const inside = (x: number, y: number) => x >= low[0] && x <= high[0] && y >= low[1] && y <= high[1];
  return inside(x0, y0) && inside(x1, y1) ? Math.hypot(x1 - x0, y1 - y0) : 0;
}
