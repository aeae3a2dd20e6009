import {describe, expect, it} from "vitest";
import {whole, type Axis, type MapAnswer, type TaskAnswer} from "../contract/messages";
import {sheets_of} from "./sheets";

const axis = (...names: string[]): Axis => ({
  quantity: "side_direction",
  ticks: null,
  order: 0,
  branches: names.map((name, i) => ({name, from: i, to: i + 1})),
  blocks: names.map((_, i) => ({
    branch: i,
    from: i / names.length,
    to: (i + 1) / names.length,
    knots: [
      [i / names.length, i],
      [(i + 1) / names.length, i + 1],
    ],
  })),
});
const task = (input: Axis, output: Axis) => ({axes: {input, output}}) as TaskAnswer;
const map = {
  rows: 4,
  columns: 4,
  window: whole,
  type: Uint8Array.of(9, 9, 9, 9, 9, 9, 9, 2, 9, 9, 9, 9, 0, 9, 9, 9),
} as MapAnswer;

describe("sheets", () => {
  it("are the pairs of both axes' sheets, row by row, those without a linkage told", () => {
    const found = sheets_of(task(axis("sheet_1", "sheet_2"), axis("sheet_1", "sheet_2")), map);
    expect(found.map(({name, empty}) => [name, empty])).toEqual([
      ["I", true],
      ["II", false],
      ["III", false],
      ["IV", true],
    ]);
    expect(found[1]!.window).toEqual({input: [0, 0.5], output: [0.5, 1]});
  });
  it("are none of a curve, and up to eight where the angle is one of lines", () => {
    expect(sheets_of(task(axis("odd", "oval"), axis("odd", "oval")), map)).toEqual([]);
    expect(sheets_of(task(axis("sheet_1", "sheet_2"), axis("range")), map)).toEqual([]);
    expect(sheets_of(task(axis("AB", "AD", "BD"), axis("link_ray")), map).map(({name}) => name)).toEqual([
      "I",
      "II",
      "III",
    ]);
    const eight = sheets_of(
      task(axis("sheet_1", "sheet_2"), axis("sheet_1", "sheet_2", "sheet_1_opposite", "sheet_2_opposite")),
      null,
    );
    expect(eight.map(({name}) => name).join()).toBe("I,II,III,IV,V,VI,VII,VIII");
    expect(eight.some(({empty}) => empty)).toBe(false);
  });
});
