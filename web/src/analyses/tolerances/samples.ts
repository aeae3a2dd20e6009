// Linkages as they come out of the workshop, drawn thin over each other in each position.
import type {Linkage, Point} from "../../contract/messages";
import {at_row, type Mechanism, type SampledLink} from "../../figure/mechanism";
import {px, type Projection} from "../../figure/paths";

/** The samples by position and point; of each sample all positions. */
export interface Samples {
  drawn: Float64Array;
  positions: number;
  /** To a sample and position: the joints, and the body's origin. */
  points: number;
}
export function count_of({drawn, positions, points}: Samples): number {
  return drawn.length / (2 * positions * points);
}
export function point_of({drawn, positions, points}: Samples, sample: number, position: number, point: number): Point {
  const at = 2 * ((sample * positions + position) * points + point);
  return [drawn[at]!, drawn[at + 1]!];
}

/** How the linkage is meant, point by point of a position: as the drive has it, or, where that does not get there, the
 *  middle of the samples. */
export function nominal_of(samples: Samples, mechanism: Mechanism, linkage: Linkage): Point[][] {
  const ticks = linkage.drive?.ticks ?? [],
    is_driven = ticks.length === samples.positions && ticks.every(({reached}) => reached);
  return Array.from({length: samples.positions}, (_, position) => {
    const points = is_driven && driven_points(mechanism, linkage, ticks[position]!.state);
    return points && points.length === samples.points ? points : middle_of(samples, position);
  });
}
function driven_points(mechanism: Mechanism, linkage: Linkage, row: number): Point[] {
  const {ends, joints, pose} = at_row(mechanism, linkage, linkage.drive!, row),
    four = [ends.input.center, ends.input.circle, ends.output.circle, ends.output.center];
  const own = mechanism.sampled_links ? joints : four.filter((point) => point !== null);
  return [...own, [pose.x, pose.y]];
}
function middle_of(samples: Samples, position: number): Point[] {
  const count = count_of(samples);
  return Array.from({length: samples.points}, (_, point) => {
    let x = 0,
      y = 0;
    for (let sample = 0; sample < count; ++sample) {
      const at = point_of(samples, sample, position, point);
      x += at[0];
      y += at[1];
    }
    return [x / count, y / count];
  });
}

export const four_bar_links: readonly SampledLink[] = [
  {role: "coupler", joints: [1, 2]},
  {role: "input", joints: [0, 1]},
  {role: "output", joints: [3, 2]},
];
export interface SamplePath {
  role: SampledLink["role"] | "origin";
  d: string;
}
const together = 25; // samples to a path: where several paths lie over each other it is darker

/** Deviations from `nominal` enlarged by `magnification`. */
export function sample_paths(
  samples: Samples,
  nominal: readonly Point[][],
  links: readonly SampledLink[],
  magnification: number,
  project: Projection,
): SamplePath[] {
  const count = count_of(samples),
    paths: SamplePath[] = [];
  const place = (sample: number, position: number, point: number): string => {
    const [x, y] = point_of(samples, sample, position, point),
      [x0, y0] = nominal[position]![point]!,
      at = project([x0 + magnification * (x - x0), y0 + magnification * (y - y0)]);
    return `${px(at[0])} ${px(at[1])}`;
  };
  for (let position = 0; position < samples.positions; ++position)
    for (let first = 0; first < count; first += together) {
      const some = Array.from({length: Math.min(together, count - first)}, (_, i) => first + i);
      for (const {role, joints} of links) {
        const end = joints.length > 2 ? "Z" : "";
        const d = some.map((sample) => `M${joints.map((j) => place(sample, position, j)).join("L")}${end}`).join("");
        paths.push({role, d});
      }
      paths.push({role: "origin", d: some.map((s) => `M${place(s, position, samples.points - 1)}h0`).join("")});
    }
  return paths;
}
/** Joints that the links have, and the body's origin after them. */
export function points_with(links: readonly SampledLink[]): number {
  return 2 + links.reduce((most, {joints}) => joints.reduce((a, b) => Math.max(a, b), most), 0);
}
