import {describe, expect, it} from "vitest";
import type {MapAnswer} from "../contract/messages";
import {axis_top, even_ticks, ribbon_bars, ribbon_lines} from "./ribbon";
import {make_scale} from "./scale";
import {on_its_side} from "./painter";

const map = {
  rows: 8,
  columns: 1,
  window: {input: [0, 1], output: [0, 1]},
  input_tau: new Float64Array(8),
  output_tau: new Float64Array(1),
  value: new Float32Array([1, 2, 0, 3, 4, 5, 6, 7]),
  fails: new Uint32Array([0, 0, 0, 0, 4, 4, 4, 4]),
  type: new Uint8Array(8),
} as unknown as MapAnswer;

describe("ribbon", () => {
  it("has a line for each stretch, and no gap where one begins to fail", () => {
    const lines = ribbon_lines(
      map,
      make_scale(
        [
          {from: 0, to: 0.75},
          {from: 0.75, to: 1},
        ],
        [0, 1],
        804,
      ),
    );
    expect(lines.map(({meets, points}) => [meets, points.map((p) => p.value)])).toEqual([
      [true, [1, 2]],
      [false, [3, 4, 5]],
      [false, [6, 7]],
    ]);
    expect(lines[0]!.points[0]!.at).toBeCloseTo(50);
  });
  it("has a bar for each of a few linkages with a value", () => {
    const thirds = [0, 1, 2].map((i) => ({from: i / 3, to: (i + 1) / 3})),
      few = {...map, rows: 1, columns: 3, value: map.value.subarray(1, 4), fails: map.fails.subarray(3, 6)};
    expect(ribbon_bars(few, make_scale(thirds, [0, 1], 304))).toMatchObject([
      {value: 2, meets: true},
      {value: 3, meets: false},
    ]);
  });
  it("shows what is usual of a property without bound", () => {
    expect(axis_top("min_transmission_angle_deg", [10], 30)).toBe(90);
    expect(axis_top("link_ratio", [...Array<number>(90).fill(2), ...Array<number>(10).fill(1000)], null)).toBeCloseTo(
      2.3,
    );
    expect(even_ticks(90, 200)).toEqual([0, 30, 60, 90]);
    expect(even_ticks(0.23, 120)).toEqual([0, 0.1, 0.2]);
  });
  it("lies on its side", () => {
    expect(on_its_side(map)).toMatchObject({rows: 1, columns: 8});
  });
});
