import {describe, expect, it} from "vitest";
import type {Mistake} from "../contract/messages";
import {Editing} from "./editing.svelte";
import {with_view, type Pin, type Problem} from "./problem";
import {new_problem} from "../kinds/motion/kind";
import {poses_of} from "./task";
import {with_pose} from "../kinds/kind_dispatch";

class Bench extends Editing {
  shown: Problem[] = [];
  refresh(): void {
    this.shown.push(this.problem);
  }
}
const problem = new_problem(),
  mistakes = [{code: "repeated_pose"}] as unknown as Mistake[];
/** With a problem that the engine has read. */
function bench(): Bench {
  const made = new Bench(problem, () => 0);
  made.accept(made.document);
  return made;
}
const x_to = (x: number) => (before: Problem) => with_pose(before, 1, {x});
const x = (b: Bench) => poses_of(b.problem.task)[1]!.x;

describe("editing", () => {
  it("shows every change of a drag, tells of its end only, and makes one step", () => {
    const b = bench();
    let told = 0;
    b.on_commit(() => ++told);
    b.begin_gesture();
    for (const value of [1, 2, 3]) b.drag(x_to(value));
    expect(b.shown.map((p) => poses_of(p.task)[1]!.x)).toEqual([1, 2, 3]);
    expect([told, b.can_undo]).toEqual([0, false]);
    b.end_gesture();
    expect([told, b.can_undo, b.just_changed]).toEqual([1, true, true]);
    b.end_gesture(); // the pointer's end may be told twice
    expect([told, b.just_changed]).toEqual([1, true]);
    b.undo();
    expect([b.problem, b.can_undo, b.can_redo]).toEqual([problem, false, true]);
  });

  it("takes a drag back, whether it is cancelled or undone", () => {
    for (const back of ["cancel_gesture", "undo"] as const) {
      const b = bench();
      b.begin_gesture();
      b.drag(x_to(1));
      b[back]();
      expect([b.problem, b.gesture, b.can_undo]).toEqual([problem, false, false]);
      b.drag(x_to(2)); // the pointer is still down
      b.end_gesture();
      expect([b.problem, b.can_undo]).toEqual([problem, false]);
    }
  });

  it("ends a drag at the last good document where the engine has refused the last", () => {
    const b = bench();
    b.begin_gesture();
    b.drag(x_to(1));
    b.accept(b.document);
    b.drag(x_to(2));
    expect(b.refuse(b.problem, mistakes)).toBe(false);
    expect([x(b), b.refusal]).toEqual([2, mistakes]);
    b.end_gesture();
    expect([x(b), b.refusal, b.can_undo]).toEqual([1, null, true]);
  });

  it("takes a refused step out of the history, and keeps what is no matter of the engine's", () => {
    const b = bench();
    b.edit((before) => with_view(before, {traced: [[1, 2]]}));
    b.edit(x_to(2));
    expect(b.refuse(problem, mistakes)).toBe(false); // not in force any more
    expect(b.refuse(b.problem, mistakes)).toBe(true);
    expect([x(b), b.problem.view]).toEqual([poses_of(problem.task)[1]!.x, {traced: [[1, 2]]}]);
    b.undo();
    expect([b.problem.view, b.can_undo]).toEqual([undefined, false]);
  });

  it("keeps a pin that was set while the engine read the same task once more", () => {
    const b = bench(),
      asked = b.document,
      pin = {name: "A"} as Pin;
    b.edit_document((document) => ({...document, pins: [pin]}));
    b.edit(x_to(2));
    b.accept(asked); // of the finer map
    b.refuse(b.problem, mistakes);
    expect([x(b), b.pins]).toEqual([poses_of(problem.task)[1]!.x, [pin]]);
  });

  it("knows whether the engine has read what it needs of the problem in force", () => {
    const b = bench();
    b.edit((before) => with_view(before, {traced: [[1, 2]]}));
    expect(b.is_current).toBe(true);
    b.edit(x_to(2));
    expect(b.is_current).toBe(false);
  });

  it("makes no step of what the engine adds, in the history or out of it", () => {
    const b = bench();
    b.amend({order: 3});
    b.edit(x_to(2));
    b.undo();
    expect([b.document.order, b.can_undo]).toEqual([3, false]);
    b.begin_gesture();
    b.amend({order: 4});
    b.cancel_gesture();
    expect(b.document.order).toBe(3);
  });
});
