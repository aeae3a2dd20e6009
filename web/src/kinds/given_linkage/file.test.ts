// Linkage files of every form: what is taken of them, their numbers, and the way back to a file.
import {readFileSync, readdirSync} from "node:fs";
import {describe, expect, it} from "vitest";
import {without_comments} from "../../shell/own_files";
import type {JsonObject} from "../../state/shape";
import {file_of, linkage_of_file, lines_of, reach_of, with_number} from "./file";
import type {LinkageTask} from "./task";
import {line_words} from "./line_words";

const folder = new URL("../../../../examples/linkages/", import.meta.url);
const pivots = {input_center: [0, 0], input_circle: [1, 2], output_center: [4, 0], output_circle: [5, 3]};
const six_bar = {
  mechanism: "six_bar",
  chain: {a: [0, 0], b: [1, 0], d: [2, 1]},
  added: [
    {
      between: "0-2",
      points: [
        [3, 0],
        [1, 1],
      ],
      length: 9,
    },
    {
      between: "0-3",
      points: [
        [4, 0],
        [2, 2],
      ],
    },
  ],
};
const of = (file: JsonObject): LinkageTask => linkage_of_file(file)!;

describe("a linkage file", () => {
  it.each(readdirSync(folder))("of the examples is a linkage: %s", (name) => {
    const file = JSON.parse(without_comments(readFileSync(new URL(name, folder), "utf8")));
    expect(lines_of(of(file)).length).toBeGreaterThan(3);
  });
  it("is bare numbers, wherever they stood", () => {
    const dyads = {
      input: {center_point: [0, 0], circle_point: [1, 2], coordinate: 0.3},
      output: {center_point: [4, 0], circle_point: [5, 3], coordinate: 0.7},
      lengths: {ground: 4, input: 1, coupler: 1, output: 1},
      type: "crank_rocker",
    };
    expect(of({linkwright: 1, linkage: dyads, poses: [{x: 0, y: 0, theta_deg: 0}]}).file).toEqual({
      mechanism: "four_bar",
      pivots,
      poses: [{x: 0, y: 0, theta_deg: 0}],
    });
    expect(
      of({
        linkage: {
          mechanism: "spherical_four_bar",
          input: {fixed_axis: [0, 0, 1], moving_axis: [0, 1, 1]},
          output: {fixed_axis: [1, 0, 0], moving_axis: [1, 1, 1]},
        },
      }).file.axes,
    ).toEqual({
      input_fixed: [0, 0, 1],
      input_moving: [0, 1, 1],
      output_moving: [1, 1, 1],
      output_fixed: [1, 0, 0],
    });
    expect(of(six_bar).file.added).toEqual(six_bar.added.map(({between, points}) => ({between, points})));
  });
  it("is none without a linkage", () => {
    for (const file of [{}, {linkage: 5}, {linkage: {mechanism: "six_bar"}}, {mechanism: "cam", lengths: {}}])
      expect(linkage_of_file(file)).toBeNull();
  });
  it("has its numbers by lines, each with a name of its own", () => {
    for (const [file, count] of [
      [{lengths: {ground: 4, input: 1, coupler: 3, output: 2}}, 4],
      [{pivots}, 4],
      [{mechanism: "spherical_four_bar", angles_deg: {ground: 80, input: 30, coupler: 70, output: 60}}, 4],
      [six_bar, 7],
    ] as const) {
      const task = of(file as JsonObject),
        names = lines_of(task).map((line) => line_words(line, task));
      expect(names).toHaveLength(count);
      expect(new Set(names).size).toBe(count);
      expect(names.join()).not.toContain("undefined");
    }
  });
  it("takes another number where it belongs", () => {
    const task = of(six_bar),
      line = lines_of(task).find(({key}) => key === "added.1.points.0")!;
    const changed = with_number(task, line, 1, -7);
    expect((changed.file.added as {points: unknown}[])[1]!.points).toEqual([
      [4, -7],
      [2, 2],
    ]);
    expect(task.file.added).toEqual(of(six_bar).file.added);
    const lengths = of({lengths: {ground: 4, input: 1, coupler: 3, output: 2}});
    expect(with_number(lengths, lines_of(lengths)[1]!, 0, 1.5).file.lengths).toEqual({
      ground: 4,
      input: 1.5,
      coupler: 3,
      output: 2,
    });
  });
  it("is saved as the program reads it", () => {
    const task = of({pivots});
    expect(file_of({linkwright: 1, title: "x", task})).toEqual({
      linkwright: 1,
      title: "x",
      mechanism: "four_bar",
      pivots,
    });
    const sought = {kind: "motion", mechanism: "four_bar", poses: []};
    expect(file_of({linkwright: 1, task: sought})).toEqual({linkwright: 1, task: sought});
  });
  it("takes the room that its numbers tell of", () => {
    expect(reach_of(of({pivots}))).toHaveLength(4);
    expect(reach_of(of({lengths: {ground: 40, input: 10, coupler: 30, output: 20}}))[1]).toEqual([60, 20]);
  });
});
