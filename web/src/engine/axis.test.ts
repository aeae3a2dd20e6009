import {describe, expect, it} from "vitest";
import {whole, type Axis, type AxisQuantity} from "../contract/messages";
import {straight_axis} from "../../tests/axes";
import {
  block_at,
  held_place,
  held_tau,
  held_window,
  in_layer_of,
  on_branches,
  on_line,
  place_of,
  places_of,
  plane_axes,
  settled,
  stepped_place,
  tau_at,
  tau_of_point,
  tau_of_places,
} from "./axis";

/** Two branches: the first in two blocks, one of them running backwards through the branch's end; the second whole. */
const axis: Axis = {
  quantity: "curve_coordinate",
  ticks: null,
  order: 3,
  branches: [
    {name: "odd", from: 0, to: 1},
    {name: "oval", from: 1, to: 2},
  ],
  blocks: [
    {
      branch: 0,
      from: 0,
      to: 0.25,
      knots: [
        [0, 0.75],
        [0.25, 0.25],
      ],
    },
    {
      branch: 0,
      from: 0.25,
      to: 0.5,
      knots: [
        [0.25, 0.75],
        [0.4, 1],
        [0.5, 1.25],
      ],
    },
    {
      branch: 1,
      from: 0.5,
      to: 1,
      knots: [
        [0.5, 1.6],
        [1, 2.6],
      ],
    },
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
      expect(place_of(axis, tau_at(axis, place)!)).toBeCloseTo(place, 12);
    }
  });
  it("have no τ where there are no grounded links", () => {
    const empty: Axis = {...axis, branches: [], blocks: []};
    expect([block_at(empty, 0.5), tau_at(empty, 0.5)]).toEqual([null, null]);
    expect([held_place(empty, 0.3), stepped_place({...empty, quantity: "burmester_point"}, 0.3, 1, 0.1)]).toEqual([
      0.3, 0.4,
    ]);
    expect(tau_of_places({input: empty, output: empty}, [0, 0])).toBeNull();
  });
  it("are none for what no block shows", () => {
    expect(place_of(axis, -0.1)).toBeNull();
    expect(place_of(axis, 2.1)).toBeNull();
    expect(place_of({...axis, blocks: axis.blocks.slice(2)}, 0.5)).toBeNull();
  });
  it("are a pair where both are shown", () => {
    const axes = {input: axis, output: axis};
    expect(places_of(axes, [0.75, 1.8])).toEqual([place_of(axis, 0.75), place_of(axis, 1.8)]);
    expect(places_of(axes, [0.75, 9])).toBeNull();
    expect(tau_of_places(axes, [0.125, 0.45])!.map((tau) => tau.toFixed(12))).toEqual([
      "0.500000000000",
      "0.125000000000",
    ]);
    expect(tau_of_places({input: axis, output: {...axis, blocks: []}}, [0, 0])).toBeNull();
  });
});

describe("an axis of a few dyads", () => {
  const points: Axis = {
    quantity: "burmester_point",
    ticks: null,
    order: 0,
    branches: [0, 1, 2].map((i) => ({name: "point", from: i, to: i + 1})),
    blocks: [0, 1, 2].map((i) => ({
      branch: i,
      from: i / 3,
      to: (i + 1) / 3,
      knots: [
        [i / 3, i],
        [(i + 1) / 3, i + 1],
      ],
    })),
  };
  const axes = {input: points, output: axis};
  it("has one τ and one place to each", () => {
    expect([0, 0.2, 0.34, 0.66, 1].map((place) => tau_at(points, place))).toEqual([0.5, 0.5, 1.5, 1.5, 2.5]);
    expect(held_place(points, 0.9)).toBeCloseTo(5 / 6, 14);
    expect(held_place(axis, 0.9)).toBe(0.9);
    expect(held_tau(axes, [2.01, 1.8])).toEqual([2.5, 1.8]);
    expect(places_of(axes, [2.01, 0.75])![0]).toBeCloseTo(5 / 6, 14);
  });
  it("is stepped along from one to the next, and not beyond the ends", () => {
    expect(tau_at(points, stepped_place(points, 0.1, 10, 1 / 400))).toBe(1.5);
    expect(tau_at(points, stepped_place(points, 0.9, 0.1, 1 / 400))).toBe(2.5);
    expect(stepped_place(axis, 0.5, -2, 0.01)).toBeCloseTo(0.48, 14);
  });
  it("is always shown whole", () => {
    expect(held_window(axes, {input: [0, 0.5], output: [0.25, 0.5]})).toEqual({input: [0, 1], output: [0.25, 0.5]});
    expect(held_window(axes, {input: [0.5, 0.6], output: [0, 1]})).toBe(whole);
  });
});

