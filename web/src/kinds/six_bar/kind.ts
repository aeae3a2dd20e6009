// A body is guided through four poses by a six-bar: a chain of three links and two links that are added to it.
import type {Point} from "../../contract/messages";
import {body_color, joint_color, joint_words, length_words} from "./names";
import {is_six_bar, type Chain, type SixBarTask} from "./task";
import type {Problem} from "../../state/problem";
import {is_number, is_object, is_pair, read_list, type JsonObject} from "../../state/shape";
import {pattern_of, poses_of, position_count, type Pose} from "../../state/task";
import type {TaskKind} from "../kind";
import {planar_objectives, planar_properties, planar_requirements, planar_types} from "../planar";
import {chain_making} from "../../analyses/tolerances/making";
import {row_of} from "./chain";
import {default_max_length, new_problem as new_motion, pose_table, read_poses} from "../motion/kind";

function read_chain(value: unknown): Chain | null {
  if (!is_object(value) || !is_pair(value.a) || !is_pair(value.b) || !is_pair(value.d)) return null;
  const elbow = read_list(value.elbow, (sign) => (is_number(sign) ? sign : null), 4);
  return {a: value.a, b: value.b, d: value.d, ...(elbow ? {elbow} : {})};
}
function is_two<T>(list: readonly T[] | null): list is readonly [T, T] {
  return list?.length === 2;
}
function read(value: JsonObject): SixBarTask | null {
  const poses = read_poses(value.poses),
    added = read_list(value.added, (bodies) => (typeof bodies === "string" ? bodies.slice(0, 10) : null), 2);
  if (value.kind !== "motion" || value.mechanism !== "six_bar" || !poses || !is_two(added)) return null;
  const chain = read_chain(value.chain);
  return {kind: "motion", mechanism: "six_bar", poses, added, ...(chain ? {chain} : {})};
}
function points_of(chain: Chain | undefined): Point[] {
  return chain ? [chain.a, chain.b, chain.d] : [];
}
/** Its chain is to be sought. */
function six_bar_task(poses: readonly Pose[]): SixBarTask {
  return {kind: "motion", mechanism: "six_bar", poses, added: ["0-2", "0-3"]};
}
function new_problem(): Problem {
  const motion = new_motion(),
    chain: Chain = {a: [-145, 268], b: [16, 205], d: [75, -71]};
  return {...motion, task: {...six_bar_task(poses_of(motion.task)), chain} as SixBarTask};
}

export const six_bar_kind: TaskKind<SixBarTask> = {
  name: "task.kind_six_bar",
  is: is_six_bar,
  read,
  with_poses: (task, poses) => ({...task, poses}),
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
  properties: planar_properties,
  types: planar_types,
  requirements: planar_requirements,
  objectives: planar_objectives,
  analysed: {tolerances: chain_making},
  moved: (task, point) =>
    task.chain
      ? {...task, chain: {...task.chain, a: point(task.chain.a), b: point(task.chain.b), d: point(task.chain.d)}}
      : task,
  table: ({poses}, unit) => pose_table(poses, unit),
  beginnings: [
    {
      id: "six_bar",
      name: "new.six_bar",
      about: "new.six_bar_about",
      make: new_problem,
      through: {count: 4, task: six_bar_task},
    },
  ],
  make_up({added}) {
    const row = row_of(added);
    return row && `six_bar.${row.topology}`;
  },
  called: ({six_bar}) => (six_bar ? `six_bar.${six_bar.topology}` : null),
  term: ({six_bar}) => (six_bar ? (six_bar.topology === "watt_1" ? "watt_1" : "stephenson") : null),
  lengths: ({six_bar}) =>
    six_bar?.lengths.map(({name, length}) => ({
      key: name,
      name: length_words(name),
      length,
      color: name.startsWith("0") ? null : body_color(Number(name[0])),
    })) ?? null,
  joints: ({six_bar}) =>
    six_bar?.joints.map(({name, at, ground}, i) => ({
      key: `joint_${name}`,
      name: joint_words(six_bar, i),
      at,
      on_ground: ground,
      color: joint_color(i),
    })) ?? null,
  texts: {
    "chip.four_bars": "chip.six_bars",
    "state.none_defect_free": "six_bar.none_defect_free",
    "region.driver_axis": "six_bar.axis_4",
    "region.other_axis": "six_bar.axis_5",
  },
};
