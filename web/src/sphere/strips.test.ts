// Lines as strips: their corners, how they are joined, room that is kept, and how far along a dash begins.
import type {BufferGeometry} from "three";
import {describe, expect, it} from "vitest";
import {has_room, new_strip, put_stretches} from "./strips";
import {minus, type Vec3} from "./vectors";

const corner: Vec3 = [0, 3, 1],
  ends: Vec3[] = [[0, 0, 1], corner, corner, [4, 3, 1]];
const values = (strip: BufferGeometry, name: string, k: number) =>
  Array.from({length: strip.getAttribute(name).itemSize}, (_, i) => strip.getAttribute(name).getComponent(k, i));

describe("a strip", () => {
  it("has two corners at each end of a stretch, one on either side", () => {
    const strip = new_strip(2, false);
    put_stretches(strip, ends);
    for (const k of [0, 1]) expect(values(strip, "position", k)).toEqual([0, 0, 1]);
    for (const k of [6, 7]) expect(values(strip, "position", k)).toEqual([4, 3, 1]);
    expect([0, 1, 2, 3].map((k) => values(strip, "side", k)[0])).toEqual([-1, 1, -1, 1]);
  });
  it("goes the same way at the end of a stretch and at the beginning of the next, where they are joined", () => {
    const strip = new_strip(2, false);
    const way = (k: number) => minus(values(strip, "before", k) as never, values(strip, "behind", k) as never);
    put_stretches(strip, ends);
    expect([0, 2, 4, 6].map(way)).toEqual([
      [0, 3, 0],
      [4, 3, 0],
      [4, 3, 0],
      [4, 0, 0],
    ]);
    put_stretches(strip, [ends[0]!, ends[1]!, [0, 0, 2], [0, 0, 3]]);
    expect([2, 4].map(way)).toEqual([
      [0, 3, 0],
      [0, 0, 1],
    ]);
  });
  it("draws as many stretches as were put, of the room that it has", () => {
    const strip = new_strip(5, false);
    expect(has_room(strip, 8)).toBe(true);
    expect(has_room(strip, 9)).toBe(false);
    put_stretches(strip, ends);
    expect(strip.drawRange.count).toBe(12);
    put_stretches(strip, []);
    expect(strip.drawRange.count).toBe(0);
  });
  it("counts how far along the line a corner lies, where it is dashed", () => {
    const strip = new_strip(2, true);
    put_stretches(strip, ends);
    expect([0, 2, 4, 6].map((k) => values(strip, "along", k)[0])).toEqual([0, 3, 3, 7]);
  });
});
