import {describe, expect, it} from "vitest";
import type {Linkage} from "../../contract/messages";
import {with_options, type Problem} from "../../state/problem";
import {can_be_near, misses_of, near_poses, near_tolerance, with_near, with_near_tolerance} from "./near_poses";
import type {MotionTask} from "./task";

const pose = (i: number) => ({x: 10 * i, y: i * i, theta_deg: 12 * i});
const problem = (count: number, rest: Partial<Problem> = {}): Problem => ({
  linkwright: 1,
  ...rest,
  task: {kind: "motion", mechanism: "four_bar", poses: Array.from({length: count}, (_, i) => pose(i))} as MotionTask,
});
const task = (of: Problem) => of.task as MotionTask;

describe("near poses", () => {
  it("are switched on and off, without what goes with the other", () => {
    const moving = problem(5);
    task(moving).poses = task(moving).poses.map((one, i) =>
      i === 1 ? {...one, derivatives: [{x: 1, y: 0, theta: 0}]} : one,
    );
    const near = with_near(moving, 2, true);
    expect(task(near).poses[1]).toEqual({...pose(1), near: true});
    expect(near_poses(task(near))).toEqual([2]);
    const within = with_near_tolerance(near, "position", 2);
    expect(task(within).poses[1]!.tolerance).toEqual({position: 2});
    expect(task(with_near(within, 4, true)).poses[3]).toEqual({...pose(3), near: true, tolerance: {position: 2}});
    expect(task(with_near(within, 2, false)).poses[1]).toEqual(pose(1));
  });
  it("take what only they ask for away with the last of them", () => {
    const asked = problem(6, {
      options: {objective: "near_error", best: 3},
      requirements: {max_near_error: 2, max_length: 900},
    });
    const near = with_near(with_near(asked, 2, true), 5, true);
    expect(near.options).toEqual(asked.options);
    const fitted = with_near(with_options(with_near(near, 6, true), {fit: {effort: "quick"}}), 1, true);
    expect(fitted.options!.fit).toEqual({effort: "quick"});
    expect(with_near(with_near(fitted, 6, false), 1, false).options).toEqual(asked.options); // four are exact
    const last = with_near(with_near(near, 2, false), 5, false);
    expect([last.options, last.requirements]).toEqual([{best: 3}, {max_length: 900}]);
    const ranked = with_near(with_near(problem(6, {options: {objective: "size"}}), 2, true), 2, false);
    expect(ranked.options).toEqual({objective: "size"});
  });
  it("have a tolerance that all of them share, or none that is told", () => {
    const near = with_near(with_near(problem(6), 2, true), 5, true),
      both = with_near_tolerance(with_near_tolerance(near, "position", 2), "angle_deg", 0.5);
    expect([near_tolerance(task(both), "position"), near_tolerance(task(both), "angle_deg")]).toEqual([2, 0.5]);
    expect(near_tolerance(task(near), "position")).toBeNull();
    expect(task(with_near_tolerance(with_near_tolerance(both, "position", null), "angle_deg", 0))).toEqual(task(near));
  });
  it("want three poses, and are no matter of other tasks", () => {
    expect([can_be_near(problem(2)), can_be_near(problem(3))]).toEqual([false, true]);
  });
  it("are missed by as much as is told, exact ones left out", () => {
    const at = [
      {pose: 1, near: false, distance: 0, angle_deg: 0},
      {pose: 2, near: true, distance: 1.5, angle_deg: -0.2},
    ];
    const hand = {near: {at, outside: [2]}} as unknown as Linkage;
    expect(misses_of(hand)).toEqual([{pose: 2, distance: 1.5, angle_deg: -0.2, outside: true}]);
    expect(misses_of(null)).toEqual([]);
  });
});
