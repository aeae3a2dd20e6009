// A body is guided through four poses by a six-bar: a chain of three links and two links that are added to it.
import type {Chain, Point} from "../../engine/protocol";
import type {Problem} from "../../state/problem";
import {is_number, is_object, is_pair, read_list, type Object} from "../../state/shape";
import {pattern_of, position_count, type SixBarTask} from "../../state/task";
import type {TaskKind} from "../kind";
import {row_of} from "./chain";
import {default_max_length, new_problem as new_motion, pose_table, read_poses} from "../motion/kind";

function read_chain(value: unknown): Chain | null {
  if (!is_object(value) || !is_pair(value.a) || !is_pair(value.b) || !is_pair(value.d)) return null;
  const elbow = read_list(value.elbow, (sign) => (is_number(sign) ? sign : null), 4);
  return {a: value.a, b: value.b, d: value.d, ...(elbow ? {elbow} : {})};
}
function read(value: Object): SixBarTask | null {
  const poses = read_poses(value.poses),
    added = read_list(value.added, (bodies) => (typeof bodies === "string" ? bodies.slice(0, 10) : null), 2);
  if (value.kind !== "motion" || value.mechanism !== "six_bar" || !poses || added?.length !== 2) return null;
  const chain = read_chain(value.chain);
  return {kind: "motion", mechanism: "six_bar", poses, added: [added[0], added[1]], ...(chain ? {chain} : {})};
}
function points_of(chain: Chain | undefined): Point[] {
  return chain ? [chain.a, chain.b, chain.d] : [];
}
function new_problem(): Problem {
  const motion = new_motion(),
    poses = "poses" in motion.task ? motion.task.poses : [];
  return {
    ...motion,
    task: {
      kind: "motion",
      mechanism: "six_bar",
      poses,
      chain: {a: [-145, 268], b: [16, 205], d: [75, -71]},
      added: ["0-2", "0-3"],
    },
  };
}

export const six_bar_kind: TaskKind<SixBarTask> = {
  name: "task.kind_six_bar",
  is: (task): task is SixBarTask => task.mechanism === "six_bar",
  read,
  incompleteness({poses, chain}) {
    const n = position_count(poses);
    if (n !== 4) return {state: n === 0 ? "empty" : n < 4 ? "too_few" : "too_many", text: "state.four_for_six_bar", n};
    return chain ? null : {state: "no_chain", text: "state.no_chain", n};
  },
  stops: ({poses}) => poses.length,
  pattern: ({poses}) => pattern_of(poses),
  is_mixed: () => false,
  anchors: ({poses, chain}) => [...poses.map((pose): Point => [pose.x, pose.y]), ...points_of(chain)],
  default_max_length,
  map_of: ({added}) => `six_bar ${added.join(" ")}`,
  moved: (task, point) =>
    task.chain
      ? {...task, chain: {...task.chain, a: point(task.chain.a), b: point(task.chain.b), d: point(task.chain.d)}}
      : task,
  table: ({poses}, unit) => pose_table(poses, unit),
  beginnings: [{id: "six_bar", name: "new.six_bar", about: "new.six_bar_about", make: new_problem}],
  make_up({added}) {
    const row = row_of(added);
    return row && `six_bar.${row.topology}`;
  },
  texts: {
    "chip.four_bars": "chip.six_bars",
    "state.none_defect_free": "six_bar.none_defect_free",
    "region.driver_axis": "six_bar.axis_4",
    "region.other_axis": "six_bar.axis_5",
  },
};
