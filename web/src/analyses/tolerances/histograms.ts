// Small histograms of the errors, one to a position, over one scale.
import {most_of} from "../../state/ends";
import type {ToleranceAnswer} from "../../contract/messages";

const most_shown = 6;

/** Of many positions, as a line has them, a few evenly from the first to the last. */
export function shown_positions(count: number): number[] {
  if (count <= most_shown) return Array.from({length: count}, (_, i) => i);
  return Array.from({length: most_shown}, (_, i) => Math.round((i * (count - 1)) / (most_shown - 1)));
}
/** Up to where the scale is worth showing: the last bins of the largest error of all may hold one sample in thousands. */
export function shown_bins({counts}: ToleranceAnswer["histograms"], limit_bin: number | null): number {
  const last = most_of(counts.map((bins) => bins.findLastIndex((count) => count > 0))),
    wanted = limit_bin === null ? last + 1 : Math.max(last + 1, Math.ceil(limit_bin) + 1);
  return Math.max(wanted, 1);
}
/** Steps as a path in a field of this size, y down; all positions by the same most. */
export function steps_path(counts: readonly number[], most: number, width: number, height: number): string {
  const step = width / counts.length,
    at = (value: number) => Math.round(value * 10) / 10;
  const steps = counts.map((count, i) => `L${at(i * step)} ${at(height * (1 - count / most))}H${at((i + 1) * step)}`);
  return `M0 ${height}${steps.join("")}V${height}Z`;
}
/** Middle of the fullest bin, and the upper end of the last one that holds a sample. */
export function peak_and_most(counts: readonly number[], from: number, to: number): {peak: number; most: number} {
  const width = (to - from) / counts.length,
    end = most_of(counts);
  return {
    peak: from + (counts.indexOf(end) + 0.5) * width,
    most: from + (counts.findLastIndex((count) => count > 0) + 1) * width,
  };
}
