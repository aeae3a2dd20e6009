// How fast a driven linkage moves: the engine's rates, which are of a driver of one radian per second, at its speed.
import type {Linkage} from "../../contract/messages";
import {angle_of_row, row_at} from "../../state/drive";
import {significant} from "../../texts/numbers";
import {t} from "../../texts/texts.svelte";
import {extent, type OwnPlot, type Plot} from "../../transport/plot";
import {played_span} from "../../transport/play";
import type {Rates} from "./replies";
import {driver} from "./speed.svelte";

export interface BodyRate {
  body: string;
  /** rad/s, rad/s² */
  speed: number;
  acceleration: number;
}
/** At the driver's speed, at an angle of it. */
export interface RatesNow {
  bodies: BodyRate[];
  /** Magnitudes, user's unit. */
  point: {speed: number; acceleration: number} | null;
}

export function omega(rpm: number): number {
  return (2 * Math.PI * rpm) / 60;
}
function row_between(rates: Rates, row: number, share: number): number[] | null {
  const one = rates.rows[row] ?? null,
    next = share > 0 ? (rates.rows[row + 1] ?? null) : one;
  return one && next && one.map((value, k) => value + share * (next[k]! - value));
}
function of_row(bodies: readonly string[], row: readonly number[], rpm: number): RatesNow {
  const w = omega(rpm),
    [vx, vy, ax, ay] = row.slice(2 * bodies.length);
  return {
    bodies: bodies.map((body, i) => ({body, speed: w * row[2 * i]!, acceleration: w * w * row[2 * i + 1]!})),
    point: vx === undefined ? null : {speed: w * Math.hypot(vx, vy!), acceleration: w * w * Math.hypot(ax!, ay!)},
  };
}
/** Null at a dead point, where they are unbounded. */
export function rates_at({rates, drive}: Linkage, angle_deg: number, rpm: number): RatesNow | null {
  if (!rates || !drive) return null;
  const {row, share} = row_at(drive, angle_deg),
    now = row_between(rates, row, share);
  return now && of_row(rates.bodies, now, rpm);
}

/** The point's, over the whole travel. */
function plot_of_point(what: "speed" | "acceleration", unit: string): OwnPlot {
  const value = (now: RatesNow | null) => now?.point?.[what] ?? null;
  return {
    id: `point_${what}`,
    name: `linkage.point_${what}`,
    short_name: `linkage.short_point_${what}`,
    plot(linkage): Plot | null {
      const {rates, drive} = linkage;
      if (!rates || !drive) return null;
      const values = rates.rows.map((row) => value(row && of_row(rates.bodies, row, driver.rpm))),
        angles = rates.rows.map((_, row) => angle_of_row(drive, row));
      return {
        kind: "own",
        columns: [`point_${what}`],
        angles,
        values: [values],
        dots: [],
        x: [...played_span(drive, true)],
        y: readable(values),
        unit: "",
      };
    },
    axes: (length_unit) => [
      t("plot.axis_driver"),
      t("plot.axis_of", {name: t(`linkage.point_${what}`), unit: `${length_unit || "1"}${unit}`}),
    ],
    values_at: (linkage, angle_deg) => [value(rates_at(linkage, angle_deg, driver.rpm))],
    text: ([now = null], length_unit) => (now === null ? "∞" : `${significant(now, 4)} ${length_unit || "1"}${unit}`),
  };
}
/** They grow without bound towards dead points: nine tenths of them are what can be read. */
function readable(values: readonly (number | null)[]): [number, number] {
  const sorted = values.filter((value) => value !== null).sort((a, b) => a - b);
  return extent([0, ...sorted.slice(0, Math.ceil(0.95 * sorted.length))], 0.12);
}
export const point_plots: readonly OwnPlot[] = [plot_of_point("speed", "/s"), plot_of_point("acceleration", "/s²")];
