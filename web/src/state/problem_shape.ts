// What comes from outside (a link, a file, the browser's store) as a problem, or nothing. The engine says what is wrong
// with a task; the view, which it keeps and never reads, is looked through here: what does not fit is left out.
import {linkage_types, type Point, type TauPair} from "../engine/protocol";
import type {Background, Pin, Pose, Problem, View} from "./problem";

const most_pins = 100, most_points = 1000;

type Object = Record<string, unknown>;

function is_object(value: unknown): value is Object {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}
function is_number(value: unknown): value is number {
  return typeof value === "number" && Math.abs(value) <= 1e12;
}
function is_pair(value: unknown): value is Point {
  return Array.isArray(value) && value.length === 2 && value.every(is_number);
}
function pairs(value: unknown): Point[] | undefined {
  return Array.isArray(value) && value.length <= most_points && value.every(is_pair) ? value : undefined;
}
function number_or_null(value: unknown): number | null {
  return is_number(value) ? value : null;
}

function read_pose(value: unknown): Pose | null {
  if (!is_object(value) || !is_number(value.x) || !is_number(value.y) || !is_number(value.theta_deg)) return null;
  const {x, y, theta_deg, derivatives} = value;
  const known = Array.isArray(derivatives) ? derivatives.filter((d): d is {x: number; y: number; theta: number} => is_object(d) && is_number(d.x) && is_number(d.y) && is_number(d.theta)) : [];
  return known.length ? {x, y, theta_deg, derivatives: known.map((d) => ({x: d.x, y: d.y, theta: d.theta}))} : {x, y, theta_deg};
}
function read_poses(value: unknown): Pose[] | null {
  if (!Array.isArray(value) || value.length > most_pins) return null;
  const poses = value.map(read_pose);
  return poses.every((pose) => pose !== null) ? poses : null;
}

/** A pin names itself by one letter and perhaps a number; all its numbers are looked at, its note is text. */
function read_pin(value: unknown): Pin | null {
  if (!is_object(value) || typeof value.name !== "string" || !/^[A-Z]\d{0,3}$/.test(value.name) || !is_pair(value.tau)) return null;
  const poses = read_poses(value.poses);
  const type = linkage_types.find((name) => name === value.type);
  if (!poses || !type) return null;
  const pivots = is_object(value.pivots) ? value.pivots : {};
  const pivot = (key: string) => (is_pair(pivots[key]) ? pivots[key] : null);
  return {
    name: value.name,
    note: typeof value.note === "string" ? value.note.slice(0, 2000) : undefined,
    tau: value.tau as TauPair,
    place: is_pair(value.place) ? value.place : undefined,
    poses,
    shown: value.shown === true ? true : undefined,
    type,
    min_transmission_angle_deg: number_or_null(value.min_transmission_angle_deg),
    link_ratio: number_or_null(value.link_ratio),
    longest: number_or_null(value.longest),
    lengths: read_lengths(value.lengths),
    pivots: {
      input_center: pivot("input_center"), input_circle: pivot("input_circle"),
      output_center: pivot("output_center"), output_circle: pivot("output_circle"),
    },
  };
}
function read_lengths(value: unknown): Pin["lengths"] {
  if (!is_object(value)) return null;
  const {ground, input, coupler, output} = value;
  return is_number(ground) && is_number(input) && is_number(coupler) && is_number(output) ? {ground, input, coupler, output} : null;
}
function read_pins(value: unknown): Pin[] | undefined {
  if (!Array.isArray(value)) return undefined;
  const pins = value.slice(0, most_pins).map(read_pin).filter((pin) => pin !== null);
  return pins.filter((pin, i) => pins.findIndex((other) => other.name === pin.name) === i);
}
function read_background(value: unknown): Background | undefined {
  if (!is_object(value) || typeof value.image !== "string" || !/^data:image\/(png|jpeg|webp|gif);base64,[A-Za-z0-9+/=]+$/.test(value.image)) return undefined;
  const {image, x, y, width, aspect} = value;
  if (!is_number(x) || !is_number(y) || !is_number(width) || !is_number(aspect) || width <= 0 || aspect <= 0) return undefined;
  const opacity = is_number(value.opacity) && value.opacity >= 0 && value.opacity <= 1 ? {opacity: value.opacity} : {};
  return {image, x, y, width, aspect, ...opacity};
}

/** The workbench's part of a file, as far as it is one. */
export function read_view(value: unknown): View {
  if (!is_object(value)) return {};
  const outline = pairs(value.outline), background = read_background(value.background);
  const view: {[K in keyof Required<View>]: View[K]} = {
    outline: outline && outline.length >= 3 ? outline : undefined,
    background,
    picked: is_pair(value.picked) ? value.picked : undefined,
    pins: read_pins(value.pins),
    traced: pairs(value.traced),
    order: Number.isInteger(value.order) && Math.abs(value.order as number) < 1e6 ? (value.order as number) : undefined,
  };
  return Object.fromEntries(Object.entries(view).filter(([, part]) => part !== undefined)) as View;
}

/** A problem whose task the engine has read, or will: right in its outlines, its view in every part. */
export function read_problem(value: unknown): Problem | null {
  if (!is_object(value) || value.linkwright !== 1 || !is_object(value.task)) return null;
  const poses = read_poses(value.task.poses);
  if (value.task.kind !== "motion" || value.task.mechanism !== "four_bar" || !poses) return null;
  const text = (key: string) => (typeof value[key] === "string" ? {[key]: (value[key] as string).slice(0, 1000)} : {});
  const part = (key: string) => (is_object(value[key]) ? {[key]: value[key]} : {});
  const view = read_view(value.view);
  return {
    linkwright: 1, ...text("title"), ...text("length_unit"), task: {kind: "motion", mechanism: "four_bar", poses},
    ...part("requirements"), ...part("options"), ...(Object.keys(view).length ? {view} : {}),
  };
}
