import {in_plane} from "../figure/mechanism";
import {describe, expect, it} from "vitest";
import type {MotionTask} from "../kinds/motion/task";
import type {TaskDocument} from "../state/document";
import {placed, type Problem} from "../state/problem";
import {poses_of, type Pose} from "../state/task";
import {duplicated, length_step, moved, proposed, referred, stepped} from "./poses";

const tailgate: Pose[] = [
  {x: 0, y: 0, theta_deg: 0},
  {x: -125, y: 75, theta_deg: -25},
  {x: -220, y: 220, theta_deg: -52},
  {x: -220, y: 450, theta_deg: -82},
];

describe("poses", () => {
  it("moves, doubles and adds", () => {
    expect(moved(["a", "b", "c"] as never, 0, 2)).toEqual(["b", "c", "a"]);
    expect(duplicated(tailgate, 1, 1)[2]).toEqual({x: -115, y: 85, theta_deg: -25});
    expect(duplicated(tailgate, 1, 1)).toHaveLength(5);
    expect(proposed(tailgate, 1)).toEqual({x: -220, y: 680, theta_deg: -112});
    expect(proposed([], 1)).toEqual({x: 0, y: 0, theta_deg: 0});
    expect(
      proposed(
        [
          {x: 0, y: 0, theta_deg: 170},
          {x: 1, y: 0, theta_deg: -170},
        ],
        0.01,
      ),
    ).toEqual({x: 2, y: 0, theta_deg: -150});
  });
  it("has a step that suits the size", () => {
    const points = tailgate.map((p) => [p.x, p.y] as const);
    expect(length_step(points)).toBe(1);
    expect(length_step(points.map(([x, y]) => [x / 1000, y / 1000] as const))).toBe(0.001);
    expect(length_step([])).toBe(1);
    expect(stepped(0.1, 2, 0.1)).toBe(0.3);
    expect(stepped(12.345678, 1, 1)).toBe(13.345678);
    expect(stepped(0.3, -0.1, 1)).toBe(0.2);
  });
  it("is seen from another pose", () => {
    const problem: Problem = {
      linkwright: 1,
      task: {kind: "motion", mechanism: "four_bar", poses: tailgate},
      requirements: {ground_pivots_within: {x: [0, 10], y: [0, 20]}, max_length: 450},
    };
    const pin = {
      name: "A",
      tau: [0, 1],
      task: problem.task,
      pivots: {input_center: [1, 2], input_circle: null, output_center: null, output_circle: null},
    };
    const document = {problem, picked: null, pins: [pin], order: 0} as unknown as TaskDocument;
    const seen = referred(document, 2),
      back = tailgate[2];
    expect(poses_of(seen.problem.task)[2]).toEqual({x: 0, y: 0, theta_deg: 0});
    poses_of(seen.problem.task).forEach((pose, i) => {
      const [x, y] = placed([pose.x, pose.y], back!);
      expect([x, y, pose.theta_deg + back!.theta_deg].map((v) => Number(v.toFixed(9)) + 0)).toEqual([
        tailgate[i]!.x,
        tailgate[i]!.y,
        tailgate[i]!.theta_deg,
      ]);
    });
    const corner = placed(
      [seen.problem.requirements!.ground_pivots_within!.x[0], seen.problem.requirements!.ground_pivots_within!.y[0]],
      back!,
    );
    expect(corner.every(Number.isFinite)).toBe(true);
    const {x, y} = seen.problem.requirements!.ground_pivots_within!;
    expect(x[1] - x[0]).toBeCloseTo(10 * Math.cos(0.9075712) + 20 * Math.sin(0.9075712), 4);
    expect(y[1] - y[0]).toBeCloseTo(20 * Math.cos(0.9075712) + 10 * Math.sin(0.9075712), 4);
    expect(seen.problem.requirements!.max_length).toBe(450);
    expect(seen.pins[0]!.task).toBe(seen.problem.task);
    expect(placed(in_plane(seen.pins[0]!.pivots.input_center)!, back!)).toEqual([
      expect.closeTo(1, 9),
      expect.closeTo(2, 9),
    ]);
    const given = referred(
      {
        ...document,
        problem: {
          ...problem,
          task: {
            kind: "motion",
            mechanism: "four_bar",
            poses: tailgate.slice(1),
            given: {instant_center: [5, 6]},
          } as MotionTask,
        },
      },
      1,
    );
    const {given: center} = given.problem.task as unknown as {given: {instant_center: [number, number]}};
    expect(placed(center.instant_center, back!)).toEqual([expect.closeTo(5, 9), expect.closeTo(6, 9)]);
  });
  it("takes the linkages along that a fit begins with", () => {
    const link = {center_point: [1, 2], circle_point: [3, 4]} as const,
      start = {input: link, output: {...link, circle_point: [7, 8]}, pose: {x: 5, y: 6, theta_deg: 40}} as const,
      problem = {
        linkwright: 1 as const,
        task: {kind: "motion", mechanism: "four_bar", poses: tailgate} as MotionTask,
        options: {fit: {starts: [start, {...start, point: [9, 1] as const}]}},
      };
    const document = {problem, picked: null, pins: [], order: 0} as unknown as TaskDocument,
      back = tailgate[2]!,
      [first, second] = referred(document, 2).problem.options!.fit!.starts!;
    const there = (point: readonly [number, number]) => placed(point, back).map((value) => Number(value.toFixed(9)));
    expect([first!.input, first!.output].flatMap((of) => [there(of.center_point), there(of.circle_point)])).toEqual([
      [1, 2],
      [3, 4],
      [1, 2],
      [7, 8],
    ]);
    const {x, y, theta_deg} = first!.pose!;
    expect([...there([x, y]), Number((theta_deg + back.theta_deg).toFixed(9))]).toEqual([5, 6, 40]);
    expect([first!.point, there(second!.point!)]).toEqual([undefined, [9, 1]]);
  });
});
