// A new task, with what it has in common with the one in hand: the positions or orientations of a guided body.
import {without_blocks} from "../analyses/analysis_dispatch";
import {examples} from "../gallery/gallery";
import type {Orientation} from "../orientation/orientation";
import type {Problem} from "../state/problem";
import {poses_of, position_count, same_value, type Pose, type Task} from "../state/task";
import {length_step, proposed} from "../task_panel/poses";
import type {Beginning} from "../kinds/kind";
import {anchors_of, has_linkages, kind_of, task_kinds, with_other_task} from "../kinds/kind_dispatch";

export const beginnings = task_kinds.flatMap((kind) => kind.beginnings);

/** What a beginning can take over: so many of so many that there are; it takes `wanted`. */
export interface Common {
  what: "positions" | "orientations";
  there: number;
  wanted: number;
}
export function common_with(task: Task, {through, turned}: Beginning): Common | null {
  const positions = poses_of(task).length,
    orientations = orientations_of(task).length;
  if (through && positions) return {what: "positions", there: positions, wanted: through.count};
  return turned && orientations ? {what: "orientations", there: orientations, wanted: turned.count} : null;
}
function orientations_of(task: Task): readonly Orientation[] {
  return kind_of(task).orientations?.(task) ?? [];
}
/** The beginning nearest to a task: of its kind, with as many positions. */
export function beginning_of(task: Task): Beginning | undefined {
  const own = kind_of(task).beginnings;
  return own.find(({through, turned}) => (through ?? turned)?.count === count_of(task)) ?? own[0];
}
function count_of(task: Task): number {
  return position_count(poses_of(task)) || orientations_of(task).length;
}
/** Whether the positions or orientations are the user's: no example or beginning has them. */
export function has_own(task: Task): boolean {
  const shown = [...examples.map(({problem}) => problem.task), ...beginnings.map((beginning) => beginning.make().task)];
  const same = (other: Task) =>
    same_value(poses_of(task), poses_of(other)) && same_value(orientations_of(task), orientations_of(other));
  return !shown.some(same);
}

/** The problem in hand with the kind of task that begins so: positions or orientations stay, and what is required of any
 *  linkage. What a beginning needs more of is added, what it has no room for is left out. */
export function going_on(problem: Problem, beginning: Beginning): Problem {
  const {task} = problem,
    common = common_with(task, beginning),
    as_new = beginning.make();
  if (!common) return as_new;
  const kept = {...as_new, ...with_other_task(problem, other_task(task, beginning))};
  if (has_linkages(kept.task)) return kept;
  const {requirements: _, options: __, ...bare} = without_blocks(kept);
  return bare;
}
function other_task(task: Task, beginning: Beginning): Task {
  const {through, turned} = beginning;
  if (beginning_of(task) === beginning && count_of(task) === (through ?? turned)?.count) return task;
  return poses_of(task).length && through
    ? through.task(fitting_poses(task, through.count))
    : turned!.task(orientations_of(task).slice(0, turned!.count));
}
/** As many as wanted: as they are where they are as many, derivatives counted; else without derivatives, which not all
 *  kinds know. */
function fitting_poses(task: Task, wanted: number): readonly Pose[] {
  const poses = poses_of(task);
  if (poses.length === wanted && position_count(poses) === wanted) return poses;
  const plain = poses.slice(0, wanted).map(({x, y, theta_deg}): Pose => ({x, y, theta_deg}));
  while (plain.length < wanted) plain.push(proposed(plain, length_step(anchors_of(task))));
  return plain;
}
