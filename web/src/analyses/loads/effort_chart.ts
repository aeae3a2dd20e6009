// The picture of the effort: two lines to each case, the chosen one in front.
import UPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import {css_values} from "../../state/css_values";
import {significant} from "../../texts/numbers";
import {bare_axis, bare_plot, title_height} from "../../transport/bare_plot";
import {round_between} from "../../transport/plot";
import {plot_left, plot_right, type Effort, type EffortMark, type EffortMarks} from "./effort";

const color_names = ["ink", "ink3", "line", "sunk", "paper", "accent", "curve", "bad", "good"] as const;
type Colors = Record<(typeof color_names)[number], string>;
const dot_radius = 3,
  mark_radius = 5;

/** A demand of a requirement on one of the two curves, or at the end of opening alone. */
export interface Demand {
  value: number;
  on: "open" | "close" | "end";
}
export interface EffortInput {
  effort: Effort;
  chosen: number;
  demands: readonly Demand[];
  /** Of the chosen case. */
  marked: EffortMarks;
  titles: readonly [x: string, y: string];
  width: number;
  height: number;
}

export class EffortChart {
  private u: UPlot;
  private needle: HTMLElement;
  private input: EffortInput | null = null;
  private colors: Colors;

  constructor(private readonly host: HTMLElement) {
    this.colors = css_values(host, color_names);
    [this.u, this.needle] = this.made(2);
  }
  destroy(): void {
    this.u.destroy();
  }
  show(input: EffortInput): void {
    const {effort, chosen, width, height} = input,
      lines = effort.cases.flatMap(({open, close}) => [open, close ?? open.map(() => null)]);
    this.input = input;
    if (this.u.series.length !== lines.length + 1) {
      this.u.destroy();
      [this.u, this.needle] = this.made(lines.length);
    }
    const {u} = this;
    u.series.forEach((series, i) => (series.width = line_of(i) === chosen ? 2.5 : 1));
    u.batch(() => {
      if (width !== u.width || height !== u.height) u.setSize({width, height});
      u.setData([effort.x, ...lines] as UPlot.AlignedData, false);
      u.setScale("x", {min: effort.x[0]!, max: effort.x.at(-1)!});
      u.setScale("y", {min: effort.y[0], max: effort.y[1]});
    });
  }
  recolor(): void {
    this.colors = css_values(this.host, color_names);
    this.u.redraw(false);
  }
  /** Marks where the drive is; null: not on the plot. */
  point_at(x: number | null): void {
    this.needle.hidden = x === null;
    if (x !== null) this.needle.style.transform = `translateX(${this.u.valToPos(x, "x")}px)`;
  }
  /** Whether it lies on the plot's own field. */
  is_over(event: PointerEvent): boolean {
    return this.u.over.contains(event.target as Node);
  }
  x_under(event: PointerEvent): number {
    return this.u.posToVal(event.clientX - this.u.over.getBoundingClientRect().left, "x");
  }

  private made(lines: number): [UPlot, HTMLElement] {
    const nothing = Array.from({length: lines}, () => [null, null]),
      u = new UPlot(this.options(lines), [[0, 1], ...nothing] as UPlot.AlignedData, this.host),
      needle = document.createElement("div");
    needle.className = "needle";
    needle.hidden = true;
    u.over.append(needle);
    return [u, needle];
  }
  private options(lines: number): UPlot.Options {
    const axis = bare_axis(this.font(1), () => this.colors);
    return {
      ...bare_plot(150, plot_right),
      axes: [
        {
          ...axis,
          size: 17 + title_height,
          gap: 3,
          grid: {show: false},
          splits: (u, _, min, max) => round_between(min, max, Math.max(Math.floor(u.width / 80), 2)),
          values: (_, splits) => splits.map((x) => this.x_text(x)),
        },
        {
          ...axis,
          size: plot_left,
          gap: 5,
          splits: (_, __, min, max) => round_between(min, max, 5),
          values: (_, splits) => splits.map((value) => significant(value, 4)),
        },
      ],
      series: [{}, ...Array.from({length: lines}, (_, i) => this.line(i + 1))],
      hooks: {
        drawAxes: [() => this.draw_rests(), () => this.draw_zero(), () => this.draw_demands()],
        draw: [() => this.draw_positions(), () => this.draw_marks(), () => this.draw_titles()],
      },
    };
  }
  private line(series: number): UPlot.Series {
    const is_close = series % 2 === 0;
    return {
      stroke: () => (line_of(series) === this.input?.chosen ? this.colors.accent : this.colors.curve),
      width: 1,
      pxAlign: 0,
      points: {show: false},
      ...(is_close ? {dash: [5, 4]} : {}),
    };
  }
  private font(ratio: number): string {
    return `${11 * ratio}px ${getComputedStyle(this.host).fontFamily}`;
  }

