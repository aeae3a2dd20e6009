// A linkage that is there already is driven, looked at and taken away, as one that was found.
import {is_object, type JsonObject} from "../../state/shape";
import {significant} from "../../texts/numbers";
import type {Beginning, TaskKind} from "../kind";
import {planar_types} from "../planar";
import {line_words} from "./line_words";
import {file_of, linkage_of_file, lines_of, reach_of} from "./file";
import {is_linkage, type LinkageMechanism, type LinkageTask} from "./task";

const beginning: Beginning = {
  id: "linkage",
  name: "new.linkage",
  about: "new.linkage_about",
  make: () => ({
    linkwright: 1,
    title: "",
    length_unit: "mm",
    task: {
      kind: "linkage",
      mechanism: "four_bar",
      file: {
        mechanism: "four_bar",
        pivots: {
          input_fixed: [0, 0],
          input_moving: [-20, 35],
          output_moving: [60, 85],
          output_fixed: [100, 0],
          point: [25, 110],
        },
      },
    } as LinkageTask,
  }),
};

/** One to each way of putting linkages together. */
export function linkage_kind(mechanism: LinkageMechanism): TaskKind<LinkageTask> {
  return {
    name: `task.kind_linkage_${mechanism}`,
    gives_linkage: true,
    ...(mechanism === "spherical_four_bar" ? {without_lengths: true as const} : {}),
    keeps_form: true,
    is: (task): task is LinkageTask => is_linkage(task) && task.mechanism === mechanism,
    read(value: JsonObject) {
      if (value.kind !== "linkage" || value.mechanism !== mechanism || !is_object(value.file)) return null;
      return {kind: "linkage", mechanism, file: value.file};
    },
    of_file(file) {
      const task = linkage_of_file(file);
      return task?.mechanism === mechanism ? task : null;
    },
    filed: file_of,
    incompleteness: () => null,
    stops: ({file: {poses, orientations}}) => [poses, orientations].find(Array.isArray)?.length ?? 1,
    pattern: () => "",
    is_mixed: () => false,
    anchors: reach_of,
    default_max_length: () => 1,
    map_of: () => "linkage",
    types: planar_types,
    properties: {},
    requirements: {},
    objectives: {},
    moved: (task) => task,
    table: (task) => ({
      head: ["", "", "", ""],
      rows: lines_of(task).map((line) => {
        const [x = "", y = "", z = ""] = line.values.map((value) => significant(value, 7));
        return [line_words(line, task), x, y, z];
      }),
    }),
    texts: {
      "num.min_task_short": "linkage.min_transmission",
      "tab.map": "linkage.drawing",
      "export.json_inside": mechanism === "spherical_four_bar" ? "spherical.json_inside" : "export.json_inside",
    },
    beginnings: mechanism === "four_bar" ? [beginning] : [],
  };
}
