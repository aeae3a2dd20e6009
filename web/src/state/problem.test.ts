import {describe, expect, it} from "vitest";
import {default_max_length, with_pose, with_poses} from "../kinds/kind_dispatch";
import {new_problem} from "../kinds/motion/kind";
import {
  body_point,
  engine_text,
  outline_of,
  placed,
  poses_extent,
  round_step,
  with_options,
  with_requirements,
  with_view,
} from "./problem";
import {poses_of} from "./task";

describe("a problem", () => {
  it("is changed by making another", () => {
    const problem = new_problem(),
      before = JSON.stringify(problem);
    const changed = with_view(
      with_options(with_requirements(with_pose(problem, 2, {x: 7}), {max_link_ratio: 5}), {best: 3}),
      {traced: [[1, 2]]},
    );
    expect(JSON.stringify(problem)).toBe(before);
    expect(poses_of(changed.task)[2]).toEqual({...poses_of(problem.task)[2], x: 7});
    expect(poses_of(changed.task)[1]).toBe(poses_of(problem.task)[1]);
    expect(changed.requirements).toMatchObject({max_link_ratio: 5, min_transmission_angle_deg: 30});
    expect(changed.options).toEqual({best: 3});
  });
  it("loses a requirement that is undefined, not one that is off", () => {
    const problem = with_requirements(new_problem(), {min_transmission_angle_deg: undefined, max_length: null});
    expect(problem.requirements).toEqual({max_length: null});
  });
  it("is the same for the engine whatever the view", () => {
    const problem = new_problem();
    expect(
      engine_text(
        with_view(problem, {
          picked: [1, 2],
          outline: [
            [0, 0],
            [1, 0],
            [0, 1],
          ],
        }),
      ),
    ).toBe(engine_text(problem));
  });
});

describe("poses", () => {
  it("place points of the body, and take them back", () => {
    const pose = {x: 10, y: -5, theta_deg: 90};
    const at = placed([2, 1], pose);
    expect(at[0]).toBeCloseTo(9, 12);
    expect(at[1]).toBeCloseTo(-3, 12);
    const back = body_point(at, pose);
    expect(back[0]).toBeCloseTo(2, 12);
    expect(back[1]).toBeCloseTo(1, 12);
  });
  it("have an extent, never none", () => {
    expect(
      poses_extent([
        {x: 0, y: 0, theta_deg: 0},
        {x: 3, y: 4, theta_deg: 0},
      ]),
    ).toBe(5);
    expect(poses_extent([{x: 1, y: 1, theta_deg: 0}])).toBe(1);
  });
});

describe("sizes", () => {
  it("are rounded up to 1, 2 or 5", () => {
    expect([1, 1.01, 2, 3, 5, 7, 0.03, 1234].map(round_step)).toEqual([1, 2, 2, 5, 5, 10, 0.05, 2000]);
  });
  it("make an outline where the file has none", () => {
    const problem = new_problem();
    expect(outline_of(problem)).toHaveLength(4);
    const own = [
      [0, 0],
      [1, 0],
      [0, 1],
    ] as const;
    expect(outline_of(with_view(problem, {outline: own}))).toBe(own);
    expect(outline_of(with_view(problem, {outline: own.slice(1)}))).toHaveLength(4);
  });
  it("give new tasks a limit that grows with them", () => {
    const problem = new_problem(),
      limit = default_max_length(problem);
    expect(problem.requirements!.max_length).toBe(limit);
    const twice = with_poses(
      problem,
      poses_of(problem.task).map((p) => ({...p, x: 2 * p.x, y: 2 * p.y})),
    );
    expect(default_max_length(twice) / limit).toBeCloseTo(2, 0);
  });
});
