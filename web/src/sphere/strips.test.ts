// Lines as strips: what a corner knows of its stretch, room that is kept, and how far along a dash begins.
import type {BufferGeometry} from "three";
import {describe, expect, it} from "vitest";
import {has_room, new_strip, put_stretches} from "./strips";
import type {Vec3} from "./vectors";

const ends: Vec3[] = [
  [0, 0, 1],
  [0, 3, 1],
  [0, 3, 1],
  [4, 3, 1],
];
const corner = (strip: BufferGeometry, name: string, k: number) =>
  Array.from({length: strip.getAttribute(name).itemSize}, (_, i) => strip.getAttribute(name).getComponent(k, i));

describe("a strip", () => {
  it("has two corners at each end of a stretch, on either side of it, each knowing the other end", () => {
    const strip = new_strip(2, false);
    put_stretches(strip, ends);
    expect(corner(strip, "position", 0)).toEqual([0, 0, 1]);
    expect(corner(strip, "position", 6)).toEqual([4, 3, 1]);
    expect(corner(strip, "other", 0).slice(0, 3)).toEqual([0, 3, 1]);
    expect(corner(strip, "other", 6).slice(0, 3)).toEqual([0, 3, 1]);
    const sides = [0, 1, 2, 3].map((k) => corner(strip, "other", k)[3]!);
    expect(sides.map(Math.sign)).toEqual([-1, 1, -1, 1]);
    expect(sides.map(Math.abs)).toEqual([1, 1, 2, 2]);
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
    expect([0, 2, 4, 6].map((k) => corner(strip, "along", k)[0])).toEqual([0, 3, 3, 7]);
  });
});
