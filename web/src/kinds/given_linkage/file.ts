// Linkage files: what of a file is the linkage, its numbers one by one, and the file that the program reads.
import type {Point} from "../../contract/messages";
import type {Problem} from "../../state/problem";
import {is_finite, is_object, present, type JsonObject} from "../../state/shape";
import {is_linkage, mechanisms, type LinkageMechanism, type LinkageTask} from "./task";

const forms = ["pivots", "lengths", "axes", "angles_deg", "chain", "input"] as const;

/** The linkage of a file: bare numbers, without what was found out about it. Null: the file holds none. */
export function linkage_of_file(file: JsonObject): LinkageTask | null {
  const element = is_object(file.linkage) ? file.linkage : file;
  if (!forms.some((form) => is_object(element[form]))) return null;
  const mechanism = mechanisms.find((one) => one === (element.mechanism ?? "four_bar"));
  if (!mechanism) return null;
  const positions = {poses: element.poses ?? file.poses, orientations: file.orientations};
  return {kind: "linkage", mechanism, file: {mechanism, ...bare(element, mechanism), ...filled(positions)}};
}
function filled(lists: JsonObject): JsonObject {
  return Object.fromEntries(Object.entries(lists).filter(([, list]) => Array.isArray(list) && list.length > 0));
}
function bare(element: JsonObject, mechanism: LinkageMechanism): JsonObject {
  const {pivots, lengths, axes, angles_deg, chain, added, input, output} = element;
  if (mechanism === "six_bar") return {chain, added: is_list_of_objects(added) ? added.map(link_of) : added};
  if (mechanism === "spherical_four_bar") {
    if (axes) return {axes};
    return is_object(input) && is_object(output)
      ? {
          axes: {
            input_fixed: input.fixed_axis,
            input_moving: input.moving_axis,
            output_moving: output.moving_axis,
            output_fixed: output.fixed_axis,
          },
        }
      : {angles_deg};
  }
  if (pivots) return {pivots};
  if (is_object(input) && is_object(output)) {
    const {center_point: input_center, circle_point: input_circle} = input,
      {center_point: output_center, circle_point: output_circle} = output;
    if (input_center && input_circle && output_center && output_circle)
      return {pivots: {input_center, input_circle, output_center, output_circle}};
    return present({input, output}); // a slider: the engine says so
  }
  return {lengths};
}
function is_list_of_objects(value: unknown): value is JsonObject[] {
  return Array.isArray(value) && value.every(is_object);
}
function link_of({between, points}: JsonObject): JsonObject {
  return {between, points};
}

/** What `linkwright analyze` reads, with the page's own part. */
export function file_of({task, ...rest}: Problem): JsonObject {
  return is_linkage(task) ? {...rest, ...task.file} : {...rest, task};
}

// ---- its numbers ------------------------------------------------------------------------------------------------------

export type Path = readonly (string | number)[];
/** A line of numbers: a length, or the coordinates of a hinge. */
export interface Line {
  /** Names it among all, as `pivots.input_center`. */
  key: string;
  path: Path;
  /** One, or coordinates. */
  values: readonly number[];
}
function line(path: Path, value: unknown): Line[] {
  const values: unknown[] = Array.isArray(value) ? value : [value];
  return values.every(is_finite) && values.length > 0 ? [{key: path.join("."), path, values}] : [];
}
/** In the order of the file. */
export function lines_of({file}: LinkageTask): Line[] {
  const lines = forms.flatMap((form) => {
    const part = file[form];
    return is_object(part) && form !== "input"
      ? Object.entries(part).flatMap(([name, of]) => line([form, name], of))
      : [];
  });
  const added = is_list_of_objects(file.added) ? file.added : [];
  return [
    ...lines.filter(({path}) => path[1] !== "elbow"),
    ...added.flatMap(({points}, i) =>
      (Array.isArray(points) ? points : []).flatMap((point, k) => line(["added", i, "points", k], point)),
    ),
  ];
}
/** With another number, the k-th of a line. */
export function with_number(task: LinkageTask, {path, values}: Line, k: number, value: number): LinkageTask {
  const changed = values.map((old, i) => (i === k ? value : old));
  return {...task, file: replaced(task.file, path, changed.length === 1 ? changed[0] : changed) as JsonObject};
}
/** With both coordinates of a line's point. */
export function with_point(task: LinkageTask, {path}: Line, point: Point): LinkageTask {
  return {...task, file: replaced(task.file, path, point) as JsonObject};
}
function replaced(in_value: unknown, [step, ...rest]: Path, value: unknown): unknown {
  if (step === undefined) return value;
  if (Array.isArray(in_value)) return in_value.map((item, i) => (i === step ? replaced(item, rest, value) : item));
  return {...(in_value as JsonObject), [step]: replaced((in_value as JsonObject)[step], rest, value)};
}

/** Between which points it lies, as far as its numbers alone tell. */
export function reach_of(task: LinkageTask): Point[] {
  const lines = lines_of(task),
    points = lines.flatMap(({values: [x, y], values}): Point[] => (values.length === 2 ? [[x!, y!]] : []));
  if (points.length > 1) return points;
  const {lengths} = task.file;
  if (task.mechanism === "four_bar" && is_object(lengths)) {
    const {ground, input, output} = lengths;
    if (is_finite(ground) && is_finite(input) && is_finite(output))
      return [
        [-input, -Math.max(input, output)],
        [ground + output, Math.max(input, output)],
      ];
  }
  return [
    [-1, -1],
    [1, 1],
  ];
}
