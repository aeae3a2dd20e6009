// What can be taken away, and of which linkage: the picked one, or one that is pinned.
import type {ExportFormat, Linkage, LinkageType, MachineFormat, TauPair} from "../contract/messages";
import {drawing_svg, drawing_with_more} from "../drawing/snapshot";
import {css_values} from "../state/css_values";
import {engine_text, outline_of, type Problem} from "../state/problem";
import {preferences} from "../state/preferences.svelte";
import {poses_of} from "../state/task";
import {given_views} from "../analyses/view_dispatch";
import type {Workbench} from "../state/workbench.svelte";
import {gives_linkage, with_other_task} from "../kinds/kind_dispatch";
import {task_view} from "../kinds/view_dispatch";
import {animated_gif, type Progress} from "./animation";
import {containers, film, film_angles, type Container} from "./film";
import {film_choice} from "./film_form.svelte";
import {animation_frames} from "./frames";
import {machine_of} from "./machine";
import {file_name, file_stem} from "./names";
import {picture_colors, picture_of} from "./picture";
import {has_stage_picture, rasterised, stage_picture} from "./raster";

export interface Target {
  /** A pin's; null: the picked linkage. */
  pin: string | null;
  tau: TauPair;
  type: LinkageType;
  /** The task in which it does its work. */
  problem: Problem;
}
export const machine_formats = [
  "3mf",
  "stl",
  "plates",
  "urdf",
  "sdf",
  "mjcf",
] as const satisfies readonly MachineFormat[];
export const formats = [
  "dxf",
  ...machine_formats,
  "svg",
  "png",
  "csv",
  "json",
  "result",
  "gif",
  ...containers,
] as const;
export type Format = (typeof formats)[number];
export const animated: readonly Format[] = ["gif", ...containers];

const engine_types: Record<ExportFormat, string> = {
  dxf: "image/vnd.dxf",
  svg: "image/svg+xml",
  csv: "text/csv",
  json: "application/json",
  result: "application/json",
};
const machine_types: Record<MachineFormat, string> = {
  "3mf": "model/3mf",
  stl: "model/stl",
  plates: engine_types.dxf,
  urdf: "application/xml",
  sdf: "application/xml",
  mjcf: "application/xml",
};
/** What the program takes for what the page cannot make: its name there, and the command. */
export function step_command(workbench: Workbench, target: Target): {file: string; command: string} {
  const stem = file_stem(target.problem, target, workbench.pins),
    file = `${stem}${gives_linkage(target.problem.task) ? "" : "-result"}.json`;
  return {file, command: `linkwright export ${file} --format step -o ${stem}.step`};
}
const gif_size = {width: 640, height: 480};

export function targets(workbench: Workbench): Target[] {
  const {problem, pins, picked_linkage, picked} = workbench;
  const own: Target[] =
    picked && picked_linkage ? [{pin: null, tau: picked.tau, type: picked_linkage.type, problem}] : [];
  return [
    ...own,
    ...pins.map((pin) => ({pin: pin.name, tau: pin.tau, type: pin.type, problem: with_other_task(problem, pin.task)})),
  ];
}

const no_progress: Progress = {done: () => {}, signal: new AbortController().signal};

