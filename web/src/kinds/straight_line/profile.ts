// The path of the point beside its line, and how fast it runs: what the plots and the magnifier show.
import type {Drive, Linkage} from "../../contract/messages";
import {state_at} from "../../state/drive";
import type {Problem} from "../../state/problem";
import {significant} from "../../texts/numbers";
import {t} from "../../texts/texts.svelte";
import {extent, type OwnPlot, type Plot} from "../../transport/plot";
import {along_line} from "./cases";
import type {StraightLine, Usable} from "./replies";
import {is_straight_line} from "./task";

/** The usable length that counts. */
export function counted({straight_line: line}: Linkage, {options}: Problem): Usable | null {
  return line ? (options?.measure === "strip" ? line.usable_strip : line.usable) : null;
}
/** Where the point is beside the line when the driver stands at an angle: s and e; nothing beyond the profile. */
export function place_at(line: StraightLine, angle: number): readonly [s: number, e: number] | null {
  const {profile} = line,
    next = profile.findIndex(([, , , turn], i) => {
      const before = profile[i - 1]?.[3];
      return before !== undefined && (angle - before) * (angle - turn) <= 0;
    });
  const from = profile[next - 1],
    to = profile[next];
  if (!from || !to) return null;
  const share = to[3] === from[3] ? 0 : (angle - from[3]) / (to[3] - from[3]);
  return [from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])];
}
/** The same anywhere on its way, as the drive's table has it. */
export function driven_place(
  drive: Drive,
  line: StraightLine,
  direction_deg: number,
  angle: number,
): readonly [s: number, e: number] {
  const {x, y} = state_at(drive, angle);
  return along_line({point: line.point, direction_deg}, [x, y]);
}

/** Both borders of the strip: about the line, or where it lies at its best. */
export function strip_of({deviation, strip_middle: middle}: StraightLine): [low: number, high: number] {
  return [middle - deviation, middle + deviation];
}

const room = 1.6; // of the strip, above and below
export function profile_plot({straight_line: line}: Pick<Linkage, "straight_line">): Plot | null {
  if (!line || line.profile.length < 2) return null;
  const s = line.profile.map(([at]) => at),
    e = line.profile.map(([, off]) => off),
    band = strip_of(line),
    {s_from, s_to} = line.over_usable,
    width = line.deviation;
  // Beside what is usable the path soon leaves the strip behind.
  const inside = line.profile.filter(([at]) => at >= s_from && at <= s_to).map(([, off]) => off);
  const [low, high] = extent([...inside, ...band], 0.1);
  const dots = [s_from, s_to].map((at, pose) => {
    const near = line.profile.reduce((best, row) => (Math.abs(row[0] - at) < Math.abs(best[0] - at) ? row : best));
    return {pose: pose * 2, angle: near[3], values: [at, near[1]]};
  });
  return {
    kind: "own",
    columns: ["s", "e"],
    angles: line.profile.map(([, , , turn]) => turn),
    values: [s, e],
    dots,
    x: extent(s, 0.02),
    y: [
      Math.max(low, line.strip_middle - room * Math.max(width, high - line.strip_middle)),
      Math.min(high, line.strip_middle + room * Math.max(width, line.strip_middle - low)),
    ],
    unit: "",
    band,
  };
}
export function speed_plot({straight_line: line}: Pick<Linkage, "straight_line">): Plot | null {
  if (!line || line.profile.length < 2) return null;
  const {s_from, s_to} = line.over_usable,
    rows = line.profile.filter(([s]) => s >= s_from && s <= s_to),
    speeds = rows.map(([, , velocity]) => velocity);
  if (rows.length < 2) return null;
  const sorted = speeds.filter((v) => v !== null).sort((a, b) => a - b),
    usual = sorted.slice(Math.floor(0.05 * sorted.length), Math.ceil(0.95 * sorted.length));
  const ordered = [...rows].sort((a, b) => a[3] - b[3]);
  return {
    kind: "own",
    columns: ["ds_dphi"],
    angles: ordered.map(([, , , turn]) => turn),
    values: [ordered.map(([, , velocity]) => velocity)],
    dots: [],
    x: [ordered[0]![3], ordered.at(-1)![3]],
    y: extent([0, ...usual], 0.15),
    unit: "",
  };
}
function speed_at(line: StraightLine, angle: number): number | null {
  const near = line.profile.reduce((best, row) => (Math.abs(row[3] - angle) < Math.abs(best[3] - angle) ? row : best));
  return Math.abs(near[3] - angle) < 5 ? near[2] : null;
}

export const profile: OwnPlot = {
  id: "profile",
  name: "straight.plot_profile",
  short_name: "straight.short_plot_profile",
  plot: profile_plot,
  axes: (unit) => [
    t("plot.axis_of", {name: "s", unit: unit || "1"}),
    t("plot.axis_of", {name: "e", unit: unit || "1"}),
  ],
  values_at: ({straight_line: line}, angle) => [...((line && place_at(line, angle)) ?? [null, null])],
  text: ([s = null, e = null], unit) =>
    s === null || e === null ? "–" : `s ${significant(s, 4)}  e ${significant(e, 2)} ${unit}`.trim(),
};
export const speed: OwnPlot = {
  id: "speed",
  name: "straight.plot_speed",
  short_name: "straight.short_plot_speed",
  plot: speed_plot,
  axes: (unit) => [t("plot.axis_driver"), t("plot.axis_of", {name: "ds/dφ", unit: `${unit || "1"}/rad`})],
  values_at: ({straight_line: line}, angle) => [line ? speed_at(line, angle) : null],
  text: ([velocity = null], unit) =>
    velocity === null ? "∞" : `${significant(velocity, 3)} ${unit}${unit ? "/" : "1/"}rad`.trim(),
};

/** The direction of the task's line; 0 of other tasks. */
export function direction_of({task}: Problem): number {
  return is_straight_line(task) ? task.line.direction_deg : 0;
}
