// Where linkages live, as a drawing shows it: the plane here; a kind whose linkages live elsewhere (a sphere) brings its
// own space with its own stage (kinds/view.ts).
import type {Point} from "../contract/messages";
import {px} from "../figure/paths";
import {align_px, snapped_point, type Guide, type Keys} from "./snapping";
import {grid_step, line_step, shows, to_screen, to_user, type Viewport} from "./viewport";

/** `P`: a point of the space. On the screen points are pixels, y down. */
export interface Space<P> {
  /** Of the window, pixels. */
  readonly width: number;
  readonly height: number;
  /** Null: out of sight. */
  project(point: P): Point | null;
  /** Null: there is nothing under this place of the screen. */
  unproject(at: Point): P | null;
  shows(point: P, border?: number): boolean;
  /** To which drags and arrow keys go. */
  readonly step: number;
  /** The user wants drags to snap. */
  readonly snaps: boolean;
  /** Where a point comes to rest that was taken at `from` and that the pointer has at `raw`, and what it then lines up
   *  with of `others`. */
  snapped(from: P, raw: P, keys: Keys, others?: readonly P[]): {point: P; guides: readonly Guide[]};
  /** SVG path data. */
  grid_path(): string;
  guide_path(guide: Guide): string;
}

export class Plane implements Space<Point> {
  constructor(
    private readonly view: Viewport,
    readonly snaps: boolean,
  ) {}

  get width(): number {
    return this.view.width;
  }
  get height(): number {
    return this.view.height;
  }
  /** Pixels to the user's unit. */
  get scale(): number {
    return this.view.scale;
  }
  readonly project = (point: Point): Point => to_screen(this.view, point);
  readonly unproject = (at: Point): Point => to_user(this.view, at);

  shows(point: Point, border = 0): boolean {
    return shows(this.view, point, border);
  }
  get step(): number {
    return grid_step(this.view);
  }
  snapped(from: Point, raw: Point, keys: Keys, others: readonly Point[] = []): {point: Point; guides: Guide[]} {
    const grid = {
      step: this.step,
      xs: others.map(([x]) => x),
      ys: others.map(([, y]) => y),
      near: align_px / this.scale,
      on: this.snaps,
    };
    return snapped_point(from, raw, grid, keys, 1 / this.scale);
  }
  grid_path(): string {
    const step = line_step(this.view),
      [left, top] = this.unproject([0, 0]),
      [right, bottom] = this.unproject([this.width, this.height]);
    const lines = (axis: Guide["axis"], low: number, high: number) => {
      const first = Math.ceil(low / step);
      return Array.from({length: Math.max(Math.floor(high / step) - first + 1, 0)}, (_, i) =>
        this.guide_path({axis, value: (first + i) * step}),
      );
    };
    return [...lines("x", left, right), ...lines("y", bottom, top)].join("");
  }
  guide_path({axis, value}: Guide): string {
    const [x, y] = this.project([value, value]);
    return axis === "x" ? `M${px(x)} 0V${this.height}` : `M0 ${px(y)}H${this.width}`;
  }
}
