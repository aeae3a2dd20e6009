import {describe, expect, it} from "vitest";
import type {Axis} from "../engine/protocol";
import {block_at, place_of, places_of, tau_at} from "./axis";

/** Two branches: the first in two blocks, one of them running backwards through the branch's end; the second whole. */
const axis: Axis = {
  order: 3,
  branches: [{name: "odd", from: 0, to: 1}, {name: "oval", from: 1, to: 2}],
  blocks: [
    {branch: 0, from: 0, to: 0.25, knots: [[0, 0.75], [0.25, 0.25]]},
    {branch: 0, from: 0.25, to: 0.5, knots: [[0.25, 0.75], [0.4, 1], [0.5, 1.25]]},
    {branch: 1, from: 0.5, to: 1, knots: [[0.5, 1.6], [1, 2.6]]},
  ],
};

describe("places on the axis", () => {
  it("are in one block each", () => {
    expect(block_at(axis, 0)).toBe(axis.blocks[0]);
    expect(block_at(axis, 0.25)).toBe(axis.blocks[1]);
    expect(block_at(axis, 1)).toBe(axis.blocks[2]);
  });
  it("have a τ on their branch", () => {
    expect(tau_at(axis, 0)).toBe(0.75);
    expect(tau_at(axis, 0.125)).toBeCloseTo(0.5, 14);
    expect(tau_at(axis, 0.4)).toBe(0); // 1 is 0 again
    expect(tau_at(axis, 0.45)).toBeCloseTo(0.125, 14);
    expect(tau_at(axis, 0.6)).toBeCloseTo(1.8, 14);
    expect(tau_at(axis, 0.9)).toBeCloseTo(1.4, 14);
  });
  it("outside are held to the ends", () => {
    expect(tau_at(axis, -1)).toBe(tau_at(axis, 0));
    expect(tau_at(axis, 2)).toBe(tau_at(axis, 1));
  });
  it("and τ are one to one", () => {
    for (let i = 0; i < 1000; ++i) {
      const place = (i + 0.5) / 1000;
      expect(place_of(axis, tau_at(axis, place))).toBeCloseTo(place, 12);
    }
  });
  it("are none for what no block shows", () => {
    expect(place_of(axis, -0.1)).toBeNull();
    expect(place_of(axis, 2.1)).toBeNull();
    expect(place_of({...axis, blocks: axis.blocks.slice(2)}, 0.5)).toBeNull();
  });
  it("are a pair where both are shown", () => {
    expect(places_of(axis, [0.75, 1.8])).toEqual([place_of(axis, 0.75), place_of(axis, 1.8)]);
    expect(places_of(axis, [0.75, 9])).toBeNull();
  });
});
