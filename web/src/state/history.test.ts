import {describe, expect, it} from "vitest";
import {UndoHistory} from "./history";

function history(): {history: UndoHistory<number>; wait(ms: number): void} {
  let time = 0;
  return {history: new UndoHistory(0, () => time), wait: (ms) => void (time += ms)};
}

describe("history", () => {
  it("undoes and redoes without limit", () => {
    const {history: h} = history();
    for (let i = 1; i <= 5000; ++i) h.commit(i);
    for (let i = 4999; i >= 0; --i) expect(h.undo()).toBe(i);
    expect(h.can_undo).toBe(false);
    expect(h.undo()).toBe(0);
    for (let i = 1; i <= 5000; ++i) expect(h.redo()).toBe(i);
    expect(h.can_redo).toBe(false);
    expect(h.redo()).toBe(5000);
  });
  it("forgets what was undone when something else is done", () => {
    const {history: h} = history();
    h.commit(1);
    h.undo();
    h.commit(2);
    expect(h.can_redo).toBe(false);
    expect(h.undo()).toBe(0);
  });
  it("takes steps of one kind within a second for one", () => {
    const {history: h, wait} = history();
    h.commit(1, "arrow");
    wait(900);
    h.commit(2, "arrow");
    wait(900);
    h.commit(3, "arrow");
    expect(h.undo()).toBe(0);
    expect(h.redo()).toBe(3);
  });
  it("keeps steps apart that are not of one kind, not in time or not in a row", () => {
    const {history: h, wait} = history();
    h.commit(1, "arrow");
    h.commit(2, "slider");
    h.commit(3);
    h.commit(4);
    h.commit(5, "arrow");
    wait(1001);
    h.commit(6, "arrow");
    h.undo();
    h.redo();
    h.commit(7, "arrow");
    expect([6, 5, 4, 3, 2, 1, 0].map(() => h.undo())).toEqual([6, 5, 4, 3, 2, 1, 0]);
  });
  it("amends the present without a step", () => {
    const {history: h} = history();
    h.commit(1);
    h.amend(10);
    expect(h.undo()).toBe(0);
    expect(h.redo()).toBe(10);
  });
  it("retracts a present that is no good", () => {
    const {history: h} = history();
    h.commit(1);
    h.commit(2);
    h.retract(1, (a, b) => a === b);
    expect(h.present).toBe(1);
    expect(h.undo()).toBe(0); // no step was left that changes nothing
    h.commit(3);
    h.commit(4);
    h.retract(5, (a, b) => a === b);
    expect(h.undo()).toBe(3);
  });
  it("has what was undone again when what was done instead was no good", () => {
    const {history: h} = history();
    h.commit(1);
    h.commit(2);
    h.undo();
    h.commit(9);
    h.retract(1, (a, b) => a === b);
    expect([h.redo(), h.can_redo]).toEqual([2, false]);
    h.undo();
    h.commit(9);
    h.commit(10);
    h.retract(9, (a, b) => a === b); // 9 stands, and what it made impossible stays so
    expect(h.can_redo).toBe(false);
  });
});