  private x_text(x: number): string {
    const {sense = 1, over = "body"} = this.input?.effort ?? {};
    return `${significant(sense * x, 4)}${over === "path" ? "\u00a0%" : "°"}`;
  }
  /** Where friction holds it. */
  private draw_rests(): void {
    const {u, input} = this;
    if (!input) return;
    u.ctx.save();
    u.ctx.fillStyle = this.colors.sunk;
    for (const [from, to] of input.marked.rests) {
      const [left, right] = [u.valToPos(from, "x", true), u.valToPos(to, "x", true)];
      u.ctx.fillRect(left, u.bbox.top, Math.max(right - left, UPlot.pxRatio), u.bbox.height);
    }
    u.ctx.restore();
  }
  private draw_marks(): void {
    const {u, input} = this;
    if (!input) return;
    u.ctx.save();
    u.ctx.setLineDash([]);
    const y = u.valToPos(0, "y", true);
    for (const {kind, x} of input.marked.marks) this.draw_mark(kind, u.valToPos(x, "x", true), y);
    u.ctx.restore();
  }
  private draw_mark(kind: EffortMark["kind"], x: number, y: number): void {
    const {ctx} = this.u,
      r = mark_radius * UPlot.pxRatio,
      up = kind === "close" ? -1 : 1;
    ctx.beginPath();
    if (kind === "stable" || kind === "unstable") ctx.arc(x, y, r, 0, 2 * Math.PI);
    else {
      ctx.moveTo(x, y - up * 1.2 * r);
      ctx.lineTo(x + r, y + up * 0.8 * r);
      ctx.lineTo(x - r, y + up * 0.8 * r);
      ctx.closePath();
    }
    ctx.fillStyle = kind === "unstable" ? this.colors.paper : kind === "stable" ? this.colors.ink : this.colors.good;
    ctx.fill();
    ctx.strokeStyle = kind === "stable" || kind === "unstable" ? this.colors.ink : this.colors.paper;
    ctx.lineWidth = UPlot.pxRatio;
    ctx.stroke();
  }
  private draw_zero(): void {
    this.draw_level(0, this.colors.ink3, []);
  }
  private draw_demands(): void {
    for (const {value, on} of this.input?.demands ?? [])
      this.draw_level(value, this.colors.bad, on === "close" ? [6, 3] : [2, 2], on === "end" ? 0.92 : 0);
  }
  /** `from`: which share of the way is left out. */
  private draw_level(value: number, color: string, dash: readonly number[], from = 0): void {
    const {u, input} = this,
      {ctx, bbox} = u,
      ratio = UPlot.pxRatio;
    if (!input || value < input.effort.y[0] || value > input.effort.y[1]) return;
    const y = u.valToPos(value, "y", true);
    ctx.save();
    ctx.strokeStyle = color;
    ctx.lineWidth = ratio;
    ctx.setLineDash(dash.map((length) => length * ratio));
    ctx.beginPath();
    ctx.moveTo(bbox.left + from * bbox.width, y);
    ctx.lineTo(bbox.left + bbox.width, y);
    ctx.stroke();
    ctx.restore();
  }
  private draw_positions(): void {
    const {u, input} = this;
    if (!input) return;
    const {effort, chosen} = input,
      {ctx} = u;
    ctx.save();
    ctx.setLineDash([]); // the last line may have been dashed
    ctx.font = this.font(UPlot.pxRatio);
    [ctx.textAlign, ctx.textBaseline] = ["center", "bottom"];
    for (const {position, x} of effort.positions) {
      const value = effort.cases[chosen]?.open[effort.x.indexOf(x)] ?? null;
      if (value !== null) this.draw_dot(u.valToPos(x, "x", true), u.valToPos(value, "y", true), String(position));
    }
    ctx.restore();
  }
  private draw_dot(x: number, y: number, name: string): void {
    const {ctx} = this.u,
      r = dot_radius * UPlot.pxRatio;
    ctx.beginPath();
    ctx.arc(x, y, r, 0, 2 * Math.PI);
    ctx.fillStyle = this.colors.paper;
    ctx.fill();
    ctx.strokeStyle = this.colors.accent;
    ctx.lineWidth = 1.5 * UPlot.pxRatio;
    ctx.stroke();
    ctx.fillStyle = this.colors.ink3;
    ctx.fillText(name, x, y - 1.4 * r);
  }
  private draw_titles(): void {
    const {u, input} = this;
    if (!input) return;
    const {ctx, bbox} = u,
      ratio = UPlot.pxRatio,
      [x, y] = input.titles;
    ctx.save();
    ctx.font = this.font(ratio);
    ctx.fillStyle = this.colors.ink3;
    [ctx.textAlign, ctx.textBaseline] = ["left", "top"];
    ctx.fillText(y, 2 * ratio, 0);
    [ctx.textAlign, ctx.textBaseline] = ["right", "bottom"];
    ctx.fillText(x, bbox.left + bbox.width, u.height * ratio - ratio);
    ctx.restore();
  }
}
/** The case of a series: there are an opening and a closing line to each. */
function line_of(series: number): number {
  return Math.floor((series - 1) / 2);
}
