// What stands in a view of space: values by key, in the units of the ball (its radius is 1).
import type {Rows, Vec3} from "./vectors";

export const sphere_colors = [
  "paper",
  "sunk",
  "line",
  "body",
  "ink",
  "ink2",
  "ink3",
  "curve",
  "craft",
  "accent",
  "input",
  "output",
  "good",
  "bad",
  "warn",
  "axis_x",
  "axis_y",
  "axis_z",
] as const;
export type SphereColor = (typeof sphere_colors)[number];
export const axis_colors: readonly [SphereColor, SphereColor, SphereColor] = ["axis_x", "axis_y", "axis_z"];

interface Common {
  key: string;
  color: SphereColor;
  /** 1 unless told. */
  opacity?: number;
}
/** A line of a width in pixels. */
export interface Path extends Common {
  kind: "path";
  points: readonly Vec3[];
  width?: number;
  dashed?: boolean;
  /** It lies on the ball: what is on the far side of it is thin and faint. */
  on_ball?: boolean;
}
export interface Arrow extends Common {
  kind: "arrow";
  from: Vec3;
  to: Vec3;
  width?: number;
}
export interface Dot extends Common {
  kind: "dot";
  at: Vec3;
  /** Radius, of the ball's. */
  size?: number;
}
/** Triangles from an apex to a line: a sector, a cone. */
export interface Fan extends Common {
  kind: "fan";
  apex: Vec3;
  rim: readonly Vec3[];
}
/** A flat ring about the origin. */
export interface Band extends Common {
  kind: "band";
  axis: Vec3;
  inner: number;
  outer: number;
}
/** A body, its frame's origin at `at`: a little craft with its nose along x, its wings along y and its fin along z. */
export interface Craft extends Common {
  kind: "craft";
  frame: Rows;
  at?: Vec3;
  size?: number;
}
/** Stretches of lines on the ball, a beginning and an end to each; parts on the far side are thin and faint. */
export interface Strokes extends Common {
  kind: "strokes";
  ends: readonly Vec3[];
  width?: number;
}
/** A ball about the origin, behind all else: as a disc. */
export interface Ball extends Common {
  kind: "ball";
  radius: number;
}
/** A body of its own, its frame's origin in the middle of the ball. */
export interface Solid extends Common {
  kind: "solid";
  /** Coordinates of three corners to a triangle, in its frame: the same list is the same body. */
  corners: readonly number[] | Float32Array;
  frame: Rows;
  size?: number;
}
export type Item = Path | Arrow | Dot | Fan | Band | Craft | Strokes | Ball | Solid;

/** A short text beside a point. */
export interface Label {
  key: string;
  at: Vec3;
  text: string;
  color: SphereColor;
  /** It can be pressed: by this name. */
  button?: {name: string; testid: string; pressed: boolean; press(): void};
}

/** Three axes with their names: x₀ y₀ z₀, or x′ y′ z′. */
export function triad(
  key: string,
  frame: Rows,
  {size = 1, at = [0, 0, 0], mark = "", faint = false}: {size?: number; at?: Vec3; mark?: string; faint?: boolean} = {},
): {items: Item[]; labels: Label[]} {
  const ends = [0, 1, 2].map((k): Vec3 => [
    at[0] + size * frame[0][k]!,
    at[1] + size * frame[1][k]!,
    at[2] + size * frame[2][k]!,
  ]);
  const color = (k: number) => (faint ? "ink3" : axis_colors[k]!);
  return {
    items: ends.map((to, k) => ({
      kind: "arrow",
      key: `${key} ${k}`,
      from: at,
      to,
      color: color(k),
      width: faint ? 1.5 : 3,
      opacity: faint ? 0.75 : 1,
    })),
    labels: ends.map((end, k) => ({key: `${key} ${k}`, at: end, text: `${"xyz"[k]}${mark}`, color: color(k)})),
  };
}
