import {describe, expect, it} from "vitest";
import {new_problem} from "../kinds/motion/kind";
import {read_problem, read_view} from "./problem_shape";

const pin = {
  name: "A",
  note: "near the roof",
  tau: [0.1, 0.2],
  place: [0.3, 0.4],
  task: {kind: "motion", mechanism: "four_bar", poses: [{x: 0, y: 1, theta_deg: 2}]},
  type: "double_crank",
  min_transmission_angle_deg: 40,
  link_ratio: null,
  longest: 3,
  lengths: {ground: 1, input: 2, coupler: 3, output: 4},
  pivots: {input_center: [0, 0], input_circle: null, output_center: [1, 0], output_circle: [1, 1]},
};

describe("a view from outside", () => {
  it("keeps what is right", () => {
    const view = {
      outline: [
        [0, 0],
        [1, 0],
        [0, 1],
      ],
      picked: [0.5, 1],
      pins: [pin],
      traced: [[1, 2]],
      order: 5,
    };
    expect(read_view(view)).toEqual(view);
  });
  it("leaves out what is not", () => {
    expect(read_view(null)).toEqual({});
    expect(read_view([1, 2])).toEqual({});
    expect(
      read_view({
        outline: [
          [0, 0],
          [1, 0],
        ],
        picked: [1],
        order: 0.5,
        traced: "x",
        zoom: 3,
      }),
    ).toEqual({});
    expect(
      read_view({
        outline: [
          [0, 0],
          [1, 0],
          [0, "<b>"],
        ],
        picked: [NaN, 1],
      }),
    ).toEqual({});
  });
  it("takes pins one by one", () => {
    const pins = [
      pin,
      {...pin, name: "lid, 2nd try <b>"},
      {...pin, name: " "},
      {...pin, name: "B", type: "no_such_type"},
      {...pin, name: "C", tau: [1]},
      null,
      {...pin, note: 7, name: "D", lengths: {ground: "x"}},
    ];
    const read = read_view({pins}).pins!;
    expect(read.map((p) => p.name)).toEqual(["A", "lid, 2nd try <b>", "D"]);
    expect(read[2]!.note).toBeUndefined();
    expect(read[2]!.lengths).toBeNull();
  });
  it("takes pins of old, which had poses", () => {
    const {task, ...old} = pin;
    expect(read_view({pins: [{...old, poses: task.poses}]}).pins).toEqual([pin]);
    expect(read_view({pins: [old]}).pins).toEqual([]);
  });
  it("gives the second pin of a name another, and loses none", () => {
    expect(
      read_view({pins: [pin, {...pin, tau: [9, 9]}, {...pin, name: "B"}]}).pins!.map(({name, tau}) => [name, tau[0]]),
    ).toEqual([
      ["A", 0.1],
      ["B", 9],
      ["C", 0.1],
    ]);
  });
  it("shows no picture but one that is in the file", () => {
    const background = {x: 0, y: 0, width: 10, aspect: 0.5};
    expect(read_view({background: {...background, image: "data:image/png;base64,AAAA"}})).toEqual({
      background: {...background, image: "data:image/png;base64,AAAA"},
    });
    for (const image of [
      "https://example.org/a.png",
      "data:image/svg+xml;base64,AAAA",
      "data:text/html,<b>",
      "javascript:1",
      3,
    ]) {
      expect(read_view({background: {...background, image}})).toEqual({});
    }
    expect(read_view({background: {...background, width: 0, image: "data:image/png;base64,AAAA"}})).toEqual({});
  });
});

describe("a problem from outside", () => {
  it("is itself where it is right", () => {
    expect(read_problem(JSON.parse(JSON.stringify(new_problem())))).toEqual(new_problem());
  });
  it.each([
    null,
    3,
    [],
    {},
    {linkwright: 2},
    {linkwright: 1, task: {kind: "motion", mechanism: "six_bar", poses: []}},
    {linkwright: 1, task: {kind: "motion", mechanism: "four_bar", poses: [{x: 1}]}},
  ])("is nothing where it is not: %j", (value) => expect(read_problem(value)).toBeNull());
});
