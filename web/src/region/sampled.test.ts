import {describe, expect, it} from "vitest";
import {sampled_cells} from "./sampled";

describe("cells whose yield is sampled", () => {
  const rows = 20,
    columns = 20,
    fails = new Uint32Array(rows * columns);
  const cells = (done: number, ignored = 0) =>
    [...sampled_cells({rows, columns, fails}, done, ignored).entries()].flatMap(([cell, is]) => (is ? [cell] : []));
  it("come coarse to fine", () => {
    expect(cells(0)).toEqual([]);
    expect(cells(4)).toEqual([0, 16, 320, 336]);
    expect(cells(6)).toEqual([0, 8, 16, 160, 320, 336]);
    expect(cells(400)).toHaveLength(400);
  });
  it("are those that meet all else", () => {
    fails.fill(4);
    fails[16] = 0;
    expect(cells(400)).toEqual([16]);
    expect(cells(3, 4)).toEqual([0, 16, 320]);
    fails.fill(0);
  });
});
