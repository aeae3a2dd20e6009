// What comes from outside (a link, a file, the browser's store) as a problem, or nothing. The engine says what is wrong
// with a task; the view, which it keeps and never reads, is looked through here: what does not fit is left out.
import {read_blocks} from "../analyses/analysis_dispatch";
import {linkage_types, type Pivot, type Point, type TauPair} from "../contract/messages";
import {objective_descriptions, read_task, requirement_descriptions, task_of_poses} from "../kinds/kind_dispatch";
import type {RequirementDescription} from "../kinds/kind";
import {unused_name} from "./pins";
import {most_pins, type Background, type Pin, type Problem, type SolidBody, type View} from "./problem";
import {is_finite, is_number, is_object, is_pair, read_list, type JsonObject} from "./shape";

const most_points = 10_000,
  most_pivots = 20,
  longest_name = 100,
  longest_text = 10_000;

function pairs(value: unknown): Point[] | undefined {
  return read_list(value, (item) => (is_pair(item) ? item : null), most_points) ?? undefined;
}

/** A pin has the name that its user gave it; all its numbers are looked at, name and note are text. */
function read_pin(value: unknown): Pin | null {
  if (!is_object(value) || typeof value.name !== "string" || value.name.trim() === "" || !is_pair(value.tau))
    return null;
  const task = value.task === undefined ? task_of_poses(value.poses) : read_task(value.task); // pins used to have poses
  const type = linkage_types.find((name) => name === value.type);
  if (!task || !type) return null;
  const pivots = is_object(value.pivots) ? Object.entries(value.pivots).slice(0, most_pivots) : [];
  const number = (key: string) => (is_finite(value[key]) ? value[key] : null);
  return {
    name: value.name.trim().slice(0, longest_name),
    note: typeof value.note === "string" ? value.note.slice(0, longest_text) : undefined,
    tau: value.tau as TauPair,
    place: is_pair(value.place) ? value.place : undefined,
    task,
    shown: value.shown === true ? true : undefined,
    type,
    min_transmission_angle_deg: number("min_transmission_angle_deg"),
    link_ratio: number("link_ratio"),
    longest: number("longest"),
    lengths: read_lengths(value.lengths),
    pivots: Object.fromEntries(pivots.map(([name, at]) => [name, read_pivot(at)])),
  };
}
/** However far away: it is what the engine found. */
function read_pivot(value: unknown): Pivot | null {
  if (!Array.isArray(value) || (value.length !== 2 && value.length !== 3)) return null;
  return value.every(is_finite) ? (value as unknown as Pivot) : null;
}
function read_lengths(value: unknown): Pin["lengths"] {
  if (!is_object(value)) return null;
  const {ground, input, coupler, output} = value;
  return is_finite(ground) && is_finite(input) && is_finite(coupler) && is_finite(output)
    ? {ground, input, coupler, output}
    : null;
}
function read_pins(value: unknown): Pin[] | undefined {
  if (!Array.isArray(value)) return undefined;
  const pins: Pin[] = [];
  for (const pin of value.slice(0, most_pins).map(read_pin))
    if (pin) pins.push({...pin, name: unused_name(pins, pin.name)});
  return pins;
}
function read_background(value: unknown): Background | undefined {
  if (
    !is_object(value) ||
    typeof value.image !== "string" ||
    !/^data:image\/(png|jpeg|webp|gif);base64,[A-Za-z0-9+/=]+$/.test(value.image)
  )
    return undefined;
  const {image, x, y, width, aspect} = value;
  if (!is_number(x) || !is_number(y) || !is_number(width) || !is_number(aspect) || width <= 0 || aspect <= 0)
    return undefined;
  const opacity = is_number(value.opacity) && value.opacity >= 0 && value.opacity <= 1 ? {opacity: value.opacity} : {};
  const angle = is_number(value.angle_deg) && Math.abs(value.angle_deg) <= 360 ? {angle_deg: value.angle_deg} : {};
  return {
    ...{image, x, y, width, aspect, ...opacity, ...angle},
    ...(value.hidden === true ? {hidden: true} : {}),
    ...(value.locked === true ? {locked: true} : {}),
  };
}

