// A rigid body is turned: no linkage is sought, its attitude is shown in every representation.
import {is_sequence, read_orientation, read_vector, type Orientation} from "../../orientation/orientation";
import type {Vec3} from "../../sphere/vectors";
import type {Problem} from "../../state/problem";
import {is_object, type JsonObject} from "../../state/shape";
import {significant} from "../../texts/numbers";
import type {TaskKind} from "../kind";
import {is_attitude, type AttitudeTask} from "./task";

const upright = {axis: [0, 0, 1], angle_deg: 0} as const;
const first: AttitudeTask = {
  kind: "attitude",
  mechanism: "body",
  orientation: {euler_deg: [40, 50, 35], sequence: "zxz"},
  sequence: "zxz",
  turning: "intrinsic",
  vector: [1, 0, 0],
  from: {orientation: upright, translation: [0, 0, 0]},
  translation: [-60, 260, 90],
  rates_deg: [30, 10, 60],
};

function read(value: JsonObject): AttitudeTask | null {
  if (value.kind !== "attitude") return null;
  const orientation = read_orientation(value.orientation);
  if (!orientation) return null;
  const from = is_object(value.from) ? value.from : {},
    vector = (key: "vector" | "translation" | "rates_deg"): Vec3 => read_vector(value[key]) ?? first[key];
  return {
    kind: "attitude",
    mechanism: "body",
    orientation,
    sequence: is_sequence(value.sequence) ? value.sequence : first.sequence,
    turning: value.turning === "extrinsic" ? "extrinsic" : "intrinsic",
    vector: vector("vector"),
    from: {
      orientation: read_orientation(from.orientation) ?? upright,
      translation: read_vector(from.translation) ?? [0, 0, 0],
    },
    translation: vector("translation"),
    rates_deg: vector("rates_deg"),
  };
}
/** From the first of them to the last. */
function between(orientations: readonly Orientation[]): AttitudeTask {
  const from = {...first.from, orientation: orientations[0] ?? upright};
  return {...first, from, orientation: orientations.at(-1) ?? first.orientation};
}
function new_problem(): Problem {
  return {linkwright: 1, title: "", length_unit: "mm", task: first};
}

export const attitude_kind: TaskKind<AttitudeTask> = {
  name: "task.kind_attitude",
  without_linkages: true,
  is: is_attitude,
  read,
  orientations: ({from, orientation}) => [from.orientation, orientation],
  incompleteness: () => null,
  stops: () => 1,
  pattern: () => "",
  is_mixed: () => false,
  anchors: () => [],
  default_max_length: () => 1,
  map_of: () => "attitude",
  types: [],
  properties: {},
  requirements: {},
  objectives: {},
  moved: (task) => task,
  table: ({sequence, rates_deg}) => ({
    head: [...sequence].map((axis, k) => `ṫ${"₁₂₃"[k]} (${axis}) °/s`),
    rows: [rates_deg.map((rate) => significant(rate, 7))],
  }),
  texts: {"tab.map": "attitude.title"},
  beginnings: [
    {
      id: "attitude",
      name: "new.attitude",
      about: "new.attitude_about",
      make: new_problem,
      turned: {count: 2, task: between},
    },
  ],
};
