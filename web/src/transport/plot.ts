// What the plot shows: columns of the drive table over the driver angle, or the path of the body.
import {state_columns, type Drive, type Linkage} from "../contract/messages";
import {angle_of_row, row_count, state_at} from "../state/drive";
import type {TextKey} from "../texts/texts.svelte";
import {played_span, stops_of} from "./play";

export const plot_kinds = ["transmission", "coupler", "path", "velocity", "advantage"] as const;
/** Columns of the drive table. */
export type DriveKind = (typeof plot_kinds)[number] | "output";
/** What a kind of task plots of its own, beside columns of the drive table: over the driver angle, or as a path. */
export interface OwnPlot {
  id: string;
  name: TextKey;
  short_name: TextKey;
  plot(linkage: Linkage): Plot | null;
  /** One to each of the plot's columns. */
  values_at(linkage: Linkage, angle_deg: number): (number | null)[];
  text(values: (number | null)[], unit: string): string;
  /** What stands at its axes; otherwise the driver angle, and its name. `unit`: of lengths. */
  axes?(unit: string): [x: string, y: string];
}
/** How the task counts the driver's angle, where not from position 1. */
export interface Dial {
  zero_deg: number; // in position 1
  sense: 1 | -1;
}
/** Round values between two ends, at most so many and one more. */
export function round_between(low: number, high: number, most: number): number[] {
  const power = 10 ** Math.floor(Math.log10((high - low) / most));
  const step = [1, 2, 5, 10].map((digit) => digit * power).find((s) => (high - low) / s <= most) ?? 10 * power;
  const first = Math.ceil(low / step - 1e-9);
  return Array.from({length: Math.floor(high / step + 1e-9) - first + 1}, (_, i) => (first + i) * step);
}
/** Driver angles from position 1 at round angles of the dial. */
export function dial_splits({zero_deg, sense}: Dial, low: number, high: number, most: number): number[] {
  const [from, to] = sense > 0 ? [low, high] : [high, low],
    round = round_between(zero_deg + sense * from, zero_deg + sense * to, most);
  return round.map((angle) => sense * (angle - zero_deg)).sort((a, b) => a - b);
}
export type PlotChoice = DriveKind | OwnPlot;
type Column = (typeof state_columns)[number];
const columns: Record<DriveKind, Column[]> = {
  transmission: ["transmission_angle_deg"],
  coupler: ["coupler_deg"],
  path: ["x", "y"],
  output: ["output_deg"],
  velocity: ["velocity_ratio"],
  advantage: ["mechanical_advantage"],
};
const zero_is_nothing: readonly DriveKind[] = ["velocity", "advantage"]; // at dead points

export interface Plot {
  kind: DriveKind | "own";
  /** Names of the values, in files. */
  columns: readonly string[];
  angles: number[];
  /** One column, or x and y of the path. Null: not defined there. */
  values: (number | null)[][];
  dots: {pose: number; angle: number; values: (number | null)[]}[];
  x: [number, number];
  y: [number, number];
  /** Own values are no angles. */
  unit?: "°" | "";
  /** Between these all is well. */
  band?: readonly [low: number, high: number];
}
export function is_path({values}: Plot): boolean {
  return values.length === 2;
}

export function plot_of(drive: Drive, kind: DriveKind, whole: boolean): Plot {
  const [low, high] = played_span(drive, whole);
  const rows = Array.from({length: row_count(drive)}, (_, row) => row).filter((row) => {
    const angle = drive.states[row * drive.width];
    return angle! >= low && angle! <= high;
  });
  const names = columns[kind];
  const values = names.map((name) =>
    rows.map((row) => shown(kind, drive.states[row * drive.width + state_columns.indexOf(name)]!)),
  );
  const dots = stops_of(drive)
    .filter((s) => s.angle >= low && s.angle <= high)
    .map((s) => ({...s, values: values_at(drive, kind, s.angle)}));
  const plot: Plot = {
    kind,
    columns: names,
    angles: rows.map((row) => angle_of_row(drive, row)),
    values,
    dots,
    x: [low, high],
    y: [0, 1],
  };
  if (kind === "path") plot.x = extent(values[0]!, 0.08);
  plot.y = value_range(kind, values.at(-1) ?? []);
  return plot;
}
export function values_at(drive: Drive, kind: DriveKind, angle: number): (number | null)[] {
  const state = state_at(drive, angle);
  return columns[kind].map((name) => shown(kind, state[name]));
}
function shown(kind: DriveKind, value: number): number | null {
  return value === 0 && zero_is_nothing.includes(kind) ? null : value;
}

function value_range(kind: DriveKind, values: (number | null)[]): [number, number] {
  if (kind === "transmission") return [0, 90];
  if (kind === "coupler" || kind === "output" || kind === "path") return extent(values, 0.08);
  // Both grow without bound toward a dead point: the middle nine tenths are what can be read.
  const sorted = values.filter((v) => v !== null).sort((a, b) => a - b);
  if (sorted.length === 0) return [0, 1];
  const trimmed = sorted.slice(Math.floor(0.05 * (sorted.length - 1)), Math.ceil(0.95 * (sorted.length - 1)) + 1);
  return extent([0, ...trimmed], 0.15);
}
export function extent(values: (number | null)[], margin: number): [number, number] {
  let low = Infinity,
    high = -Infinity;
  for (const value of values) {
    if (value === null) continue;
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  if (!(high >= low)) return [0, 1];
  const room = high > low ? margin * (high - low) : Math.max(Math.abs(high), 1) * margin;
  return [low - room, high + room];
}

/** Driver angle of the path's row nearest to a point. */
export function nearest_on_path(plot: Plot, x: number, y: number): number {
  const [xs, ys] = plot.values;
  let best = 0,
    best_distance = Infinity;
  xs!.forEach((at, i) => {
    const distance = Math.hypot(at! - x, ys![i]! - y);
    if (distance < best_distance) [best, best_distance] = [i, distance];
  });
  return plot.angles[best] ?? 0;
}

/** What is shown, as comma-separated values; where nothing is defined the field is empty. */
export function plot_csv(plot: Plot): string {
  const lines = plot.angles.map((angle, row) => [angle, ...plot.values.map((column) => column[row] ?? "")].join(","));
  return [["input_deg", ...plot.columns].join(","), ...lines, ""].join("\n");
}
