import {describe, expect, it} from "vitest";
import type {Axis, MapAnswer, TaskAnswer} from "../contract/messages";
import {board_cells, is_board} from "./board";

const points = (count: number): Axis => ({
  quantity: "burmester_point",
  ticks: null,
  order: 0,
  branches: Array.from({length: count}, (_, i) => ({name: "point", from: i, to: i + 1})),
  blocks: [],
});
const nothing: Axis = {
  quantity: "nothing",
  ticks: null,
  order: 0,
  branches: [{name: "point", from: 0, to: 1}],
  blocks: [],
};
const curve: Axis = {...points(1), quantity: "curve_coordinate"};
const at = (...places: number[]) => Float64Array.from(places.flatMap((x) => [2, 2 * x, -2 * x]));
const curves = {tau: Float64Array.of(0.5, 1.5), center: at(1, 2), circle: at(3, 4), branch: Uint8Array.of(0, 1)};

describe("a board", () => {
  it("is where both axes have a few places", () => {
    expect(is_board({input: points(2), output: points(2)})).toBe(true);
    expect(is_board({input: points(3), output: nothing})).toBe(true);
    expect(is_board({input: curve, output: nothing})).toBe(false);
    expect(is_board({input: nothing, output: {...points(24), quantity: "layer"}})).toBe(false);
  });
  it("has the grounded links of its row and column in each cell, and none on the diagonal", () => {
    const task = {axes: {input: points(2), output: points(2)}, curves, output_curves: null} as unknown as TaskAnswer;
    const map = {
      rows: 2,
      columns: 2,
      input_tau: curves.tau,
      output_tau: curves.tau,
      type: Uint8Array.of(9, 0, 3, 9),
      defects: Uint8Array.of(0, 0, 6, 0),
      value: Float32Array.of(0, 40, 0, 0),
    } as MapAnswer;
    const cells = board_cells(task, map);
    expect(cells.map(({row, column, tau}) => [row, column, ...tau])).toEqual([
      [0, 1, 0.5, 1.5],
      [1, 0, 1.5, 0.5],
    ]);
    expect(cells[0]!.pivots).toEqual([
      [1, -1],
      [3, -3],
      [2, -2],
      [4, -4],
    ]);
    expect([cells[0]!.value, cells[0]!.defects.branch, cells[1]!.defects]).toEqual([
      40,
      false,
      {order: false, branch: true, circuit: true},
    ]);
  });
  it("takes both grounded links from one place where the other axis leaves no choice", () => {
    const task = {
      axes: {input: points(2), output: nothing},
      curves,
      output_curves: {...curves, center: at(7, 8), circle: at(5, 6)},
    } as unknown as TaskAnswer;
    const map = {
      rows: 2,
      columns: 1,
      input_tau: curves.tau,
      output_tau: Float64Array.of(0.5),
      type: Uint8Array.of(0, 0),
      defects: new Uint8Array(2),
      value: new Float32Array(2),
    } as MapAnswer;
    expect(board_cells(task, map).map(({pivots}) => pivots.map(([x]) => x))).toEqual([
      [1, 3, 7, 5],
      [2, 4, 8, 6],
    ]);
  });
});
