// A compact picture of one linkage and its body for animations: links, pivots, body, its path and the positions.
import type {Drive, Linkage, Point} from "../contract/messages";
import {figure_colors, paint_figure, type FigureColors} from "../figure/canvas";
import {placed_outline, positions_of, type Figure, type Trace} from "../figure/figure";
import {at_angle, type Mechanism} from "../figure/mechanism";
import {fitting, type Projection} from "../figure/paths";
import {shown_configurations} from "../transport/swept";
import type {Pose} from "../state/task";

export const picture_colors = figure_colors;
export interface Picture {
  drive: Drive;
  figure_at(angle_deg: number): Figure;
  at: Projection;
  colors: FigureColors;
  width: number;
  height: number;
}
export interface Subject {
  linkage: Linkage;
  mechanism: Mechanism;
  outline: readonly Point[];
  poses: readonly Pose[];
}

/** Over the task, or over the whole travel. */
export function picture_of(
  {linkage, mechanism, outline, poses}: Subject,
  whole: boolean,
  width: number,
  height: number,
  colors: FigureColors,
): Picture | null {
  const {drive} = linkage;
  if (!drive) return null;
  const shown = shown_configurations(mechanism, linkage, drive, whole),
    positions = positions_of(poses, outline),
    backdrop = shown[0] ? (mechanism.figure(linkage, shown[0], outline).backdrop ?? []) : [],
    traces: Trace[] = [{name: "path", role: "path", points: shown.map(({pose}): Point => [pose.x, pose.y])}];
  const points = [
    ...backdrop.flat(),
    ...positions.flatMap((position) => position.outline),
    ...shown.flatMap(({joints, pose}) => [...joints, ...placed_outline({outline, pose})]),
  ];
  return {
    drive,
    figure_at: (angle) => ({
      ...mechanism.figure(linkage, at_angle(mechanism, linkage, drive, angle), outline),
      positions,
      traces,
    }),
    at: fitting(points, width, height, 0.06 * width),
    colors,
    width,
    height,
  };
}

/** In the frame that the context has: a film is painted larger than the picture. */
export function paint_picture(
  context: CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D,
  {figure_at, at, colors, width, height}: Picture,
  angle_deg: number,
): void {
  context.globalAlpha = 1;
  context.fillStyle = colors.paper;
  context.fillRect(0, 0, width, height);
  paint_figure(context, figure_at(angle_deg), at, colors);
}
