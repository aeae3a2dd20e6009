// Poses that a body passes as near as it can, among others that it passes exactly.
import type {Linkage} from "../../contract/messages";
import {with_task, type Problem} from "../../state/problem";
import {poses_of, type Pose} from "../../state/task";
import {with_poses} from "../kind_dispatch";
import {has_near, is_motion, type MotionTask} from "./task";

/** Two are always near or exact as they stand: fewer poses are no task. */
const fewest = 3;
type Nearness = keyof NonNullable<Pose["tolerance"]>;

export function can_be_near({task}: Problem): boolean {
  return is_motion(task) && task.poses.length >= fewest;
}
/** Which are, from 1. */
export function near_poses(task: MotionTask): number[] {
  return task.poses.flatMap(({near}, i) => (near ? [i + 1] : []));
}
/** A near pose has no directions, an exact one no tolerance. */
export function with_near(problem: Problem, pose: number, wanted: boolean): Problem {
  const [tolerance] = poses_of(problem.task).flatMap(({tolerance}) => tolerance ?? []),
    changed = poses_of(problem.task).map(({x, y, theta_deg, derivatives, ...nearness}, i): Pose => {
      if (i + 1 !== pose) return {x, y, theta_deg, ...(derivatives ? {derivatives} : {}), ...nearness};
      return wanted ? {x, y, theta_deg, near: true, ...(tolerance ? {tolerance} : {})} : {x, y, theta_deg};
    });
  const edited = with_poses(problem, changed);
  return has_near(edited.task as MotionTask) ? edited : without_nearness(edited);
}
/** What only tasks with near poses ask for. */
function without_nearness(problem: Problem): Problem {
  const {objective, ...options} = problem.options ?? {},
    {max_near_error: _, ...requirements} = problem.requirements ?? {};
  const kept = objective === undefined || objective === "near_error" ? options : {...options, objective};
  return {
    ...problem,
    ...(problem.options ? {options: kept} : {}),
    ...(problem.requirements ? {requirements} : {}),
  };
}
/** That of all near poses; nothing where they differ. */
export function near_tolerance(task: MotionTask, of: Nearness): number | null {
  const given = new Set(task.poses.flatMap(({near, tolerance}) => (near ? [tolerance?.[of] ?? null] : [])));
  return given.size === 1 ? [...given][0]! : null;
}
export function with_near_tolerance(problem: Problem, of: Nearness, value: number | null): Problem {
  const task = problem.task as MotionTask;
  return with_task(problem, {
    ...task,
    poses: task.poses.map((pose): Pose => {
      if (!pose.near) return pose;
      const {tolerance, ...rest} = pose,
        {[of]: _, ...other} = tolerance ?? {},
        changed = value ? {...other, [of]: value} : other;
      return Object.keys(changed).length ? {...rest, tolerance: changed} : rest;
    }),
  } as MotionTask);
}

/** How far the linkage in hand is off at each near pose. */
export interface Miss {
  pose: number;
  distance: number;
  angle_deg: number;
  outside: boolean;
}
export function misses_of(hand: Linkage | null): Miss[] {
  const near = hand?.near;
  if (!near) return [];
  const outside = new Set(near.outside);
  return near.at
    .filter((one) => one.near)
    .map(({pose, distance, angle_deg}) => ({pose, distance, angle_deg, outside: outside.has(pose)}));
}