export interface NamedBlob {
  name: string;
  blob: Blob;
}
export async function made_file(
  workbench: Workbench,
  target: Target,
  format: Format,
  progress: Progress = no_progress,
): Promise<NamedBlob> {
  const stem = file_stem(target.problem, target, workbench.pins);
  if (format === "svg")
    return {name: `${stem}.svg`, blob: new Blob([await svg_of(workbench, target)], {type: engine_types.svg})};
  if (format === "png") return {name: `${stem}.png`, blob: await png(workbench, target)};
  if (format === "gif" || format === "mp4" || format === "webm")
    return {name: `${stem}.${format}`, blob: await animation(workbench, target, format, progress)};
  if (is_of_a_machine(format)) {
    const {bytes, extension} = await workbench.driver_client!.run({
      kind: "machine_file",
      ...machine_of(target.problem, target.tau),
      format,
    });
    const name = file_name(format === "plates" ? `${stem}-plates` : stem, extension);
    return {name, blob: new Blob([bytes], {type: machine_types[format]})};
  }
  const {text, extension} = await from_engine(workbench, target, format);
  return {
    name: file_name(format === "result" ? `${stem}-result` : stem, extension),
    blob: new Blob([text], {type: engine_types[format]}),
  };
}
export function is_of_a_machine(format: Format): format is MachineFormat {
  return (machine_formats as readonly Format[]).includes(format);
}
/** What is told of a linkage in its problem: another unit or title makes another drawing of the same bars. */
export function question_of({problem, tau}: Target): string {
  return JSON.stringify([engine_text(problem), tau]);
}
export function from_engine(
  workbench: Workbench,
  {problem, tau}: Target,
  format: ExportFormat,
): Promise<{text: string; extension: string}> {
  return workbench.driver_client!.run({kind: "export", problem: engine_text(problem), tau, format});
}
/** The engine's drawing of the positions, or the page's where more is shown in it. */
export async function svg_of(workbench: Workbench, target: Target): Promise<string> {
  const is_more =
    preferences.instant || given_views(target.problem).some((view) => view.may_be_in_picture?.(target.problem));
  const shown = is_more && target.pin === null ? drawing_with_more() : null;
  if (shown) return drawing_svg(shown)!;
  return (await from_engine(workbench, target, "svg")).text;
}
/** The engine's sheet without its title and its numbers: for a sheet that has its own. */
export function card_of(sheet: string): string {
  const card = [...sheet.matchAll(/<rect x="([\d.]+)" y="([\d.]+)" width="([\d.]+)" height="([\d.]+)"/g)][1]; // the first is the page
  if (!card) return sheet;
  const [, x, y, width, height] = card;
  return sheet.replace(
    /width="[\d.]+" height="[\d.]+" viewBox="[^"]*"/,
    `width="${width}" height="${height}" viewBox="${x} ${y} ${width} ${height}"`,
  );
}
/** What is printed beside title and numbers. */
export async function printed_svg(workbench: Workbench, target: Target): Promise<string> {
  const svg = await svg_of(workbench, target);
  return svg.startsWith("<?xml") ? card_of(svg) : svg; // the page's own drawing has neither
}
async function png(workbench: Workbench, target: Target): Promise<Blob> {
  if (target.pin === null && has_stage_picture()) return stage_picture();
  const on_screen = target.pin === null ? drawing_svg() : null;
  return rasterised(on_screen ?? (await svg_of(workbench, target)), 2);
}
async function linkage_of(workbench: Workbench, {pin, problem, tau}: Target): Promise<Linkage> {
  if (pin === null && workbench.picked_linkage && workbench.answers.picked_is_of(problem))
    return workbench.picked_linkage;
  return (await workbench.driver_client!.run({kind: "linkage", problem: engine_text(problem), tau})).linkage;
}
async function animation(
  workbench: Workbench,
  target: Target,
  format: "gif" | Container,
  progress: Progress,
): Promise<Blob> {
  const linkage = await linkage_of(workbench, target),
    {problem} = target;
  const {form} = film_choice,
    scale = format === "gif" ? 1 : form.height / gif_size.height; // lines as wide as in the GIF, for its height
  const {width, height} = format === "gif" ? gif_size : {width: form.width / scale, height: form.height / scale};
  const poses = poses_of(problem.task),
    {mechanism} = task_view(problem.task);
  const picture = picture_of(
    {linkage, mechanism, outline: poses.length ? outline_of(problem) : [], poses},
    workbench.whole_travel,
    width,
    height,
    css_values(document.documentElement, picture_colors),
  );
  if (!picture) throw new Error("no drive table");
  const whole = workbench.whole_travel;
  if (format === "gif") return animated_gif(picture, animation_frames(picture.drive, whole), progress);
  return film(picture, film_angles(picture.drive, whole, form.rate), scale, format, form, progress);
}
