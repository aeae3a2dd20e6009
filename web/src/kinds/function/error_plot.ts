// What a generator makes wrong, over the driver angle as the other plots have it.
import type {Linkage} from "../../contract/messages";
import {significant} from "../../texts/numbers";
import {t} from "../../texts/texts.svelte";
import {extent, type Dial, type OwnPlot, type Plot} from "../../transport/plot";

type Generator = Pick<Linkage, "function" | "drive_sense">;

/** Driver angle from position 1 at an input angle of the task's dial. */
export function driver_angle(generator: Generator, input_deg: number): number {
  const {zero_deg, sense} = function_dial(generator) ?? {zero_deg: 0, sense: 1};
  return sense * (input_deg - zero_deg) + 0;
}

/** The same the other way round. */
export function function_dial({function: made, drive_sense}: Generator): Dial | null {
  const zero_deg = made?.pairs[0]?.[0];
  return zero_deg === undefined ? null : {zero_deg, sense: drive_sense === "cw" ? -1 : 1};
}

/** Over the whole range of the named function, with the precision points; nothing where only pairs are given. */
export function error_plot(generator: Generator): Plot | null {
  const made = generator.function;
  if (!made || made.curve.length === 0) return null;
  const rows = made.curve.map(([input, wanted, generated]) => ({
    angle: driver_angle(generator, input),
    error: generated === null ? null : generated - wanted,
  }));
  rows.sort((a, b) => a.angle - b.angle);
  const errors = rows.map(({error}) => error);
  const dots = made.pairs.map(([input, , error], pose) => ({
    pose,
    angle: driver_angle(generator, input),
    values: [error],
  }));
  return {
    kind: "own",
    columns: ["error_deg"],
    angles: rows.map(({angle}) => angle),
    values: [errors],
    dots,
    x: [rows[0]!.angle, rows[rows.length - 1]!.angle],
    y: extent([0, ...errors], 0.15),
  };
}
/** Between the samples, linear. */
export function error_at(generator: Generator, angle: number): number | null {
  const plot = error_plot(generator),
    samples = plot?.angles.map((at, i) => ({at, error: plot.values[0]?.[i] ?? null})) ?? [];
  const next = samples.findIndex(({at}) => at >= angle),
    after = samples[next],
    before = samples[Math.max(next - 1, 0)];
  if (!after || !before || angle < before.at || after.error === null || before.error === null) return null;
  const width = after.at - before.at;
  return width > 0 ? after.error + ((before.error - after.error) * (after.at - angle)) / width : after.error;
}

export const structural_error: OwnPlot = {
  id: "error",
  name: "plot.error",
  short_name: "plot.short_error",
  plot: error_plot,
  values_at: (linkage, angle) => [error_at(linkage, angle)],
  axes: () => [t("plot.axis_input"), t("plot.axis_error")],
  text: ([error = null]) => (error === null ? "–" : `${significant(error, 2)}°`),
};
