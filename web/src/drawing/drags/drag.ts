import type {Point} from "../../contract/messages";
import type {Keys} from "../snapping";
import type {Plane} from "../space";

/** What follows a pressed pointer. `move` comes after the pointer has moved by a few pixels; a press without a move
 *  ends in `cancel` and is a click. */
export interface Drag {
  cursor: string;
  move(at: Point, keys: Keys): void;
  end(): void;
  cancel(): void;
}

/** The way of the pointer in user units, a tenth of it while Ctrl is down. */
export class Way {
  private last: Point;
  x = 0;
  y = 0;
  constructor(
    private readonly surface: {readonly space: Plane},
    from: Point,
  ) {
    this.last = from;
  }
  to(at: Point, keys: Keys): this {
    const {space} = this.surface,
      a = space.unproject(this.last),
      b = space.unproject(at),
      share = keys.fine ? 0.1 : 1;
    this.x += (b[0] - a[0]) * share;
    this.y += (b[1] - a[1]) * share;
    this.last = at;
    return this;
  }
  /** Where a point is that goes this way. */
  from([x, y]: Point): Point {
    return [x + this.x, y + this.y];
  }
}
