// A figure on a canvas, for films.
import type {Point} from "../contract/messages";
import {is_plate, is_slender, placed_outline, web_of, type Figure, type Joint, type Role} from "./figure";
import type {Projection} from "./paths";

export const figure_colors = ["paper", "ink", "ink3", "line", "accent", "input", "output", "body"] as const;
export type FigureColors = Record<(typeof figure_colors)[number], string>;
type Context = CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D;

/** Onto what is there. */
export function paint_figure(context: Context, figure: Figure, at: Projection, colors: FigureColors): void {
  new Painter(context, at, colors).paint(figure);
}

class Painter {
  constructor(
    private readonly context: Context,
    private readonly at: Projection,
    private readonly colors: FigureColors,
  ) {}

  paint(figure: Figure): void {
    this.context.globalAlpha = 1;
    this.context.lineCap = this.context.lineJoin = "round";
    this.backdrop(figure);
    this.positions(figure);
    this.path(figure);
    this.numbers(figure);
    this.guided(figure);
    this.links(figure);
    for (const joint of figure.joints) this.joint(joint, is_slender(figure));
  }

  private color(role: Role): string {
    return this.colors[role === "driver" ? "accent" : role === "coupler" ? "body" : role];
  }
  private trace(points: readonly Point[], closed: boolean): void {
    this.context.beginPath();
    for (const point of points) this.context.lineTo(...this.at(point));
    if (closed) this.context.closePath();
  }
  private stroke(color: string, width: number): void {
    this.context.strokeStyle = color;
    this.context.lineWidth = width;
    this.context.stroke();
  }
  private fill(color: string, opacity: number): void {
    this.context.fillStyle = color;
    this.context.globalAlpha = opacity;
    this.context.fill();
    this.context.globalAlpha = 1;
  }

  private backdrop({backdrop = []}: Figure): void {
    for (const points of backdrop) {
      this.trace(points, false);
      this.stroke(this.colors.line, 1.2);
    }
  }
  private positions({positions}: Figure): void {
    for (const {outline} of positions) {
      this.trace(outline, true);
      this.stroke(this.colors.line, 1.2);
    }
  }
  private path({traces}: Figure): void {
    this.context.setLineDash([0.1, 4.5]);
    for (const {points} of traces) {
      this.trace(points, false);
      this.stroke(this.colors.accent, 1.6);
    }
    this.context.setLineDash([]);
  }
  private numbers({positions}: Figure): void {
    const {context, colors} = this;
    context.font = "600 13px system-ui, sans-serif";
    context.textAlign = "center";
    context.textBaseline = "middle";
    for (const {number, origin} of positions) {
      const [x, y] = this.at(origin);
      this.disc([x, y], 9.5, colors.ink3, 1.4);
      context.fillStyle = colors.ink;
      context.fillText(String(number), x, y + 0.5);
    }
  }
  private guided(figure: Figure): void {
    const {guided} = figure,
      web = web_of(figure);
    if (web) {
      this.trace(web, true);
      this.fill(this.colors.accent, 0.09);
      this.stroke(this.colors.body, 1.2);
    }
    if (!guided) return;
    this.trace(placed_outline(guided), true);
    this.fill(this.colors.accent, 0.13);
    this.stroke(this.colors.accent, 2);
  }
  private links(figure: Figure): void {
    const bar_width = is_slender(figure) ? 6 : 7;
    for (const body of figure.bodies) {
      this.trace(body.along ?? body.corners, is_plate(body));
      if (is_plate(body)) this.fill(this.color(body.role), 0.2);
      this.stroke(this.color(body.role), is_plate(body) ? 4 : bar_width);
    }
  }
  private joint({kind, role, at}: Joint, slender: boolean): void {
    const place = this.at(at);
    if (kind === "ground_pivot") {
      this.bracket(place);
      this.disc(place, 5.5, this.color(role), 2.4);
    } else if (slender) this.disc(place, 6, this.color(role), 2.2);
    else this.disc(place, 6.5, this.color(role), 2.4);
  }
  private bracket([x, y]: Point): void {
    const {context} = this;
    context.beginPath();
    context.moveTo(x, y);
    context.lineTo(x - 9, y + 15);
    context.lineTo(x + 9, y + 15);
    context.closePath();
    for (let i = -2; i < 2; ++i) {
      context.moveTo(x + 6 * i + 5, y + 15);
      context.lineTo(x + 6 * i + 1, y + 20);
    }
    this.stroke(this.colors.ink, 1.5);
  }
  private disc([x, y]: Point, radius: number, color: string, width: number): void {
    this.context.beginPath();
    this.context.arc(x, y, radius, 0, 2 * Math.PI);
    this.fill(this.colors.paper, 1);
    this.stroke(color, width);
  }
}
