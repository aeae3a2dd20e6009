// The problem file as the page holds it: a plain immutable value. Its normal form and its mistakes come from the engine.
import type {Options} from "../contract/problem";
import type {LinkageType, Pivot, Point, Requirements, TauPair} from "../contract/messages";
import {diagonal_of, poses_of, type Pose, type Task} from "./task";

export type {Options};
export type Objective = NonNullable<Options["objective"]>;
export const most_pins = 1000;
/** A linkage that the user keeps: it carries the task in which it was pinned. */
export interface Pin {
  name: string; // A, B, … or what the user calls it
  note?: string;
  tau: TauPair;
  place?: TauPair; // where its marker stands on the map, display coordinates
  task: Task;
  shown?: boolean; // as a ghost on the drawing
  type: LinkageType;
  min_transmission_angle_deg: number | null;
  link_ratio: number | null;
  longest: number | null;
  lengths: {ground: number; input: number; coupler: number; output: number} | null;
  /** By name, as its kind keeps them (kinds/kind.ts); null: at infinity. */
  pivots: Readonly<Record<string, Pivot | null>>;
}
export interface Background {
  image: string; // data: URL
  /** Fixed-frame point under the picture's lower left corner, and its width in the user's unit. */
  x: number;
  y: number;
  width: number;
  aspect: number; // height / width
  opacity?: number; // 0.5 unless told
  angle_deg?: number; // about its lower left corner
  hidden?: boolean;
  locked?: boolean; // it cannot be dragged
}
/** What is turned where a body is guided in space: a simple one, or triangles from a file. */
export type SolidBody =
  {shape: "triad" | "wing" | "dish" | "box" | "craft"} | {shape: "own"; name: string; corners: string}; // base64 of 16-bit coordinates, nine to a triangle (sphere/bodies.ts)
/** The workbench's own part of the file: kept by the engine, never read. */
export interface View {
  outline?: readonly Point[]; // body coordinates, the moving frame of each pose
  background?: Background | null;
  body?: SolidBody;
  picked?: TauPair;
  pins?: readonly Pin[];
  traced?: readonly Point[]; // body points whose curves are drawn, body coordinates
  order?: number; // display order of the map
}
/** Analyses add their blocks (analyses/analysis.ts). */
export interface Problem {
  linkwright: 1;
  title?: string;
  length_unit?: string;
  task: Task;
  requirements?: Requirements;
  options?: Options;
  view?: View;
}

export function problem_text(problem: Problem, indent?: number): string {
  return JSON.stringify(problem, null, indent);
}

const engine_texts = new WeakMap<Problem, string>(); // problems are immutable, some are megabytes, and each is asked for often
/** What the engine needs: without the view, so that pins and outline never make it compute. */
export function engine_text(problem: Problem): string {
  const {view: _, ...rest} = problem,
    text = engine_texts.get(problem) ?? JSON.stringify(rest);
  engine_texts.set(problem, text);
  return text;
}
/** Whether the engine's answer to one is that to the other. */
export function same_question(a: Problem, b: Problem): boolean {
  return a === b || engine_text(a) === engine_text(b);
}

export function with_task<T extends Task>(problem: Problem, task: T): Problem {
  return {...problem, task};
}
export function with_requirements(problem: Problem, change: Partial<Requirements>): Problem {
  const requirements = {...problem.requirements, ...change};
  for (const key of Object.keys(requirements) as (keyof Requirements)[]) {
    if (requirements[key] === undefined) delete requirements[key];
  }
  return {...problem, requirements};
}
export function with_options(problem: Problem, change: Partial<Options>): Problem {
  const options = {...problem.options, ...change};
  for (const key of Object.keys(options) as (keyof Options)[]) if (options[key] === undefined) delete options[key];
  return {...problem, options};
}
export function with_view(problem: Problem, change: Partial<View>): Problem {
  return {...problem, view: {...problem.view, ...change}};
}

/** A body point's place in the fixed frame when the moving frame lies at `pose`. */
export function placed(point: Point, pose: {x: number; y: number; theta_deg: number}): Point {
  const angle = (pose.theta_deg * Math.PI) / 180,
    c = Math.cos(angle),
    s = Math.sin(angle);
  return [pose.x + c * point[0] - s * point[1], pose.y + s * point[0] + c * point[1]];
}
/** The reverse: body coordinates of a fixed-frame point. */
export function body_point(point: Point, pose: {x: number; y: number; theta_deg: number}): Point {
  const angle = (pose.theta_deg * Math.PI) / 180,
    c = Math.cos(angle),
    s = Math.sin(angle);
  const dx = point[0] - pose.x,
    dy = point[1] - pose.y;
  return [c * dx + s * dy, -s * dx + c * dy];
}

/** Diagonal of the box around the poses. */
export function poses_extent(poses: readonly Pose[]): number {
  return diagonal_of(poses.map((p) => [p.x, p.y] as const)) || 1;
}

/** A round number of one digit (1, 2, 5 × 10ⁿ) that is at least `value`. */
export function round_step(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  for (const digit of [1, 2, 5]) if (digit * power >= value * (1 - 1e-12)) return digit * power;
  return 10 * power;
}

/** Round lengths in a span, fewer than seven. */
export function length_levels([from, to]: readonly [number, number]): number[] {
  const step = round_step((to - from) / 8);
  return [1, 2, 3, 4, 5, 6].map((k) => k * step).filter((level) => level < to);
}

/** Outline of the body: the file's, or a rectangle sized from the poses. */
export function outline_of(problem: Problem): readonly Point[] {
  if (problem.view?.outline && problem.view.outline.length >= 3) return problem.view.outline;
  const size = poses_extent(poses_of(problem.task));
  const w = round_step(0.3 * size),
    h = round_step(0.1 * size);
  return [
    [-w / 2, -h / 2],
    [w / 2, -h / 2],
    [w / 2, h / 2],
    [-w / 2, h / 2],
  ];
}
