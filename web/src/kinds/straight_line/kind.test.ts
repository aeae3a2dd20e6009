import {describe, expect, it} from "vitest";
import type {Axis, Point} from "../../contract/messages";
import {range_of, window_of} from "./axes";
import {along_line, beside, form_of, forms, size_of, with_form} from "./cases";
import {pattern_of_contacts, patterns, with_pattern} from "./contacts";
import {straight_line_kind} from "./kind";
import type {StraightLineTask} from "./task";

const [, given, free] = straight_line_kind.beginnings.map(({make}) => make().task as StraightLineTask) as [
  StraightLineTask,
  StraightLineTask,
  StraightLineTask,
];

describe("the cases of a straight line", () => {
  it.each(forms.map((form) => ({id: form.id, form})))(
    "$id begins with what it asks for, and is read again",
    ({form}) => {
      for (const from of [given, free]) {
        const task = with_form(from, form);
        expect(form_of(task)).toBe(form);
        expect(task.line).toEqual(from.line);
        for (const {name} of form.numbers) expect(task[name]).toBeDefined();
        expect(size_of(task)).toBeGreaterThan(0);
        expect(straight_line_kind.read(JSON.parse(JSON.stringify(task)))).toEqual(task);
      }
    },
  );
  it("keep what two of them have in common", () => {
    const five = with_form(
        free,
        forms.find(({id}) => id === "five_point")!,
      ),
      cubic = with_form(
        five,
        forms.find(({id}) => id === "four_point_cubic")!,
      );
    expect([cubic.pole_distance, cubic.point_ray_deg]).toEqual([five.pole_distance, five.point_ray_deg]);
    const pole = with_form(
      given,
      forms.find(({id}) => id === "pole_at_given_pivot")!,
    );
    expect(pole.ground_pivots).toEqual(given.ground_pivots);
    const mixed = with_form(
      given,
      forms.find(({id}) => id === "mixed")!,
    );
    expect(mixed.input_pivot).toEqual(given.ground_pivots!.input);
    expect(mixed.contacts!.reduce((sum, {multiplicity}) => sum + multiplicity, 0)).toBe(4);
    expect(straight_line_kind.pattern(mixed)).toBe("P-P-P-P");
  });
  it("refuse another's form", () => {
    expect(straight_line_kind.read({...given, case: "none"})).toBeNull();
    expect(straight_line_kind.read({...given, line: {point: [0, 0]}})).toBeNull();
  });
});

it("lays contacts in every pattern of four points", () => {
  const contacts = [
    {s: 0, multiplicity: 1},
    {s: 10, multiplicity: 1, side: -1},
    {s: 35, multiplicity: 1},
    {s: 60, multiplicity: 1},
  ];
  for (const pattern of patterns) {
    const laid = with_pattern(contacts, pattern);
    expect(pattern_of_contacts(laid)).toBe(pattern);
    expect([laid[0]!.s, laid.at(-1)!.s]).toEqual([0, 60]);
    expect(laid.reduce((sum, {multiplicity}) => sum + multiplicity, 0)).toBe(4);
  }
  expect(with_pattern(contacts, "P-P-P-P")).toEqual(contacts);
  expect(with_pattern(contacts, "P-PP-P").map(({s}) => s)).toEqual([0, 30, 60]);
});

describe("a line", () => {
  it("tells how far along it a point is, and how far to its left", () => {
    const line = {point: [3, -2] as Point, direction_deg: 35},
      [s, e] = along_line(line, beside(line, 7, -1.5));
    expect(s).toBeCloseTo(7, 12);
    expect(e).toBeCloseTo(-1.5, 12);
    expect(along_line({point: [0, 0], direction_deg: 90}, [-2, 5]).map((x) => x + 0)).toEqual([
      expect.closeTo(5, 12),
      expect.closeTo(2, 12),
    ]);
  });
  it("moves with the frame, its direction too", () => {
    const turned = straight_line_kind.moved(given, ([x, y]) => [-y, x]);
    expect(turned.line.point).toEqual([-200, 150]);
    expect(turned.line.direction_deg).toBeCloseTo(110, 9);
    expect(turned.ground_pivots!.output).toEqual([-0, 300]);
    const shifted = straight_line_kind.moved(given, ([x, y]) => [x + 1, y]);
    expect(shifted.line.direction_deg).toBe(given.line.direction_deg);
  });
});

it("reads the ranges of the axes off their ticks", () => {
  const axis: Axis = {
    quantity: "link_length",
    order: 0,
    blocks: [],
    branches: [{name: "link_length", from: 0, to: 1}],
    ticks: Array.from({length: 12}, (_, i) => [i / 12, 60 + (340 * i) / 12] as const),
  };
  expect(range_of(axis)).toEqual([60, 400]);
  expect(range_of({...axis, ticks: null})).toBeNull();
  expect(window_of({input: [60, 400], output: null})).toBeUndefined();
  expect(window_of({input: [60, 400], output: [-1, 1]})).toEqual([
    [60, 400],
    [-1, 1],
  ]);
});
