import {describe, expect, it} from "vitest";
import {block_of, is_block, most_pasted_rows} from "./paste";
import {block_fault} from "./paste_fault";

const rows = (text: string, from = 0) => {
  const block = block_of(text, from, "mm");
  return "rows" in block ? block.rows : "fault" in block ? block.fault : block;
};

describe("paste", () => {
  it("reads every usual separator", () => {
    const wanted = [
      [0, 0, 0],
      [-125.5, 75, -25],
    ];
    expect(rows("0\t0\t0\n-125.5\t75\t-25\n")).toEqual(wanted);
    expect(rows("0\t0\t0\r\n-125,5\t75\t-25\r\n")).toEqual(wanted);
    expect(rows("0;0;0\n-125,5;75;-25")).toEqual(wanted);
    expect(rows("0; 0; 0\n-125.5; 75; -25")).toEqual(wanted);
    expect(rows("0, 0, 0\n-125.5, 75, -25")).toEqual(wanted);
    expect(rows("0,0,0\n-125.5,75,-25")).toEqual(wanted);
    expect(rows("  0 0   0\n −125,5 75 -25")).toEqual(wanted);
    expect(rows("0, 0, 0\n-125,5, 75, -25")).toEqual(wanted);
  });
  it("leaves out a heading and a counting column", () => {
    expect(rows("x\ty\tθ\n1\t2\t3")).toEqual([[1, 2, 3]]);
    expect(rows("#;x;y;θ\n1;0;0;0\n2;10;20;30")).toEqual([
      [0, 0, 0],
      [10, 20, 30],
    ]);
    expect(rows("P1\t0\t0\t0\nP2\t10\t20\t30")).toEqual([
      [0, 0, 0],
      [10, 20, 30],
    ]);
  });
  it("takes units, arithmetic and fewer columns", () => {
    expect(rows("10 mm\t20 mm\t0.5rad")).toEqual([[10, 20, expect.closeTo(28.64788975654116, 10)]]);
    expect(rows("=410/2\t1\t90°")).toEqual([[205, 1, 90]]);
    expect(rows("5\n6", 1)).toEqual([[5], [6]]);
    expect(rows("1\t2\t3\t4\n5\t6\t7\t9")).toEqual([
      [1, 2, 3],
      [5, 6, 7],
    ]);
    expect(rows("5\t30\n6\t40", 1)).toEqual([
      [5, 30],
      [6, 40],
    ]);
  });
  it("takes four columns that keep their distance for two points of the body", () => {
    expect(block_of("x1 y1 x2 y2\n0 0 120 0\n10 20 10 140\n-5 3 -101 75")).toEqual({
      rows: [
        [0, 0, 0],
        [10, 20, 90],
        [-5, 3, expect.closeTo(143.13010235415598, 10)],
      ],
      from_points: true,
    });
    expect(rows("0 0 120 0\n10 20 10 160")).toEqual([
      [0, 0, 120],
      [10, 20, 10],
    ]);
  });
  it("names the cell that is no number", () => {
    expect(rows("0\t0\t0\n1\tabc\t2")).toEqual({row: 2, column: 2, text: "abc"});
    expect(rows("x\ty\tθ\n1\t\t2")).toEqual({row: 2, column: 2, text: ""});
    expect(rows("1e99\t0\t0")).toEqual({row: 1, column: 1, text: "1e99"});
  });
  it("takes no more than so many rows, and says so instead of keeping some", () => {
    const block = (n: number) => block_of(Array.from({length: n}, (_, i) => `${i}\t${2 * i}\t3`).join("\n"));
    expect(block(most_pasted_rows)).toMatchObject({rows: {length: most_pasted_rows}});
    expect(block(5000)).toEqual({too_many: 5000});
    expect(block_fault(block(5000))).toContain("5\u202f000 rows");
    expect(block_fault(block(3))).toBeNull();
  });
  it("knows a block from a number", () => {
    for (const text of ["410", "1,5", "1 234,5", "=410 / 2", "95 deg", "", "1.5\n"])
      expect(is_block(text), text).toBe(false);
    for (const text of ["1\t2", "1\n2", "1;2", "1 2 3", "1, 2, 3", "1.5,2.5,3", "100 200 300", "100 -5", "1\tabc"])
      expect(is_block(text), text).toBe(true);
  });
});
