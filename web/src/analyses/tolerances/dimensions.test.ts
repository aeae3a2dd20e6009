import {describe, expect, it} from "vitest";
import type {ToleranceFigures} from "../../contract/messages";
import {
  advice_for,
  allocated,
  entry_of,
  factor_for_share,
  rounded,
  tolerance_at,
  with_tolerance,
  type Share,
} from "./dimensions";

const chain = [
  "length 1:a-b",
  "length 2:b-d",
  "length 2:d-z4",
  "length 4:c4-z4",
  "center_a_x",
  "center_a_y",
  "center_c4_x",
];

describe("a dimension's place in the file", () => {
  it("is found by its name", () => {
    expect(entry_of("coupler", false, [])).toBe("coupler");
    expect(entry_of("output_center_y", false, [])).toBe("ground_pivots");
    expect(entry_of("point_across", false, [])).toBe("point");
    expect(entry_of("driver", true, [])).toBe("driver_deg");
    expect(entry_of("input", true, [])).toBe("link_angle_deg");
  });
  it("of a longer linkage goes by what its body is hinged to", () => {
    const entries = chain.map((name) => entry_of(name, false, chain));
    expect(entries).toEqual([
      "input",
      "coupler",
      "coupler",
      "output",
      "ground_pivots",
      "ground_pivots",
      "ground_pivots",
    ]);
  });
});

describe("tolerances", () => {
  it("that are all one get an entry each when one changes", () => {
    const changed = with_tolerance({length: 0.5}, "output", 0.2);
    expect(changed.length).toEqual({input: 0.5, coupler: 0.5, output: 0.2, ground_pivots: 0.5, point: 0.5});
    expect(tolerance_at(changed, "output")).toBe(0.2);
    expect(tolerance_at(changed, "point")).toBe(0.5);
  });
  it("of angles stand beside them", () => {
    expect(with_tolerance({length: 0.5}, "driver_deg", 0.1)).toEqual({length: 0.5, driver_deg: 0.1});
    expect(tolerance_at({link_angle_deg: 0.3}, "link_angle_deg")).toBe(0.3);
    expect(tolerance_at({}, "input")).toBe(0);
  });
});

describe("a bar that is dragged", () => {
  /** Shares of the variance after the tolerance of some of them has changed. */
  const share_after = (share: number, common: number, factor: number) =>
    (share * factor ** 2) / (1 - common + common * factor ** 2);

  it("has the share to which it was dragged", () => {
    for (const wanted of [0.05, 0.3, 0.6])
      expect(share_after(0.2, 0.2, factor_for_share(0.2, 0.2, wanted))).toBeCloseTo(wanted, 10);
  });
  it("has it too where other dimensions share its tolerance", () => {
    for (const wanted of [0.02, 0.15, 0.3])
      expect(share_after(0.2, 0.5, factor_for_share(0.2, 0.5, wanted))).toBeCloseTo(wanted, 10);
  });
  it("gets no further than those allow, and stays where nothing else counts", () => {
    const factor = factor_for_share(0.2, 0.5, 0.9);
    expect(factor).toBeGreaterThan(5);
    expect(share_after(0.2, 0.5, factor)).toBeLessThan(0.4);
    expect(factor_for_share(1, 1, 0.5)).toBe(1);
  });
});

it("what is cheapest is taken over, of dimensions that share a tolerance the finest", () => {
  const figures = {
    sensitivities: [],
    allocation: [
      {parameter: "input", tolerance: 0.46071},
      {parameter: "input_center_x", tolerance: 0.4603},
      {parameter: "input_center_y", tolerance: 0.62},
    ],
  } as unknown as ToleranceFigures;
  const {length} = allocated({length: 0.5}, figures);
  expect(length).toEqual({input: 0.461, coupler: 0.5, output: 0.5, ground_pivots: 0.46, point: 0.5});
});
it("advice goes by the share", () => {
  const of = (share: number) => advice_for({share} as Share);
  expect([of(0.3), of(0.1), of(0.005)]).toEqual(["tighten", null, "loosen"]);
  expect(rounded(0.123456)).toBe(0.123);
});