describe("several linkages at a place", () => {
  const reach: Axis = {...straight_axis, quantity: "arm_reach", layers: 96},
    axes = {input: reach, output: {...straight_axis, quantity: "arm_difference"}} as const;
  it("stand at one place of the map, by the fraction of the first coordinate", () => {
    expect(place_of(reach, 17.42)).toBeCloseTo(0.42, 9);
    expect(places_of(axes, [3.25, 0.5])).toEqual([0.25, 0.5]);
    expect(place_of(axes.output, 1.5)).toBeNull();
    expect(on_branches(reach, 0.42)).toBe(0.42);
  });
  it("stay themselves where their place is kept", () => {
    const picked = {tau: [17.42, 0.3], place: [0.42, 0.3]} as const;
    expect(settled(axes, picked)).toBe(picked);
    expect(settled(axes, {...picked, place: [0.5, 0.3]})!.tau).toEqual([17.5, 0.3]);
    expect(settled(axes, {...picked, place: null})!.place![0]).toBeCloseTo(0.42, 9);
    expect(in_layer_of(reach, 17.42, 0.6)).toBeCloseTo(17.6, 9);
    expect(in_layer_of(axis, 1.4, 0.6)).toBe(0.6);
  });
});

describe("a map over the plane", () => {
  /** Middle 40, and 100 on at a quarter of a turn. */
  const along = (quantity: AxisQuantity, middle: number): Axis => ({
    ...straight_axis,
    quantity,
    ticks: [0.25, 0.5, 0.75].map((tau) => [tau, middle + 100 * Math.tan(Math.PI * (tau - 0.5))]),
  });
  const y = {...along("center_y", -10), layers: 12},
    axes = {input: y, output: along("center_x", 40)};
  it("has a pair for each of its points, and the pair its point", () => {
    const plane = plane_axes(axes)!;
    expect(plane).toEqual({x: "output", y: "input", end: "center"});
    for (const point of [
      [40, -10],
      [-900, 12],
      [1e6, -1e5],
    ] as const) {
      const tau = tau_of_point(axes, plane, point);
      expect(tau.every((one) => one > 0 && one < 1)).toBe(true);
      expect(on_line(axes.output, tau[1]) / point[0]).toBeCloseTo(1, 9);
      expect(on_line(y, tau[0] + 7) / point[1]).toBeCloseTo(1, 9);
    }
    const [up, across] = tau_of_point(axes, plane, [140, -110]);
    expect([up.toFixed(12), across.toFixed(12)]).toEqual(["0.250000000000", "0.750000000000"]);
  });
  it("is none where an axis is of something else", () => {
    expect(plane_axes({...axes, output: along("circle_x", 0)})).toBeNull();
    expect(plane_axes({input: along("circle_x", 0), output: along("circle_y", 0)})).toEqual({
      x: "input",
      y: "output",
      end: "circle",
    });
  });
});

describe("a map of the nearest paths", () => {
  const numbered = (quantity: AxisQuantity, count: number): Axis => ({
    ...straight_axis,
    quantity,
    branches: Array.from({length: count}, (_, i) => ({name: quantity, from: i, to: i + 1})),
    blocks: Array.from({length: count}, (_, i) => ({
      branch: i,
      from: i / count,
      to: (i + 1) / count,
      knots: [
        [i / count, i],
        [(i + 1) / count, i + 1],
      ],
    })),
  });
  const paths = (count: number) => ({input: numbered("fitted_curve", count), output: numbered("realisation", 3)});

  it("keeps the number of what is picked, however many there are", () => {
    const picked = settled(paths(5), {tau: [1.5, 2.5], place: null})!;
    expect(picked.place!.map((place) => Number(place.toFixed(9)))).toEqual([0.3, 0.833333333]);
    const of_more = settled(paths(20), picked)!;
    expect(of_more.tau).toEqual([1.5, 2.5]);
    expect(of_more.place![0]).toBeCloseTo(1.5 / 20, 9);
    expect(settled(paths(1), picked)).toBeNull();
  });
  it("has a row to each, in whose middle it is held", () => {
    expect(held_tau(paths(5), [1.2, 0.9])).toEqual([1.5, 0.5]);
    expect(held_window(paths(5), {input: [0, 0.5], output: [0.2, 0.4]})).toBe(whole);
  });
});
