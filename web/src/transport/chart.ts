// The plot's picture. One uPlot for the panel's lifetime: new data, sizes and colours go into it, nothing is rebuilt.
import UPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import {css_values} from "../state/css_values";
import {fixed, significant} from "../texts/numbers";
import {bare_axis, bare_plot, title_height} from "./bare_plot";
import {dial_splits, is_path, round_between, type Dial, type Plot} from "./plot";

type Colors = Record<"ink" | "ink3" | "line" | "grid" | "paper" | "bad" | "good" | "curve", string>;
const color_names = ["ink", "ink3", "line", "grid", "paper", "bad", "good", "curve"] as const;
const dot_radius = 3.5;

export interface ChartInput {
  plot: Plot;
  /** The least value that is allowed, where the plot has one. */
  least: number | null;
  /** What stands at the axes. */
  titles: readonly [x: string, y: string];
  /** How the driver's angle is counted along x, where not from position 1. */
  dial: Dial | null;
  width: number;
  height: number;
}

export class Chart {
  private readonly u: UPlot;
  private readonly needle: HTMLElement;
  private readonly bead: HTMLElement;
  private input: ChartInput | null = null;
  private colors: Colors;

  constructor(private readonly host: HTMLElement) {
    this.colors = this.read_colors();
    this.u = new UPlot(
      this.options(),
      [
        [0, 1],
        [null, null],
      ],
      host,
    );
    this.needle = this.mark("needle");
    this.bead = this.mark("bead");
  }
  destroy(): void {
    this.u.destroy();
  }
  /** Where the pointer may drag. */
  get surface(): HTMLElement {
    return this.u.over;
  }

  show(input: ChartInput): void {
    const {u} = this,
      resized = input.width !== u.width || input.height !== u.height;
    this.input = input;
    const {plot} = input;
    u.batch(() => {
      if (resized) u.setSize({width: input.width, height: input.height});
      u.setData(is_path(plot) ? [plot.x, [null, null]] : ([plot.angles, plot.values[0]] as UPlot.AlignedData), false);
      u.setScale("x", {min: plot.x[0], max: plot.x[1]});
      u.setScale("y", {min: plot.y[0], max: plot.y[1]});
    });
  }
  /** The theme has changed. */
  recolor(): void {
    this.colors = this.read_colors();
    this.u.redraw(false);
  }
  /** Marks the driver angle and the value there, without drawing anew. */
  point_at(angle: number, values: (number | null)[]): void {
    const plot = this.input?.plot;
    if (!plot) return;
    const of_path = is_path(plot),
      y = values[of_path ? 1 : 0] ?? null;
    const x = of_path ? values[0]! : angle;
    const left = this.u.valToPos(x, "x"),
      top = y === null ? -99 : this.u.valToPos(y, "y");
    const {width, height} = this.u.bbox,
      ratio = UPlot.pxRatio; // known without asking for the layout
    const inside = left >= -0.5 && left <= width / ratio + 0.5;
    this.needle.hidden = of_path || !inside;
    this.bead.hidden = !inside || !(top >= 0 && top <= height / ratio);
    this.needle.style.transform = `translateX(${left}px)`;
    this.bead.style.transform = `translate(${left}px, ${top}px)`;
  }
  /** The plot's own coordinates under a pointer. */
  under(event: PointerEvent): [x: number, y: number] {
    const box = this.u.over.getBoundingClientRect();
    return [this.u.posToVal(event.clientX - box.left, "x"), this.u.posToVal(event.clientY - box.top, "y")];
  }

  private mark(name: string): HTMLElement {
    const element = document.createElement("div");
    element.className = name;
    this.u.over.append(element);
    return element;
  }
  private read_colors(): Colors {
    return css_values(this.host, color_names);
  }
  private options(): UPlot.Options {
    const font = `11px ${getComputedStyle(this.host).fontFamily}`;
    const axis = bare_axis(font, () => this.colors);
    return {
      ...bare_plot(124, 12),
      axes: [
        {
          ...axis,
          size: 17 + title_height,
          gap: 3,
          space: 56,
          grid: {show: false},
          splits: (u, _, min, max) => this.x_splits(min, max, u.width),
          values: (_, splits) => splits.map((v) => this.x_label(v)),
        },
        {
          ...axis,
          size: 46,
          gap: 5,
          space: 18,
          splits: (_, __, min, max) => this.y_splits(min, max),
          values: (_, splits) => splits.map((v) => this.y_label(v)),
        },
      ],
      series: [{}, {stroke: () => this.colors.ink, width: 2, pxAlign: 0, points: {show: false}}], // no steps of a pixel
      hooks: {
        drawAxes: [() => this.draw_forbidden(), () => this.draw_band()],
        draw: [() => this.draw_path(), () => this.draw_dots(), () => this.draw_titles()],
      },
    };
  }
  private x_label(value: number): string {
    if (this.input && is_path(this.input.plot)) return significant(value, 4);
    const {zero_deg, sense} = this.input?.dial ?? {zero_deg: 0, sense: 1};
    return `${significant(zero_deg + sense * value, 4)}°`;
  }
  private y_label(value: number): string {
    const kind = this.input?.plot.kind;
    if (kind === "own" || kind === "output") return `${significant(value, 2)}${this.input?.plot.unit ?? "°"}`;
    return kind === "transmission" || kind === "coupler" ? `${fixed(value, 0)}°` : significant(value, 4);
  }
  private x_splits(min: number, max: number, width: number): number[] {
    const most = Math.max(Math.floor(width / 80), 2),
      dial = this.input && !is_path(this.input.plot) ? this.input.dial : null;
    return dial ? dial_splits(dial, min, max, most) : round_between(min, max, most);
  }
  private y_splits(min: number, max: number): number[] {
    return this.input?.plot.kind === "transmission" ? [0, 30, 60, 90] : round_between(min, max, 4);
  }