const simple_bodies = ["triad", "wing", "dish", "box", "craft"] as const;
function read_body(value: unknown): SolidBody | undefined {
  if (!is_object(value)) return undefined;
  const {shape, name, corners} = value,
    simple = simple_bodies.find((one) => one === shape);
  if (simple) return {shape: simple};
  if (shape !== "own" || typeof name !== "string" || typeof corners !== "string") return undefined;
  if (!/^[A-Za-z0-9+/]*={0,2}$/.test(corners)) return undefined;
  return {shape, name: name.slice(0, longest_name), corners};
}

/** The workbench's part of a file, as far as it is one. */
export function read_view(value: unknown): View {
  if (!is_object(value)) return {};
  const outline = pairs(value.outline),
    background = read_background(value.background);
  const view: {[K in keyof Required<View>]: View[K]} = {
    outline: outline && outline.length >= 3 ? outline : undefined,
    background,
    body: read_body(value.body),
    picked: is_pair(value.picked) ? value.picked : undefined,
    pins: read_pins(value.pins),
    traced: pairs(value.traced),
    order: Number.isInteger(value.order) && Math.abs(value.order as number) < 1e6 ? (value.order as number) : undefined,
  };
  return Object.fromEntries(Object.entries(view).filter(([, part]) => part !== undefined)) as View;
}

// ---- requirements and options ---------------------------------------------------------------------------------------

type Check = (value: unknown) => boolean;
const is_flag: Check = (value) => typeof value === "boolean";
const is_one_of =
  (names: readonly string[]): Check =>
  (value) =>
    names.includes(value as string);
const is_between =
  (low: number, high: number): Check =>
  (value) =>
    is_number(value) && value >= low && value <= high;
const is_box: Check = (value) => is_object(value) && is_pair(value.x) && is_pair(value.y);
const or_null =
  (check: Check): Check =>
  (value) =>
    value === null || check(value);

function requirement_check(described: RequirementDescription): Check {
  switch (described.control) {
    case "types":
      return or_null((value) => Array.isArray(value) && value.every(is_one_of(linkage_types)));
    case "no_defects":
      return is_flag;
    case "transmission_angle":
      return or_null(is_between(0, 90));
    case "limit":
      return or_null(is_between(described.from, described.quantity === "percent" ? 1 : 1e12));
    case "box":
      return or_null(is_box);
    case "own":
      return or_null(described.is_value);
  }
}
const requirement_checks: Record<string, Check> = {
  ...Object.fromEntries(
    Object.entries(requirement_descriptions).map(([key, described]) => [key, requirement_check(described)]),
  ),
  respect_direction: is_flag,
};
const option_checks: Record<string, Check> = {
  region_samples: is_between(8, 20_000),
  spacing: is_one_of(["coordinate", "arc_length"]),
  objective: is_one_of(Object.keys(objective_descriptions)),
  best: is_between(0, 1000),
  window: or_null(Array.isArray),
  box: or_null(is_box),
  seed: is_between(0, 999_999_999),
  effort: is_between(1, 10_000_000),
  deviation: or_null(is_between(0, 1e12)),
  stroke: or_null(is_between(0, 1e12)),
  measure: is_one_of(["tangent", "strip"]),
  fit: is_object,
};
/** The members that are right. One that is not known here belongs to a later version: the engine reads it. */
function sound(value: unknown, checks: Record<string, Check>): JsonObject | undefined {
  if (!is_object(value)) return undefined;
  return Object.fromEntries(
    Object.entries(value).filter(([key, member]) => !Object.hasOwn(checks, key) || checks[key]?.(member)),
  );
}

/** A problem whose task the engine has read, or will: right in its outlines, its view in every part. */
export function read_problem(value: unknown): Problem | null {
  if (!is_object(value) || value.linkwright !== 1) return null;
  const task = read_task(value.task);
  if (!task) return null;
  const text = (key: string) =>
    typeof value[key] === "string" ? {[key]: (value[key] as string).slice(0, longest_text)} : {};
  const requirements = sound(value.requirements, requirement_checks),
    options = sound(value.options, option_checks);
  const view = read_view(value.view);
  return {
    linkwright: 1,
    ...text("title"),
    ...text("length_unit"),
    task,
    ...(requirements ? {requirements} : {}),
    ...read_blocks(value),
    ...(options ? {options} : {}),
    ...(Object.keys(view).length ? {view} : {}),
  };
}
