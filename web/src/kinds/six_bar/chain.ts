// The chain that guides the body, and the two links that are added to it.
import type {Box, Point} from "../../contract/messages";
import type {Topology} from "./replies";
import {is_six_bar, type Chain, type SixBarTask} from "./task";
import {body_point, outline_of, placed, with_task, type Problem} from "../../state/problem";
import {box_of, poses_of} from "../../state/task";

export const hinges = ["a", "b", "d"] as const;
export type Hinge = (typeof hinges)[number];

/** The eleven ways to add two links to a chain whose first body drives its last: the library's order (six_bar_task.hpp). */
export const rows: readonly {added: readonly [string, string]; topology: Topology}[] = [
  {added: ["0-2", "0-3"], topology: "stephenson_3"},
  {added: ["0-2", "1-3"], topology: "watt_1"},
  {added: ["0-2", "4-3"], topology: "watt_1"},
  {added: ["1-3", "0-3"], topology: "stephenson_2"},
  {added: ["1-3", "0-2"], topology: "watt_1"},
  {added: ["1-3", "0-4"], topology: "watt_1"},
  {added: ["0-3", "0-2"], topology: "stephenson_3"},
  {added: ["0-3", "1-3"], topology: "stephenson_2"},
  {added: ["0-3", "1-4"], topology: "stephenson_1"},
  {added: ["0-3", "2-4"], topology: "stephenson_2"},
  {added: ["0-3", "0-3"], topology: "stephenson_3"},
];
/** Whichever body of a pair comes first. */
export function row_of(added: readonly [string, string]) {
  const sorted = (pair: string) => [...pair].sort().join("");
  return rows.find((row) => row.added.every((pair, i) => sorted(pair) === sorted(added[i]!))) ?? null;
}

export function six_bar_task({task}: Problem): SixBarTask | null {
  return is_six_bar(task) ? task : null;
}
export function with_six_bar(problem: Problem, change: Partial<SixBarTask>): Problem {
  const task = six_bar_task(problem);
  return task ? with_task(problem, {...task, ...change}) : problem;
}

/** +1 where b lies to the left of the line from a to d. */
export function elbow_of({a, b, d}: Chain): 1 | -1 {
  return (d[0] - a[0]) * (b[1] - a[1]) - (d[1] - a[1]) * (b[0] - a[0]) < 0 ? -1 : 1;
}
/** A hinge elsewhere; where b changes sides, the elbows of all positions do. */
export function with_hinge(chain: Chain, hinge: Hinge, at: Point): Chain {
  const moved = {...chain, [hinge]: at};
  return chain.elbow && elbow_of(moved) !== elbow_of(chain)
    ? {...moved, elbow: chain.elbow.map((sign) => -sign)}
    : moved;
}
/** Of each position, the elbow: the file's, or that of position 1. */
export function elbows(chain: Chain): number[] {
  return Array.from({length: 4}, (_, i) => chain.elbow?.[i] || elbow_of(chain));
}
/** The chain folded the other way in a position after the first. */
export function with_other_elbow(chain: Chain, position: number): Chain {
  const signs = elbows(chain).map((sign, i) => (i === position ? -sign : sign));
  const {elbow: _, ...bare} = chain;
  return signs.every((sign) => sign === signs[0]) ? bare : {...bare, elbow: signs};
}

/** The guided body's hinge in every position: it belongs to the body. */
export function guided_hinges(problem: Problem): Point[] {
  const poses = poses_of(problem.task),
    chain = six_bar_task(problem)?.chain;
  return chain ? poses.map((pose) => placed(body_point(chain.d, poses[0]!), pose)) : [];
}

/** Where hinges are looked for if nothing is said: around the body's positions, with as much room again. */
export function default_box(problem: Problem): Box {
  const corners = poses_of(problem.task).flatMap((pose) => outline_of(problem).map((p) => placed(p, pose)));
  const {x, y} = box_of(
      corners.length
        ? corners
        : [
            [0, 0],
            [100, 100],
          ],
    ),
    room = Math.max(x[1] - x[0], y[1] - y[0]) / 2;
  const tidy = (value: number) => Number(value.toPrecision(2));
  return {x: [tidy(x[0] - room), tidy(x[1] + room)], y: [tidy(y[0] - room), tidy(y[1] + room)]};
}
