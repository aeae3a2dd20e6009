// The fingers on an element, and what two of them do to what lies under them.
type Point = readonly [x: number, y: number];

export interface Pinch {
  /** Their middle then and now. */
  from: Point;
  to: Point;
  /** How many times as far apart they are now. */
  spread: number;
}
interface Pair {
  middle: Point;
  apart: number;
}
const least_apart = 10; // px: closer, a finger's trembling would be a zoom

export class Fingers {
  private readonly places = new Map<number, Point>();
  private before: Pair | null = null;

  get count(): number {
    return this.places.size;
  }
  has(id: number): boolean {
    return this.places.has(id);
  }
  down(id: number, at: Point): void {
    this.places.set(id, at);
    this.before = this.pair();
  }
  move(id: number, at: Point): void {
    if (this.has(id)) this.places.set(id, at);
  }
  /** False where there was none. */
  up(id: number): boolean {
    const was_there = this.places.delete(id);
    this.before = this.pair();
    return was_there;
  }
  clear(): void {
    this.places.clear();
    this.before = null;
  }
  /** What two have done since they were asked last, or came; null: they are not two. */
  pinched(): Pinch | null {
    const {before} = this,
      now = this.pair();
    this.before = now;
    return before && now && {from: before.middle, to: now.middle, spread: now.apart / before.apart};
  }
  private pair(): Pair | null {
    const [a, b, third] = this.places.values();
    if (!a || !b || third) return null;
    return {
      middle: [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2],
      apart: Math.max(Math.hypot(a[0] - b[0], a[1] - b[1]), least_apart),
    };
  }
}
