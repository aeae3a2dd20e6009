import {describe, expect, it} from "vitest";
import {
  body_point, default_max_length, engine_text, incompleteness, new_problem, outline_of, placed, poses_extent, round_step, same_poses, with_options,
  with_pose, with_poses, with_requirements, with_view, type Problem,
} from "./problem";

describe("a problem", () => {
  it("is changed by making another", () => {
    const problem = new_problem(), before = JSON.stringify(problem);
    const changed = with_view(with_options(with_requirements(with_pose(problem, 2, {x: 7}), {max_link_ratio: 5}), {best: 3}), {traced: [[1, 2]]});
    expect(JSON.stringify(problem)).toBe(before);
    expect(changed.task.poses[2]).toEqual({...problem.task.poses[2], x: 7});
    expect(changed.task.poses[1]).toBe(problem.task.poses[1]);
    expect(changed.requirements).toMatchObject({max_link_ratio: 5, min_transmission_angle_deg: 30});
    expect(changed.options).toEqual({best: 3});
  });
  it("loses a requirement that is undefined, not one that is off", () => {
    const problem = with_requirements(new_problem(), {min_transmission_angle_deg: undefined, max_length: null});
    expect(problem.requirements).toEqual({max_length: null});
  });
  it("is the same for the engine whatever the view", () => {
    const problem = new_problem();
    expect(engine_text(with_view(problem, {picked: [1, 2], outline: [[0, 0], [1, 0], [0, 1]]}))).toBe(engine_text(problem));
  });
  it("is complete with four positions, derivatives counted", () => {
    const problem = new_problem(), {poses} = problem.task, moving = {...poses[0], derivatives: [{x: 1, y: 0, theta: 0}]};
    const found = [[], poses.slice(1), poses, [moving, ...poses.slice(2)], [moving, ...poses.slice(1)]].map((list) => incompleteness(with_poses(problem, list)));
    expect(found).toEqual(["empty", "too_few", null, null, "too_many"]);
  });
});

describe("poses", () => {
  it("are the same by value, in whatever order their keys come", () => {
    const a = [{x: 1, y: 2, theta_deg: 3}], b = [{theta_deg: 3, y: 2, x: 1}];
    expect(same_poses(a, b)).toBe(true);
    expect(same_poses(a, [{x: 1, y: 2, theta_deg: 4}])).toBe(false);
    expect(same_poses(a, [...b, ...b])).toBe(false);
    const bent = {...a[0], derivatives: [{x: 1, y: 0, theta: 0.5}]};
    expect(same_poses(a, [bent])).toBe(false);
    expect(same_poses([bent], [{...b[0], derivatives: [{theta: 0.5, y: 0, x: 1}]}])).toBe(true);
  });
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
    expect(poses_extent([{x: 0, y: 0, theta_deg: 0}, {x: 3, y: 4, theta_deg: 0}])).toBe(5);
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
    const own = [[0, 0], [1, 0], [0, 1]] as const;
    expect(outline_of(with_view(problem, {outline: own}))).toBe(own);
    expect(outline_of(with_view(problem, {outline: own.slice(1)}))).toHaveLength(4);
  });
  it("give new tasks a limit that grows with them", () => {
    const problem = new_problem(), limit = default_max_length(problem);
    expect(problem.requirements!.max_length).toBe(limit);
    const twice: Problem = {...problem, task: {...problem.task, poses: problem.task.poses.map((p) => ({...p, x: 2 * p.x, y: 2 * p.y}))}};
    expect(default_max_length(twice) / limit).toBeCloseTo(2, 0);
  });
});
