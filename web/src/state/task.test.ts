import {describe, expect, it} from "vitest";
import {diagonal_of, pattern_of, position_count, same_task, told_position, type Pose} from "./task";
import type {FunctionTask} from "../kinds/function/task";
import type {MotionTask} from "../kinds/motion/task";
import {with_task_poses} from "../kinds/kind_dispatch";

const pose = {x: 1, y: 2, theta_deg: 3};
const motion: MotionTask = {
  kind: "motion",
  mechanism: "four_bar",
  poses: [pose, {...pose, x: 5}, {...pose, x: 9}],
  given: {side_lengths: [3, 4]},
};
const pairs: FunctionTask = {kind: "function", mechanism: "four_bar", pairs: [{input_deg: 0, output_deg: 1}]};

describe("tasks", () => {
  it("are the same by value, in whatever order their keys come", () => {
    const again = {
      given: {side_lengths: [3, 4]},
      poses: motion.poses.map(({x, y, theta_deg}) => ({theta_deg, y, x})),
      mechanism: "four_bar",
      kind: "motion",
    } as unknown as MotionTask;
    expect(same_task(motion, again)).toBe(true);
    expect(same_task(motion, {...motion, given: {side_lengths: [3, 5]}} as MotionTask)).toBe(false);
    expect(same_task(motion, {...motion, given: undefined} as MotionTask)).toBe(false);
    expect(same_task(motion, {...motion, poses: motion.poses.slice(1)})).toBe(false);
    expect(same_task(motion, pairs)).toBe(false);
    const bent = {...pose, derivatives: [{x: 1, y: 0, theta: 0.5}]};
    expect(
      same_task({...motion, poses: [bent]}, {...motion, poses: [{...bent, derivatives: [{theta: 0.5, y: 0, x: 1}]}]}),
    ).toBe(true);
    expect(same_task({...motion, poses: [bent]}, {...motion, poses: [pose]})).toBe(false);
  });
  it("are told in the first position that is passed exactly", () => {
    expect([motion, {...motion, freed_pose: 1}, {...motion, freed_pose: 3}, pairs].map(told_position)).toEqual([
      1, 2, 1, 1,
    ]);
  });
  it("count positions with their derivatives", () => {
    const poses: Pose[] = [{...pose, derivatives: [{x: 1, y: 0, theta: 0}]}, pose];
    expect(position_count(poses)).toBe(3);
    expect(pattern_of(poses)).toBe("PP-P");
    expect(pattern_of([])).toBe("");
  });
  it("keep what is given beside three positions, and drop it with any other number", () => {
    expect(
      with_task_poses(
        motion,
        motion.poses.map((p) => ({...p, y: 0})),
      ),
    ).toHaveProperty("given");
    expect(with_task_poses(motion, [...motion.poses, pose])).not.toHaveProperty("given");
    expect(with_task_poses(motion, [{...pose, derivatives: [{x: 1, y: 0, theta: 0}]}, pose])).toHaveProperty("given");
    expect(with_task_poses(pairs, [pose])).toBe(pairs);
  });
  it("have a size", () => {
    expect(
      diagonal_of([
        [0, 0],
        [3, 4],
        [1, 1],
      ]),
    ).toBe(5);
    expect(diagonal_of([])).toBe(0);
  });
});
