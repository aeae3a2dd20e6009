// What the page and the program write, told apart when it comes back: results and some linkages hold a task, other
// linkages are one themselves, drawings and tables hold none.
import {linkage_types} from "../contract/messages";
import {unused_name} from "../state/pins";
import type {Pin} from "../state/problem";
import {read_view} from "../state/problem_shape";
import {is_finite, is_object, is_pair, present, type JsonObject} from "../state/shape";
import {poses_of, position_count} from "../state/task";
import {filed_pivots, read_task, task_of_file, task_of_poses} from "../kinds/kind_dispatch";

export type Told =
  | {kind: "problem" | "result" | "linkage" | "lone_linkage"; text: string} // of the problem in it
  | {kind: "drawing" | "table" | "film" | "solid" | "other"};

const starts: readonly (readonly [RegExp, "drawing" | "film" | "solid" | "other"])[] = [
  [
    /^\x89PNG|^\xff\xd8\xff|^RIFF....WEBP|^(\s*999\s.*)?\s*0\r?\n\s*SECTION|^(\ufeff?\s*<\?xml[^>]*>\s*(<!--[^]*?-->\s*)*)?<svg/,
    "drawing",
  ],
  [/^GIF8|^\x1a\x45\xdf\xa3|^....ftyp/s, "film"],
  [/^\s*ISO-10303-21|^solid\s/, "solid"],
  [/^%PDF-|^\xd0\xcf\x11\xe0/, "other"], // PDF, and the office's files of old
];
const endings = {
  drawing: /\.(dxf|svg|png|jpe?g|webp)$/i,
  table: /\.(csv|tsv|txt)$/i,
  film: /\.(gif|mp4|webm)$/i,
  solid: /\.(step|stp|stl|3mf|igs|iges)$/i,
  other: /\.(pdf|xlsx?|ods|docx?|zip)$/i,
} as const;

/** What a file is. `bytes` are the first of it, one character each; `text` is null where it is no text. */
export function told(name: string, bytes: string, text: string | null): Told {
  const start = starts.find(([pattern]) => pattern.test(bytes));
  if (start) return {kind: start[1]};
  for (const kind of ["drawing", "table", "film", "solid", "other"] as const)
    if (endings[kind].test(name) && !/^\s*\{/.test(bytes)) return {kind};
  return of_text(text ?? "");
}
function of_text(text: string): Told {
  const file = /"(linkages?|lengths|pivots|axes|angles_deg|chain|input)"\s*:/.test(text) ? parsed(text) : null;
  if (!file || (file.task !== undefined && file.linkage === undefined)) return {kind: "problem", text};
  if (is_object(file.problem) && Array.isArray(file.linkages))
    return {kind: "result", text: JSON.stringify(problem_of_result(file.problem, file.linkages))};
  return (
    (is_object(file.linkage) && of_linkage(file, file.linkage)) || of_lone_linkage(file) || {kind: "problem", text}
  );
}
function parsed(text: string): JsonObject | null {
  try {
    const value: unknown = JSON.parse(without_comments(text));
    return is_object(value) ? value : null;
  } catch {
    return null;
  }
}

/** The best one in hand; where there are several, all are pinned. */
function problem_of_result(problem: JsonObject, linkages: readonly unknown[]): JsonObject {
  const view = read_view(problem.view),
    pins: Pin[] = [...(view.pins ?? [])];
  const found = linkages.filter(is_object),
    picked = found.map(tau_of).find((tau) => tau !== null);
  if (found.length > 1)
    for (const linkage of found) {
      const pin = pin_of(linkage, problem.task);
      if (pin) pins.push({...pin, name: unused_name(pins, "A")});
    }
  return {...problem, view: {...view, ...(picked ? {picked} : {}), ...(pins.length ? {pins} : {})}};
}
function tau_of({input, output}: JsonObject): [number, number] | null {
  return is_object(input) && is_object(output) && is_finite(input.coordinate) && is_finite(output.coordinate)
    ? [input.coordinate, output.coordinate]
    : null;
}
function pin_of(linkage: JsonObject, of: unknown): Pin | null {
  const tau = tau_of(linkage),
    task = read_task(of),
    type = linkage_types.find((name) => name === linkage.type);
  if (!tau || !task || !type) return null;
  const {min_transmission_angle_deg, link_ratio, lengths} = linkage,
    input = linkage.input as JsonObject,
    output = linkage.output as JsonObject;
  const all =
    is_object(lengths) && Object.values(lengths).every(is_finite)
      ? (lengths as unknown as NonNullable<Pin["lengths"]>)
      : null;
  const number = (value: unknown) => (is_finite(value) ? value : null),
    point = (value: unknown) => (is_pair(value) ? value : null);
  return {
    name: "A",
    tau,
    task,
    type,
    min_transmission_angle_deg: number(min_transmission_angle_deg),
    link_ratio: number(link_ratio),
    longest: all && Object.values(all).reduce((longest, length) => Math.max(longest, length), 0),
    lengths: all,
    pivots: filed_pivots(task, linkage) ?? {
      input_center: point(input.center_point),
      input_circle: point(input.circle_point),
      output_center: point(output.center_point),
      output_circle: point(output.circle_point),
    },
  };
}

/** Comments stand on lines of their own. */
export function without_comments(text: string): string {
  return text.replace(/^\s*\/\/.*$/gm, "");
}

function text_of(value: unknown): string {
  return typeof value === "string" ? value : "";
}
function of_lone_linkage(file: JsonObject): Told | null {
  const task = task_of_file(file),
    {linkwright = 1, title, length_unit, view} = file;
  const problem = {linkwright, title: text_of(title), length_unit: text_of(length_unit), task, ...present({view})};
  return task && {kind: "lone_linkage", text: JSON.stringify(problem)};
}
/** A four-bar's positions are a task where they are all that was asked: four or five poses. */
function of_linkage({title, length_unit, poses}: JsonObject, linkage: JsonObject): Told | null {
  const task = task_of_poses(poses),
    tau = tau_of(linkage);
  const count = task ? position_count(poses_of(task)) : 0;
  if (linkage.mechanism !== task?.mechanism || linkage.poses !== undefined || !tau || count < 4 || count > 5)
    return null;
  return {
    kind: "linkage",
    text: JSON.stringify({
      linkwright: 1,
      title: text_of(title),
      length_unit: text_of(length_unit),
      task,
      view: {picked: tau},
    }),
  };
}
