// Spherical four-bars as they come out of the workshop: the arcs of their moving links in each position.
import type {ToleranceAnswer} from "../../contract/messages";
import type {Item} from "../../sphere/item";
import {unit, type Vec3} from "../../sphere/vectors";

const axes = 4, // to a position: fixed and moving axis of the input, moving and fixed axis of the output
  most = 60, // samples that are drawn: more are no denser on the ball
  stretches = 5; // to an arc
const links = [
  ["input", 0, 1],
  ["body", 1, 2],
  ["output", 2, 3],
] as const;

/** Deviations from the middle of the samples, which is the linkage as it is meant, enlarged by `magnification`. */
export function samples_picture({drawn, positions}: ToleranceAnswer, magnification: number): Item[] {
  const width = axes * positions,
    count = drawn.length / (3 * width);
  const axis = (sample: number, at: number): Vec3 => {
    const from = 3 * (sample * width + at);
    return [drawn[from]!, drawn[from + 1]!, drawn[from + 2]!];
  };
  const middle = Array.from({length: width}, (_, at): Vec3 => {
    const sum: [number, number, number] = [0, 0, 0];
    for (let sample = 0; sample < count; ++sample) axis(sample, at).forEach((value, k) => (sum[k]! += value));
    return unit(sum);
  });
  const shown = (sample: number, at: number): Vec3 => {
    const [x, y, z] = axis(sample, at),
      [x0, y0, z0] = middle[at]!;
    return unit([x0 + magnification * (x - x0), y0 + magnification * (y - y0), z0 + magnification * (z - z0)]);
  };
  return links.map(([color, first, last]): Item => {
    const ends: Vec3[] = [];
    for (let sample = 0; sample < Math.min(count, most); ++sample)
      for (let position = 0; position < positions; ++position)
        add_arc(ends, shown(sample, axes * position + first), shown(sample, axes * position + last));
    return {kind: "strokes", key: `samples ${color}`, ends, color, width: 1, opacity: 0.18};
  });
}
/** The shorter one, as stretches between its points. */
function add_arc(ends: Vec3[], from: Vec3, to: Vec3): void {
  let last = from;
  for (let k = 1; k <= stretches; ++k) {
    const s = k / stretches,
      next = unit([0, 1, 2].map((i) => (1 - s) * from[i]! + s * to[i]!) as unknown as Vec3);
    ends.push(last, next);
    last = next;
  }
}