  private draw_titles(): void {
    const {u, input} = this;
    if (!input) return;
    const {ctx, bbox} = u,
      ratio = UPlot.pxRatio,
      [x, y] = input.titles;
    ctx.save();
    ctx.font = `${11 * ratio}px ${getComputedStyle(this.host).fontFamily}`;
    ctx.fillStyle = this.colors.ink3;
    [ctx.textAlign, ctx.textBaseline] = ["left", "top"];
    ctx.fillText(y, 2 * ratio, 0);
    [ctx.textAlign, ctx.textBaseline] = ["right", "bottom"];
    ctx.fillText(x, bbox.left + bbox.width, u.height * ratio - ratio);
    ctx.restore();
  }

  private draw_forbidden(): void {
    const {u, input} = this;
    if (!input || input.least === null) return;
    const {left, top, width, height} = u.bbox,
      y = u.valToPos(input.least, "y", true);
    u.ctx.save();
    u.ctx.fillStyle = u.ctx.strokeStyle = this.colors.bad;
    u.ctx.globalAlpha = 0.07;
    u.ctx.fillRect(left, y, width, top + height - y);
    u.ctx.globalAlpha = 1;
    u.ctx.lineWidth = UPlot.pxRatio;
    u.ctx.setLineDash([3 * UPlot.pxRatio, 3 * UPlot.pxRatio]);
    u.ctx.beginPath();
    u.ctx.moveTo(left, y);
    u.ctx.lineTo(left + width, y);
    u.ctx.stroke();
    u.ctx.restore();
  }
  private draw_band(): void {
    const {u, input} = this,
      {left, width} = u.bbox,
      band = input?.plot.band;
    if (!band) return;
    const [bottom, top] = band.map((value) => u.valToPos(value, "y", true)) as [number, number];
    u.ctx.save();
    u.ctx.fillStyle = this.colors.good;
    u.ctx.globalAlpha = 0.14;
    u.ctx.fillRect(left, top, width, bottom - top);
    u.ctx.restore();
  }
  private draw_path(): void {
    const {u, input} = this;
    if (!input || !is_path(input.plot)) return;
    const [xs, ys] = input.plot.values;
    u.ctx.save();
    u.ctx.strokeStyle = this.colors.ink;
    u.ctx.lineWidth = 2 * UPlot.pxRatio;
    u.ctx.lineJoin = "round";
    u.ctx.beginPath();
    xs!.forEach((x, i) => u.ctx.lineTo(u.valToPos(x!, "x", true), u.valToPos(ys![i]!, "y", true)));
    u.ctx.stroke();
    u.ctx.restore();
  }
  private draw_dots(): void {
    const {u, input} = this;
    if (!input) return;
    const of_path = is_path(input.plot),
      {ctx} = u;
    ctx.save();
    ctx.font = `${11 * UPlot.pxRatio}px ${getComputedStyle(this.host).fontFamily}`;
    ctx.textAlign = "center";
    for (const dot of input.plot.dots) {
      const value = dot.values[of_path ? 1 : 0];
      if (value === null) continue;
      this.draw_dot(
        u.valToPos(of_path ? dot.values[0]! : dot.angle, "x", true),
        u.valToPos(value!, "y", true),
        String(dot.pose + 1),
      );
    }
    ctx.restore();
  }
  private draw_dot(x: number, y: number, name: string): void {
    const {ctx, bbox} = this.u,
      r = dot_radius * UPlot.pxRatio;
    if (y < bbox.top - r || y > bbox.top + bbox.height + r) return;
    ctx.beginPath();
    ctx.arc(x, y, r, 0, 2 * Math.PI);
    ctx.fillStyle = this.colors.paper;
    ctx.fill();
    ctx.strokeStyle = this.colors.ink;
    ctx.lineWidth = 1.5 * UPlot.pxRatio;
    ctx.stroke();
    const below = y - bbox.top < 18 * UPlot.pxRatio;
    ctx.fillStyle = this.colors.ink3;
    ctx.textBaseline = below ? "top" : "bottom";
    ctx.fillText(name, x, below ? y + 1.6 * r : y - 1.4 * r);
  }
}
