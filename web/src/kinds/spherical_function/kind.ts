// The output link of a spherical four-bar turns with its input link as prescribed, about another axis through the centre.
import {is_number, type JsonObject} from "../../state/shape";
import type {Problem} from "../../state/problem";
import {
  angles_kind,
  max_structural_error_deg,
  position_count_of,
  read_angles,
  structural_error,
} from "../function/kind";
import type {TaskKind} from "../kind";
import {cone_texts, spherical_kind} from "../spherical/kind";
import {is_spherical_function, type SphericalFunctionTask} from "./task";

function read(value: JsonObject): SphericalFunctionTask | null {
  const angles = read_angles(value),
    {ground_angle_deg} = value;
  if (value.kind !== "function" || value.mechanism !== "spherical_four_bar") return null;
  if (!angles || !is_number(ground_angle_deg)) return null;
  return {kind: "function", mechanism: "spherical_four_bar", ...angles, ground_angle_deg};
}
function new_problem(): Problem {
  const task: SphericalFunctionTask = {
    kind: "function",
    mechanism: "spherical_four_bar",
    pairs: [
      {input_deg: 0, output_deg: 0},
      {input_deg: 25, output_deg: 14},
      {input_deg: 50, output_deg: 34},
      {input_deg: 75, output_deg: 62},
    ],
    ground_angle_deg: 60,
  };
  return {linkwright: 1, title: "", task, requirements: {min_transmission_angle_deg: 30}};
}
const {without_lengths, anchors, default_max_length, types, requirements, analysed, kept_pivots, filed_pivots} =
  spherical_kind;

export const spherical_function_kind: TaskKind<SphericalFunctionTask> = {
  ...angles_kind,
  name: "task.kind_spherical_function",
  without_lengths,
  is: is_spherical_function,
  read,
  anchors: anchors as TaskKind["anchors"],
  default_max_length,
  map_of: (task) => `spherical function ${position_count_of(task)} ${task.free?.number ?? ""}`,
  moved: (task) => task,
  properties: {...(spherical_kind as unknown as TaskKind).properties, max_structural_error_deg},
  types,
  requirements,
  analysed,
  objectives: {structural_error, ...(spherical_kind as unknown as TaskKind).objectives},
  texts: {
    ...angles_kind.texts,
    ...cone_texts,
    "notice.every_axis": "function.every_point",
    "notice.no_pair": "spherical_function.no_pair",
    "notice.spherical_branch": "spherical_function.branch",
    "notice.spherical_circuit": "spherical_function.circuit",
    "notice.spherical_order": "spherical_function.order",
  },
  beginnings: [
    {
      id: "spherical_function",
      name: "new.spherical_function",
      about: "new.spherical_function_about",
      make: new_problem,
    },
  ],
  kept_pivots,
  filed_pivots,
};
