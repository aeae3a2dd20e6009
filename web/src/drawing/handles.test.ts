import {describe, expect, it} from "vitest";
import type {Problem} from "../state/problem";
import {border_hit, curvature_place, inside, pose_handles, task_handle, within_reach} from "./handles";
import {Plane} from "./space";

const space = new Plane({x: 0, y: 0, scale: 1, width: 400, height: 400}, true);
const problem = {
  linkwright: 1,
  task: {
    kind: "motion",
    mechanism: "four_bar",
    poses: [
      {x: 0, y: 0, theta_deg: 0},
      {x: 8, y: 0, theta_deg: 90},
      {x: 58, y: 3, theta_deg: 0},
    ],
  },
} as Problem;

describe("handles", () => {
  it("come in the order of priority", () => {
    const ids = (selected: number | null, at: readonly [number, number]) =>
      within_reach(pose_handles(problem, space, selected, false), at, false).map((h) => h.id);
    expect(ids(null, [205, 200])).toEqual(["disc_2", "disc_1"]);
    expect(ids(0, [205, 200])).toEqual(["disc_1", "disc_2"]);
    expect(ids(null, [258, 199])).toEqual(["disc_3", "knob_1"]);
    expect(ids(0, [258, 199])).toEqual(["knob_1", "disc_3"]);
    expect(ids(null, [20, 20])).toEqual([]);
  });
  it("come before those of a higher priority that are only near", () => {
    const part = {part: "hinge", label: () => "", drag: () => null!, nudge: () => {}},
      handles = [...pose_handles(problem, space, null, false), task_handle(part, [200, 213])];
    const first = (at: readonly [number, number]) => within_reach(handles, at, false)[0]!.id;
    expect(first([200, 213])).toBe("hinge");
    expect(first([200, 209])).toBe("disc_1");
  });
  it("reach farther under a finger, and a phone shows the selected knob only", () => {
    expect(within_reach(pose_handles(problem, space, null, true), [200, 220], false)).toEqual([]);
    expect(within_reach(pose_handles(problem, space, null, true), [200, 220], true).map((h) => h.id)).toContain(
      "disc_1",
    );
    expect(
      pose_handles(problem, space, 1, true)
        .filter((h) => h.target.kind === "knob")
        .map((h) => h.id),
    ).toEqual(["knob_2"]);
  });
  it("of curvature lie on the osculating parabola", () => {
    const pose = {
      x: 0,
      y: 0,
      theta_deg: 0,
      derivatives: [
        {x: 2, y: 0, theta: 0},
        {x: 0, y: 0.04, theta: 0},
      ],
    };
    const [x, y] = curvature_place(pose, space)!;
    expect(x).toBeCloseTo(274, 9);
    expect(y).toBeCloseTo(200 - (0.01 * 74 * 74) / 2, 9);
  });
});

describe("boxes", () => {
  const box = {x: [-100, 100] as [number, number], y: [-50, 50] as [number, number]};
  it("are resized at edges and corners and moved just inside", () => {
    expect(border_hit(box, space, [100, 150], 8)?.edges).toEqual({x: -1, y: 1});
    expect(border_hit(box, space, [303, 200], 8)?.edges).toEqual({x: 1, y: 0});
    expect(border_hit(box, space, [200, 252], 8)?.edges).toEqual({x: 0, y: -1});
    expect(border_hit(box, space, [200, 236], 8)?.edges).toEqual({x: 0, y: 0});
    expect(border_hit(box, space, [200, 200], 8)).toBeNull();
    expect(border_hit(box, space, [320, 200], 8)).toBeNull();
  });
});

it("a point lies inside a polygon or not", () => {
  const hook = [
    [0, 0],
    [10, 0],
    [10, 10],
    [5, 2],
    [0, 10],
  ] as const;
  expect(inside(hook, [1, 5])).toBe(true);
  expect(inside(hook, [5, 6])).toBe(false);
});
