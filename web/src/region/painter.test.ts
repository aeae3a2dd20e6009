import {describe, expect, it} from "vitest";
import {whole, type MapAnswer} from "../contract/messages";
import {histogram} from "./histogram";
import {diagonal, hash_of, paint_types, paint_values, point_of} from "./painter";
import {mixed, pale, pixel, ramp, rgb_of, type Look, type Palette} from "./palette";
import {make_scale} from "./scale";

const palette: Palette = {
  types: Array.from({length: 10}, (_, i) => [i * 20, 10, 200] as const),
  paper: [255, 255, 255],
  defect: [220, 220, 220],
  hatch: [190, 190, 190],
  ink: [0, 0, 0],
};
const look: Look = {palette, only_meeting: false, type_hover: null};
// Row 0: crank-rocker that meets all, the same failing; row 1: with a defect, degenerate.
const map = {
  samples: 2,
  rows: 2,
  columns: 2,
  window: whole,
  type: Uint8Array.of(0, 0, 2, 9),
  defects: Uint8Array.of(0, 0, 2, 0),
  fails: Uint32Array.of(0, 4, 2, 127),
  value: Float32Array.of(90, 45, 0, 0),
} as MapAnswer;

function painted(change: Partial<Look> = {}): number[] {
  const out = new Uint32Array(4);
  paint_types(map, {...look, ...change}, out);
  return [...out];
}

describe("painter", () => {
  const full = pixel(palette.types[0]!),
    washed = pixel(mixed(palette.types[0]!, palette.paper, 0.3)),
    paper = pixel(palette.paper);
  it("paints types with row 0 at the bottom, defects clear", () => {
    expect(painted()).toEqual([0, paper, full, washed]);
  });
  it("shows only what meets everything", () => {
    expect(painted({only_meeting: true})).toEqual([paper, paper, full, paper]);
  });
  it("fades all but the hovered type", () => {
    expect(painted({type_hover: 0})[2]).toBe(full);
    expect(painted({type_hover: 3})[2]).toBe(pixel(mixed(palette.types[0]!, palette.paper, 0.15)));
  });
  it("paints values along the ramp, either way round", () => {
    const out = new Uint32Array(4);
    paint_values(map, look, {from: 0, to: 90}, out);
    expect(out[2]).toBe(pixel(ramp(1)));
    expect(out[0]).toBe(0);
    paint_values(map, look, {from: 90, to: 0}, out);
    expect(out[2]).toBe(pixel(ramp(0)));
  });
  it("lays points and the diagonal over the gaps", () => {
    const scale = make_scale(
      [
        {from: 0, to: 0.5},
        {from: 0.5, to: 1},
      ],
      [0, 1],
      404,
    );
    const frame = {up: scale, across: scale};
    expect(point_of(frame, [0, 0])).toEqual([0, 404]);
    expect(point_of(frame, [0.75, 0.25])).toEqual([100, 100]);
    expect(diagonal(frame)).toEqual([
      [0, 404, 200, 204],
      [204, 200, 404, 0],
    ]);
  });
  it("tells pictures apart", () => {
    expect(hash_of(Uint32Array.of(1, 2))).not.toBe(hash_of(Uint32Array.of(2, 1)));
    expect(hash_of(Uint32Array.of(1, 2))).toBe(hash_of(Uint32Array.of(1, 2)));
  });
  it("paints equal ratios in equal steps, and what is not defined as bad as can be", () => {
    const out = new Uint32Array(4),
      range = {from: 100, to: 1, logarithmic: true},
      of = (value: number) => {
        paint_values({...map, value: Float32Array.of(value, 0, 0, 0)}, look, range, out);
        return out[2];
      };
    expect(of(10)).toBe(pixel(ramp(127 / 255)));
    expect(of(0)).toBe(pixel(ramp(0)));
    expect(of(0.5)).toBe(pixel(ramp(1)));
  });
  it("paints pale what stands for another cell", () => {
    const out = new Uint32Array(4);
    paint_values(map, look, {from: 0, to: 90}, out, Uint8Array.of(0, 1, 1, 1));
    expect(out[2]).toBe(pixel(pale(ramp(1))));
    paint_values(map, look, {from: 0, to: 90}, out, Uint8Array.of(1, 1, 1, 1));
    expect(out[2]).toBe(pixel(ramp(1)));
  });
  it("counts what is free of defects", () => {
    expect(histogram(map, {from: 0, to: 100}, 2)).toEqual([1, 1]);
    expect(histogram(map, {from: 0, to: 100}, 2, true)).toEqual([0, 1]);
  });
  it("reads colours", () => {
    expect(rgb_of(" #1f5fbf")).toEqual([31, 95, 191]);
    expect(rgb_of("#fff")).toEqual([255, 255, 255]);
  });
});
