// A compact picture of one linkage and its body for animations: links, pivots, body, its path and the positions.
import type {Drive, Linkage, Point} from "../engine/protocol";
import type {SixBar} from "../tasks/six_bar/replies";
import {joints_at, row_count, row_joints, state_at, type State} from "../state/drive";
import {placed} from "../state/problem";
import type {Pose} from "../state/task";
import {role_of_body, role_of_joint, type Role} from "../tasks/six_bar/roles";
import {shown_states, swept_points} from "../transport/swept";

export const picture_colors = [
  "paper",
  "ink",
  "ink3",
  "line",
  "grid",
  "accent",
  "input",
  "output",
  "body",
  "curve",
] as const;
export type PictureColors = Record<(typeof picture_colors)[number], string>;
export interface Picture {
  drive: Drive;
  fixed: [input: Point, output: Point];
  six_bar: SixBar | null;
  outline: readonly Point[];
  poses: readonly Pose[];
  path: Point[];
  colors: PictureColors;
  /** Fixed frame → pixels: (scale, left, top). */
  view: {scale: number; x: number; y: number};
  width: number;
  height: number;
}

export function picture_of(
  linkage: Linkage,
  outline: readonly Point[],
  poses: readonly Pose[],
  whole: boolean,
  width: number,
  height: number,
  colors: PictureColors,
): Picture | null {
  const {drive} = linkage;
  if (!drive || !linkage.input.center || !linkage.output.center) return null;
  const states = shown_states(drive, whole);
  const fixed: [Point, Point] = [linkage.input.center, linkage.output.center];
  const six_bar = linkage.six_bar ?? null,
    hinges = six_bar ? Array.from({length: row_count(drive)}, (_, row) => row_joints(drive, row)).flat() : fixed;
  const points = [
    ...hinges,
    ...poses.flatMap((pose) => outline.map((p) => placed(p, pose))),
    ...swept_points(states, outline),
  ];
  const path = states.map((s): Point => [s.x, s.y]);
  return {
    drive,
    fixed,
    six_bar,
    outline,
    poses,
    path,
    colors,
    view: fitted(points, width, height, 0.06 * width),
    width,
    height,
  };
}

export function fitted(points: readonly Point[], width: number, height: number, margin: number): Picture["view"] {
  let [x0, y0, x1, y1] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [x, y] of points) [x0, y0, x1, y1] = [Math.min(x0, x), Math.min(y0, y), Math.max(x1, x), Math.max(y1, y)];
  const scale = Math.min((width - 2 * margin) / (x1 - x0 || 1), (height - 2 * margin) / (y1 - y0 || 1));
  return {scale, x: width / 2 - (scale * (x0 + x1)) / 2, y: height / 2 + (scale * (y0 + y1)) / 2};
}

type Context = CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D;

export function paint_picture(context: Context, picture: Picture, angle: number): void {
  const state = state_at(picture.drive, angle),
    {colors} = picture;
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.globalAlpha = 1;
  context.lineCap = context.lineJoin = "round";
  context.fillStyle = colors.paper;
  context.fillRect(0, 0, picture.width, picture.height);
  paint_task(context, picture);
  paint_body(context, picture, state);
  if (picture.six_bar) paint_six_bar(context, picture, picture.six_bar, joints_at(picture.drive, angle));
  else paint_links(context, picture, state);
}

