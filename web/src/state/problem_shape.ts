// What comes from outside (a link, a file, the browser's store) as a problem, or nothing. The engine says what is wrong
// with a task; the view, which it keeps and never reads, is looked through here: what does not fit is left out.
import {linkage_types, type Point, type TauPair} from "../engine/protocol";
import {read_task} from "../tasks/kinds";
import type {Background, Pin, Problem, View} from "./problem";
import {is_number, is_object, is_pair, number_or_null, read_list} from "./shape";

const most_pins = 100, most_points = 1000;

function pairs(value: unknown): Point[] | undefined {
  return read_list(value, (item) => (is_pair(item) ? item : null), most_points) ?? undefined;
}

/** A pin names itself by one letter and perhaps a number; all its numbers are looked at, its note is text. */
function read_pin(value: unknown): Pin | null {
  if (!is_object(value) || typeof value.name !== "string" || !/^[A-Z]\d{0,3}$/.test(value.name) || !is_pair(value.tau)) return null;
  const task = read_task(value.task ?? {kind: "motion", mechanism: "four_bar", poses: value.poses}); // pins used to have poses
  const type = linkage_types.find((name) => name === value.type);
  if (!task || !type) return null;
  const pivots = is_object(value.pivots) ? value.pivots : {};
  const pivot = (key: string) => (is_pair(pivots[key]) ? pivots[key] : null);
  return {
    name: value.name,
    note: typeof value.note === "string" ? value.note.slice(0, 2000) : undefined,
    tau: value.tau as TauPair,
    place: is_pair(value.place) ? value.place : undefined,
    task,
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
  if (!is_object(value) || value.linkwright !== 1) return null;
  const task = read_task(value.task);
  if (!task) return null;
  const text = (key: string) => (typeof value[key] === "string" ? {[key]: (value[key] as string).slice(0, 1000)} : {});
  const part = (key: string) => (is_object(value[key]) ? {[key]: value[key]} : {});
  const view = read_view(value.view);
  return {
    linkwright: 1, ...text("title"), ...text("length_unit"), task,
    ...part("requirements"), ...part("options"), ...(Object.keys(view).length ? {view} : {}),
  };
}
