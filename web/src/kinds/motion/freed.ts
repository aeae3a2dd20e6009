// Of five positions one may be freed: the others are a task of four, whose map says what the exactness of all five costs.
import {with_task, type Problem} from "../../state/problem";
import {position_count} from "../../state/task";
import {is_motion, type MotionTask} from "./task";

/** Poses that can be freed, from 1; none where there are not five positions. */
export function relaxable({task}: Problem): number[] {
  if (!is_motion(task) || position_count(task.poses) !== 5) return [];
  return task.poses.flatMap((pose, i) => (pose.derivatives?.length ? [] : [i + 1]));
}
export function relaxed_pose_of({task}: Problem): number | null {
  return (task as MotionTask).freed_pose ?? null;
}
export function with_relaxed_pose(problem: Problem, pose: number | null): Problem {
  const {freed_pose: _, ...task} = problem.task as MotionTask;
  return with_task(problem, pose === null ? task : {...task, freed_pose: pose});
}
