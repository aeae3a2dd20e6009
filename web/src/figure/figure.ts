// What is drawn of a linkage in one configuration, whoever paints it: on the drawing and in small (FigureLayer), in films
// (canvas); the parts in 3-D (solid/model) have its colours. Places lie in the fixed frame, in the user's unit; painters
// give roles their looks.
import type {Point, Side} from "../contract/messages";
import {placed} from "../state/problem";
import {convex_hull} from "./hull";

/** A frame on a body. */
export interface Place {
  x: number;
  y: number;
  theta_deg: number;
}
export type End = "center" | "circle";
/** Both ends of the grounded links; null: at infinity. */
export type Ends = Record<Side, Record<End, Point | null>>;

export type Role = "driver" | "input" | "coupler" | "output";
/** A sign beside a thing, and what it means. */
export interface Label {
  sign: string;
  words: string;
}
/** A moving link. */
export interface Body {
  name: string;
  role: Role;
  /** Its joints: two make a bar, more a plate. */
  corners: readonly Point[];
  /** Its middle line from the first joint to the last, where that is bent. */
  along?: readonly Point[];
  label?: Label;
}
export interface Joint {
  name: string;
  kind: "ground_pivot" | "moving_pivot";
  role: Role;
  at: Point;
  /** Names of the bodies that it joins. */
  joins: readonly [string, string];
  /** Which grounded link ends here. */
  end?: {side: Side; end: End};
  label?: Label;
}
export const ground = "ground"; // the name of the body at rest
/** A pin in a straight guide: the grounded link whose other pivot lies at infinity. */
export interface Slider {
  role: Role;
  side: Side;
  end: End; // the one at infinity
  /** The pin; null: it lies at infinity as well. */
  at: Point | null;
  /** Unit vector to the pivot at infinity; the guide lies across it. */
  away: Point;
  /** The guide is at rest. */
  fixed: boolean;
}
/** The body that the task guides. */
export interface GuidedBody {
  pose: Place;
  outline: readonly Point[]; // body coordinates
  /** Name of the link that carries it. */
  on: string;
}
export interface Trace {
  name: string;
  /** Of the body's origin over the task, and over all that can be driven; of a point that the user has chosen. */
  role: "path" | "whole_path" | "traced";
  points: readonly Point[];
}
/** The body in a position of the task. */
export interface Position {
  number: number;
  origin: Point;
  outline: readonly Point[];
}
export interface Figure {
  /** Thin lines behind it all: of the space that it lies in. */
  backdrop?: readonly (readonly Point[])[];
  /** From the back to the front. */
  bodies: readonly Body[];
  joints: readonly Joint[];
  sliders: readonly Slider[];
  guided: GuidedBody | null;
  traces: readonly Trace[];
  /** Traced points as they lie now. */
  beads: readonly Point[];
  positions: readonly Position[];
}

export const empty_figure: Figure = {
  bodies: [],
  joints: [],
  sliders: [],
  guided: null,
  traces: [],
  beads: [],
  positions: [],
};

export function placed_outline({outline, pose}: Pick<GuidedBody, "outline" | "pose">): Point[] {
  return outline.map((point) => placed(point, pose));
}
/** What joins the guided body to the link that carries it: from the link's joints to the two corners of the body nearest to
 *  their middle. In the frame in which both are told. */
export function web_corners(outline: readonly Point[], joints: readonly Point[]): Point[] {
  const middle = middle_of({corners: joints}),
    away = (p: Point) => Math.hypot(p[0] - middle[0], p[1] - middle[1]);
  return convex_hull([...joints, ...[...outline].sort((p, q) => away(p) - away(q)).slice(0, 2)]);
}
/** The same in the fixed frame; null where nothing is guided, or all joints of the link that carries it lie at infinity. */
export function web_of({guided, joints}: Pick<Figure, "guided" | "joints">): Point[] | null {
  const places = guided ? joints.filter(({joins}) => joins.includes(guided.on)).map(({at}) => at) : [];
  return places.length ? web_corners(placed_outline(guided!), places) : null;
}
export function positions_of(poses: readonly Place[], outline: readonly Point[]): Position[] {
  return poses.map((pose, i) => ({
    number: i + 1,
    origin: [pose.x, pose.y],
    outline: outline.map((point) => placed(point, pose)),
  }));
}
/** Everything that is to be seen of it. */
export function points_of({backdrop = [], bodies, joints, guided, positions, traces}: Figure): Point[] {
  return [
    ...backdrop.flat(),
    ...bodies.flatMap(({corners, along}) => along ?? corners),
    ...joints.map(({at}) => at),
    ...(guided ? placed_outline(guided) : []),
    ...positions.flatMap(({outline}) => outline),
    ...traces.flatMap(({points}) => points),
  ];
}
export function is_plate({corners}: Body): boolean {
  return corners.length > 2;
}
/** Many links are drawn more slender than the three of a four-bar. */
export function is_slender({bodies}: Figure): boolean {
  return bodies.length > 3;
}
/** The middle of a body's joints. */
export function middle_of({corners}: Pick<Body, "corners">): Point {
  const sum = (axis: 0 | 1) => corners.reduce((total, corner) => total + corner[axis], 0);
  return [sum(0) / corners.length, sum(1) / corners.length];
}
