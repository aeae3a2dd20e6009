// Transmission angles of several linkages over their driver angles, in one plot.
import UPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import {state_columns, type Drive} from "../contract/messages";
import {least_of, most_of} from "../state/ends";

export interface Curve {
  name: string;
  drive: Drive;
  color: string;
  dash: number[];
}
const transmission = state_columns.indexOf("transmission_angle_deg");
/** Lines are told apart by colour and by dashes. */
export const dashes = [[], [7, 4], [2, 3], [9, 3, 2, 3], [4, 4], [12, 4]];
export const colors = ["--accent", "--output", "--good", "--body", "--warn", "--bad"];

/** Angles and transmission angles between the first and the last position, or over all that can be driven. */
export function stretch(drive: Drive): [angles: number[], values: number[]] {
  const all = drive.states.length / drive.width,
    whole = drive.task[0] < 0 || drive.task[1] < 0;
  const first = whole ? 0 : least_of(drive.task),
    last = whole ? all - 1 : most_of(drive.task);
  const angles: number[] = [],
    values: number[] = [];
  for (let row = first; row <= last; ++row) {
    const angle = drive.states[row * drive.width]!;
    if (angle <= (angles.at(-1) ?? -Infinity)) continue; // uPlot wants rising x
    angles.push(angle);
    values.push(drive.states[row * drive.width + transmission]!);
  }
  return [angles, values];
}

export function draw_overlay(host: HTMLElement, curves: readonly Curve[], label: string): UPlot {
  const style = getComputedStyle(document.documentElement),
    ink = style.getPropertyValue("--ink3"),
    line = style.getPropertyValue("--line");
  const font = `11px ${getComputedStyle(document.body).fontFamily}`;
  const axis: UPlot.Axis = {stroke: ink, font, grid: {stroke: line, width: 1}, ticks: {show: false}};
  const data = curves.length
    ? UPlot.join(curves.map(({drive}) => stretch(drive) as UPlot.AlignedData))
    : ([[], []] as unknown as UPlot.AlignedData);
  return new UPlot(
    {
      width: host.clientWidth,
      height: 180,
      legend: {show: false},
      cursor: {show: false},
      padding: [8, 12, 0, 0],
      scales: {x: {time: false}, y: {range: [0, 90]}},
      axes: [
        {
          ...axis,
          label,
          labelFont: font,
          labelSize: 18,
          size: 28,
          values: (_, ticks) => ticks.map((v) => `${String(v).replace("-", "−")}°`),
        },
        {...axis, size: 38, splits: () => [0, 30, 60, 90], values: (_, ticks) => ticks.map((v) => `${v}°`)},
      ],
      series: [
        {},
        ...curves.map(({color, dash, name}) => ({
          label: name,
          stroke: style.getPropertyValue(color),
          dash,
          width: 1.8,
          spanGaps: true,
          points: {show: false},
        })),
      ],
    },
    data,
    host,
  );
}