export function pixels({view}: Pick<Picture, "view">, [x, y]: Point): [number, number] {
  return [view.x + view.scale * x, view.y - view.scale * y];
}
function trace(context: Context, picture: Picture, points: readonly Point[], closed: boolean): void {
  context.beginPath();
  for (const point of points) context.lineTo(...pixels(picture, point));
  if (closed) context.closePath();
}
function paint_task(context: Context, picture: Picture): void {
  const {colors} = picture;
  context.strokeStyle = colors.line;
  context.lineWidth = 1.2;
  for (const pose of picture.poses) {
    trace(
      context,
      picture,
      picture.outline.map((p) => placed(p, pose)),
      true,
    );
    context.stroke();
  }
  context.strokeStyle = colors.accent;
  context.lineWidth = 1.6;
  context.setLineDash([0.1, 4.5]);
  trace(context, picture, picture.path, false);
  context.stroke();
  context.setLineDash([]);
  context.font = "600 13px system-ui, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "middle";
  picture.poses.forEach((pose, i) => {
    const [x, y] = pixels(picture, [pose.x, pose.y]);
    disc(context, x, y, 9.5, colors.paper, colors.ink3, 1.4);
    context.fillStyle = colors.ink;
    context.fillText(String(i + 1), x, y + 0.5);
  });
}
function paint_body(context: Context, picture: Picture, state: State): void {
  trace(
    context,
    picture,
    picture.outline.map((p) => placed(p, state)),
    true,
  );
  context.fillStyle = picture.colors.accent;
  context.globalAlpha = 0.13;
  context.fill();
  context.globalAlpha = 1;
  context.strokeStyle = picture.colors.accent;
  context.lineWidth = 2;
  context.stroke();
}
function paint_links(context: Context, picture: Picture, state: State): void {
  const {colors, fixed} = picture,
    a: Point = [state.ax, state.ay],
    b: Point = [state.bx, state.by];
  const bars: [Point, Point, string][] = [
    [a, b, colors.body],
    [fixed[0], a, colors.input],
    [fixed[1], b, colors.output],
  ];
  for (const [from, to, color] of bars) {
    context.strokeStyle = color;
    context.lineWidth = 7;
    trace(context, picture, [from, to], false);
    context.stroke();
  }
  for (const [pivot, color] of [
    [fixed[0], colors.input],
    [fixed[1], colors.output],
  ] as const)
    paint_ground(context, picture, pivot, color);
  for (const [pivot, color] of [
    [a, colors.input],
    [b, colors.output],
  ] as const)
    disc(context, ...pixels(picture, pivot), 6.5, colors.paper, color, 2.4);
}
function paint_six_bar(context: Context, picture: Picture, {bodies, joints}: SixBar, now: readonly Point[]): void {
  const {colors} = picture,
    color = (role: Role) => colors[role === "driver" ? "accent" : role === "chain" ? "body" : role];
  bodies.forEach((list, body) => {
    if (body === 0) return;
    context.strokeStyle = context.fillStyle = color(role_of_body(body));
    context.lineWidth = list.length > 2 ? 4 : 6;
    trace(
      context,
      picture,
      list.map((joint) => now[joint]),
      list.length > 2,
    );
    context.globalAlpha = 0.2;
    if (list.length > 2) context.fill();
    context.globalAlpha = 1;
    context.stroke();
  });
  joints.forEach(({ground}, i) => {
    if (ground) paint_ground(context, picture, now[i], color(role_of_joint(i)));
    else disc(context, ...pixels(picture, now[i]), 6, colors.paper, color(role_of_joint(i)), 2.2);
  });
}
function paint_ground(context: Context, picture: Picture, pivot: Point, color: string): void {
  const [x, y] = pixels(picture, pivot);
  context.strokeStyle = picture.colors.ink;
  context.lineWidth = 1.5;
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(x - 9, y + 15);
  context.lineTo(x + 9, y + 15);
  context.closePath();
  for (let i = -2; i < 2; ++i) {
    context.moveTo(x + 6 * i + 5, y + 15);
    context.lineTo(x + 6 * i + 1, y + 20);
  }
  context.stroke();
  disc(context, x, y, 5.5, picture.colors.paper, color, 2.4);
}
function disc(
  context: Context,
  x: number,
  y: number,
  radius: number,
  fill: string,
  stroke: string,
  width: number,
): void {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fillStyle = fill;
  context.fill();
  context.strokeStyle = stroke;
  context.lineWidth = width;
  context.stroke();
}
