import {describe, expect, it} from "vitest";
import type {Axis} from "../contract/messages";
import {straight_block} from "../../tests/axes";
import {axis_bars, axis_numbers, has_layers} from "./axis_marks";
import {make_scale} from "./scale";
import {spherical_kind} from "../kinds/spherical/kind";

const ticks = [0, 1].flatMap((sheet) => Array.from({length: 12}, (_, i) => [sheet + i / 12, 30 * i] as const));
const directions: Axis = {
  quantity: "side_direction",
  order: 0,
  ticks,
  branches: [
    {name: "sheet_1", from: 0, to: 1},
    {name: "sheet_2", from: 1, to: 2},
  ],
  blocks: [
    {
      branch: 0,
      from: 0,
      to: 0.5,
      knots: [
        [0, 0],
        [0.5, 1],
      ],
    },
    {
      branch: 1,
      from: 0.5,
      to: 1,
      knots: [
        [0.5, 1],
        [0.75, 1.25],
        [0.76, 1.75],
        [1, 2],
      ],
    },
  ],
};

const as_it_is = <Key>(key: Key) => key;

describe("an axis with numbers", () => {
  it("has as many as there is room for, with their sign", () => {
    const wide = axis_numbers(directions, make_scale(directions.blocks, [0, 1], 404));
    expect(wide.slice(0, 5).map(({text}) => text)).toEqual(["0°", "90°", "180°", "270°", "0°"].slice(0, 5));
    const narrow = axis_numbers({...directions, quantity: "output_scale"}, make_scale(directions.blocks, [0, 1], 104));
    expect(narrow.map(({text}) => text)).toEqual(["×0", "×0"]);
  });
  it("has round numbers along lengths, and the engine's where these are no even ones", () => {
    const scale = make_scale([straight_block], [0, 1], 404);
    const texts = (value: (share: number) => number) =>
      axis_numbers(
        {
          ...directions,
          quantity: "crank_length",
          ticks: Array.from({length: 12}, (_, i) => [i / 12, value(i / 12)] as const),
          branches: [{name: "range", from: 0, to: 1}],
          blocks: [straight_block],
        },
        scale,
      ).map(({text}) => text);
    expect(texts((share) => 332.803 * share)).toEqual(["0", "50", "100", "150", "200", "250", "300"]);
    expect(texts((share) => -60 - 340 * share)).toEqual(["−100", "−150", "−200", "−250", "−300", "−350"]);
    expect(texts((share) => 10 ** share)[1]).toBe("1.47");
  });
  it("does not write over itself where the axis jumps", () => {
    const numbers = axis_numbers(directions, make_scale(directions.blocks, [0, 1], 804));
    numbers.slice(1).forEach(({at}, i) => expect(at - numbers[i]!.at).toBeGreaterThanOrEqual(34));
  });
  it("says what its blocks are", () => {
    const bars = axis_bars(directions, "output", make_scale(directions.blocks, [0, 1], 404), "mm", as_it_is);
    expect(bars.map(({text}) => text)).toEqual(["Direction β₂ ° · sheet I", "Direction β₂ ° · sheet II"]);
    const length = axis_bars(
      {...directions, quantity: "side_length"},
      "input",
      make_scale(directions.blocks, [0, 1], 404),
      "mm",
      as_it_is,
    );
    expect(length[0]!.text).toBe("Length R₁ mm · sheet I");
    const points = axis_bars(
      {...directions, quantity: "burmester_point", ticks: null},
      "input",
      make_scale(directions.blocks, [0, 1], 404),
      "mm",
      as_it_is,
    );
    expect(points.map(({text}) => text)).toEqual(["1", "2"]);
    const linkages = axis_bars(
      {...directions, quantity: "layer", ticks: null},
      "output",
      make_scale(directions.blocks, [0, 1], 404),
      "mm",
      as_it_is,
    );
    expect(linkages.map(({text}) => text)).toEqual(["1", "2"]);
    const parts = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10].map((i) => ({
        ...directions.blocks[0]!,
        branch: i,
        from: i / 11,
        to: (i + 1) / 11,
      })),
      many: Axis = {
        ...directions,
        quantity: "layer",
        ticks: null,
        branches: parts.map((_, i) => ({name: "linkage", from: i, to: i + 1})),
        blocks: parts,
      };
    const narrow = axis_bars(many, "output", make_scale(parts, [0, 1], 140), "mm", as_it_is);
    expect(narrow.map(({text}) => text).filter((text) => text)).toEqual(["2", "4", "6", "8", "10"]);
    expect(
      axis_bars(
        {...directions, quantity: "nothing", ticks: null},
        "input",
        make_scale([{from: 0, to: 1}], [0, 1], 404),
        "mm",
        as_it_is,
      )[0]!.text,
    ).toBe("");
  });
  it("says what the linkages of a layer are", () => {
    const layers: Axis = {
      ...directions,
      quantity: "link_ray",
      branches: [
        {name: "AB", from: 0, to: 1},
        {name: "AD", from: 1, to: 2},
      ],
    };
    const scale = make_scale(directions.blocks, [0, 1], 404);
    expect(axis_bars(layers, "input", scale, "mm", as_it_is).map(({text}) => text)).toEqual([
      "Ray ψ₁ ° · links A, B",
      "Ray ψ₁ ° · links A, D",
    ]);
    expect(has_layers(layers)).toBe(true);
    expect(has_layers(directions)).toBe(false);
    expect(axis_numbers(layers, scale)[1]!.text).toMatch(/°$/);
  });
  it("calls its branches as the kind of task does, and explains only what is called as in the frame", () => {
    const axis: Axis = {...directions, quantity: "curve_coordinate", ticks: null};
    const branches = [
      {name: "odd", from: 0, to: 1},
      {name: "oval", from: 1, to: 2},
    ];
    const bars = (say: Parameters<typeof axis_bars>[4]) =>
      axis_bars({...axis, branches}, "input", make_scale(directions.blocks, [0, 1], 404), "", say);
    expect(bars(as_it_is)).toMatchObject([
      {text: "Branch through infinity", term: "branch_infinity"},
      {text: "Closed branch", term: "branch_closed"},
    ]);
    expect(bars((key) => spherical_kind.texts?.[key] ?? key)).toMatchObject([
      {text: "Through antipodes", term: null},
      {text: "Pair of ovals", term: null},
    ]);
  });
});
