import {describe, expect, it} from "vitest";
import type {Linkage, Point} from "../contract/messages";
import {six_bar} from "../kinds/six_bar/figure";
import {paint_figure} from "./canvas";
import {is_slender, middle_of, points_of, web_of, type Figure} from "./figure";
import {four_bar} from "./four_bar";

const corners_of = ({bodies}: Figure, link: string) => bodies.find(({name}) => name === link)!.corners;

const linkage = {
  input: {center: [0, 0], circle: [0, 50], center_homogeneous: [1, 0, 0], circle_homogeneous: [1, 0, 50]},
  output: {center: [100, 0], circle: [100, 80], center_homogeneous: [1, 100, 0], circle_homogeneous: [1, 100, 80]},
  drive: null,
} as unknown as Linkage;
const poses = [
  {x: 0, y: 0, theta_deg: 0},
  {x: 10, y: 20, theta_deg: 90},
];
const outline: Point[] = [
  [0, 0],
  [4, 0],
  [4, 2],
];
const names = (figure: Figure) => figure.bodies.map(({name}) => name);

describe("the figure of a four-bar", () => {
  it("has three bars, four pivots and the body on its coupler", () => {
    const figure = four_bar.figure(linkage, four_bar.still(linkage, poses, 0), outline);
    expect(names(figure)).toEqual(["coupler", "input", "output"]);
    expect(figure.joints.map(({name, kind}) => [name, kind])).toEqual([
      ["input_ground", "ground_pivot"],
      ["output_ground", "ground_pivot"],
      ["input_coupler", "moving_pivot"],
      ["output_coupler", "moving_pivot"],
    ]);
    expect(figure.guided).toEqual({pose: poses[0], outline, on: "coupler"});
    expect(figure.sliders).toEqual([]);
    expect(is_slender(figure)).toBe(false);
    expect(points_of(figure)).toContainEqual([4, 2]);
  });
  it("joins the body to the coupler, wherever both are, and in films too", () => {
    for (const stage of [0, 1]) {
      const figure = four_bar.figure(linkage, four_bar.still(linkage, poses, stage), outline),
        web = web_of(figure)!;
      for (const pivot of corners_of(figure, "coupler")) expect(web).toContainEqual(pivot);
      expect(web.length).toBeGreaterThan(2); // and a corner of the body, or two
    }
    expect(web_of(four_bar.figure(linkage, four_bar.still(linkage, poses, 0)))).toBeNull();
    const figure = four_bar.figure(linkage, four_bar.still(linkage, poses, 0), outline),
      lines: string[] = [];
    const context = new Proxy({} as Record<string, unknown>, {
      get: (_, name) => (name === "lineTo" ? (...at: number[]) => lines.push(at.join()) : () => {}),
      set: () => true,
    });
    paint_figure(context as unknown as CanvasRenderingContext2D, figure, (point) => point, {} as never);
    expect(lines.join(" ")).toContain(
      web_of(figure)!
        .map((point) => point.join())
        .join(" "),
    );
  });
  it("stands at the position nearest to the stage, its moving pivots carried along", () => {
    const figure = four_bar.figure(linkage, four_bar.still(linkage, poses, 0.8));
    expect(figure.guided).toBeNull();
    const [from, to] = corners_of(figure, "input") as [Point, Point];
    expect(from).toEqual([0, 0]);
    expect(to[0]).toBeCloseTo(-40, 9);
    expect(to[1]).toBeCloseTo(20, 9);
    expect(four_bar.visits(linkage, poses)).toHaveLength(2);
  });
  it("has a slider for a pivot at infinity: fixed for the ground's, else turning with the body", () => {
    const without = (end: "center" | "circle") =>
      ({...linkage, input: {...linkage.input, [end]: null, [`${end}_homogeneous`]: [0, 3, 4]}}) as Linkage;
    const slider = (of: Linkage, stage: number) => four_bar.figure(of, four_bar.still(of, poses, stage)).sliders[0];
    expect(slider(without("center"), 1)).toMatchObject({end: "center", fixed: true, away: [0.6, 0.8]});
    const turned = slider(without("circle"), 1);
    expect(turned).toMatchObject({end: "circle", fixed: false, at: [0, 0]});
    expect(turned?.away[0]).toBeCloseTo(-0.8, 9);
    expect(turned?.away[1]).toBeCloseTo(0.6, 9);
    expect(names(four_bar.figure(without("circle"), four_bar.still(without("circle"), poses, 0)))).toEqual(["output"]);
  });
  it("is drawn from its pivots alone, and nothing from those of something else", () => {
    const pivots: Point[] = [
      [0, 0],
      [0, 50],
      [100, 0],
      [100, 80],
    ];
    expect(names(four_bar.sketch(pivots))).toEqual(["coupler", "input", "output"]);
    expect(four_bar.sketch([...pivots, [1, 1]]).bodies).toEqual([]);
    expect(six_bar.sketch(pivots).bodies).toEqual([]);
  });
});

describe("the figure of a six-bar", () => {
  const joints = ["a", "b", "d", "c4", "z4", "c5", "z5"].map((name, i) => ({
    name,
    ground: name === "a" || name === "c4",
    at: [10 * i, i * i] as Point,
  }));
  const bodies = [
    [0, 3],
    [0, 1, 6],
    [1, 2, 5],
    [2, 4],
    [3, 4],
    [5, 6],
  ];
  const of = {
    ...linkage,
    six_bar: {topology: "watt_1", joints, bodies, lengths: []},
  } as unknown as Linkage;
  const figure = six_bar.figure(of, six_bar.still(of, poses, 0), outline);
  it("has bars and plates, named hinges, and the body on the last link of the chain", () => {
    expect(figure.bodies.map(({name, role, corners}) => [name, role, corners.length])).toEqual([
      ["body_1", "driver", 3],
      ["body_2", "coupler", 3],
      ["body_3", "coupler", 2],
      ["body_4", "input", 2],
      ["body_5", "output", 2],
    ]);
    expect(figure.joints.map(({name, kind, joins}) => [name, kind === "ground_pivot", joins.join()])).toEqual([
      ["a", true, "ground,body_1"],
      ["b", false, "body_1,body_2"],
      ["d", false, "body_2,body_3"],
      ["c4", true, "ground,body_4"],
      ["z4", false, "body_3,body_4"],
      ["c5", false, "body_2,body_5"],
      ["z5", false, "body_1,body_5"],
    ]);
    expect(figure.joints.map(({end}) => end && `${end.side} ${end.end}`).slice(3)).toEqual([
      "input center",
      "input circle",
      "output center",
      "output circle",
    ]);
    expect(figure.guided?.on).toBe("body_3");
    expect(web_of(figure)).toEqual(
      expect.arrayContaining([
        [20, 4],
        [40, 16],
      ]),
    );
    expect(is_slender(figure)).toBe(true);
    expect(middle_of(figure.bodies[2]!)).toEqual([30, 10]);
  });
});
