// Contours on a canvas: white lines with a dark edge, each labelled where it is straightest.
import {contours, straightest, type Contour} from "./contours";
import {degenerate} from "../contract/messages";
import type {Axes, Axis, MapAnswer} from "../contract/messages";
import {point_of, type Frame} from "./painter";

const label_px = 30,
  label_apart_px = 22,
  most_lines = 500; // squares along an edge: finer is not seen

function breaks(window: readonly [number, number], edges: readonly number[], n: number): Set<number> {
  return new Set(edges.map((edge) => Math.round(((edge - window[0]) / (window[1] - window[0])) * n)));
}

/** `ignored`: failures (bits) that do not keep a cell out. */
export function map_contours(map: MapAnswer, levels: readonly number[], axes: Axes, ignored: number): Contour[] {
  const {rows, columns, value, defects, type, fails, window} = map;
  const edges = (axis: Axis) => axis.blocks.flatMap((block) => [block.from, block.to]);
  return contours(
    {
      rows,
      columns,
      value,
      stride: Math.max(1, Math.round(Math.max(rows, columns) / most_lines)),
      counts: (i) => defects[i] === 0 && type[i]! !== degenerate && (fails[i]! & ~ignored) === 0,
      row_breaks: breaks(window.input, edges(axes.input), rows),
      column_breaks: breaks(window.output, edges(axes.output), columns),
    },
    levels,
  );
}

/** The same in pixels of the frame. */
export function placed_contours(
  found: readonly Contour[],
  {rows, columns, window}: MapAnswer,
  frame: Frame,
): Contour[] {
  const place = (cell: number, n: number, [from, to]: readonly [number, number]) =>
    from + ((cell + 0.5) / n) * (to - from);
  const placed = (line: Float32Array) => {
    const moved = new Float32Array(line.length);
    for (let i = 0; i < line.length; i += 2) {
      [moved[i], moved[i + 1]] = point_of(frame, [
        place(line[i + 1]!, rows, window.input),
        place(line[i]!, columns, window.output),
      ]);
    }
    return moved;
  };
  return found.map(({level, lines}) => ({level, lines: lines.map(placed)}));
}

function path_of(lines: readonly Float32Array[]): Path2D {
  const path = new Path2D();
  for (const line of lines) {
    path.moveTo(line[0]!, line[1]!);
    for (let i = 2; i < line.length; i += 2) path.lineTo(line[i]!, line[i + 1]!);
  }
  return path;
}

export function draw_contours(
  context: CanvasRenderingContext2D,
  found: readonly Contour[],
  bold: (level: number) => boolean,
  text: (level: number) => string,
): void {
  context.lineJoin = context.lineCap = "round";
  for (const {level, lines} of found) {
    const path = path_of(lines),
      width = bold(level) ? 2 : 1;
    context.strokeStyle = "rgba(16,20,24,0.4)";
    context.lineWidth = width + 1;
    context.stroke(path);
    context.strokeStyle = "#fff";
    context.lineWidth = width;
    context.stroke(path);
  }
  context.font = "600 10px system-ui, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "middle";
  const labelled: {x: number; y: number}[] = [];
  for (const {level, lines} of found) label(context, lines, text(level), labelled);
}

function label(
  context: CanvasRenderingContext2D,
  lines: readonly Float32Array[],
  text: string,
  labelled: {x: number; y: number}[],
): void {
  const longest_first = [...lines].sort((a, b) => b.length - a.length).slice(0, 4);
  const at = longest_first
    .map((line) => straightest(line, label_px))
    .find(
      (place) => place && labelled.every((other) => Math.hypot(other.x - place.x, other.y - place.y) > label_apart_px),
    );
  if (!at) return;
  labelled.push(at);
  const angle = Math.abs(at.angle) > Math.PI / 2 ? at.angle + Math.PI : at.angle;
  context.save();
  context.translate(at.x, at.y);
  context.rotate(angle);
  context.strokeStyle = "rgba(16,20,24,0.8)";
  context.lineWidth = 3;
  context.strokeText(text, 0, 0);
  context.fillStyle = "#fff";
  context.fillText(text, 0, 0);
  context.restore();
}
