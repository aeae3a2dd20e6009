/** Undo without limit over immutable values; edits with the same `merge` label within a second are one step. */
export class UndoHistory<T> {
  private label: string | null = null;
  private at = 0;
  private dropped: T[] = []; // what the last step has made impossible to redo

  constructor(
    private value: T,
    private readonly now: () => number = () => performance.now(),
    private past: T[] = [],
    private future: T[] = [], // the next one last
  ) {}

  get steps(): {past: readonly T[]; present: T; future: readonly T[]} {
    return {past: this.past, present: this.value, future: this.future};
  }

  get present(): T {
    return this.value;
  }
  get can_undo(): boolean {
    return this.past.length > 0;
  }
  get can_redo(): boolean {
    return this.future.length > 0;
  }

  /** A new step. */
  commit(value: T, merge: string | null = null): void {
    const time = this.now();
    if (!(merge !== null && merge === this.label && time - this.at < 1000)) {
      this.past.push(this.value);
      this.dropped = this.future;
    }
    this.label = merge;
    this.at = time;
    this.value = value;
    this.future = [];
  }
  /** Changes the present without a step (what the engine adds to it). */
  amend(value: T): void {
    this.value = value;
  }
  /** The present was no good and `value` stands instead; a step that then changes nothing is left out, as if it had not been. */
  retract(value: T, same: (a: T, b: T) => boolean): void {
    this.value = value;
    this.label = null;
    const before = this.past.at(-1);
    if (before === undefined || !same(before, value)) return;
    this.past.pop();
    this.future = this.dropped;
    this.dropped = [];
  }
  undo(): T {
    const last = this.past.pop();
    if (last !== undefined) {
      this.future.push(this.value);
      this.value = last;
    }
    this.dropped = [];
    this.label = null;
    return this.value;
  }
  redo(): T {
    const next = this.future.pop();
    if (next !== undefined) {
      this.past.push(this.value);
      this.value = next;
    }
    this.dropped = [];
    this.label = null;
    return this.value;
  }
}
