// What plots have in common: no legend, no cursor, their scales set from outside, and axes without ticks.
import type UPlot from "uplot";

/** Room above the axes for what stands at them, pixels. */
export const title_height = 14;

/** `colors`: as they are when it is drawn. */
export function bare_axis(font: string, colors: () => {ink3: string; line: string}): UPlot.Axis {
  return {
    font,
    stroke: () => colors().ink3,
    ticks: {show: false},
    grid: {stroke: () => colors().line, width: 1},
  };
}
/** `right`: room beside the plot, pixels. Its size is that until it has one. */
export function bare_plot(height: number, right: number): Omit<UPlot.Options, "series"> {
  return {
    width: 300,
    height,
    legend: {show: false},
    cursor: {show: false},
    padding: [title_height + 5, right, 0, 0],
    scales: {x: {time: false, auto: false}, y: {auto: false}},
  };
}
