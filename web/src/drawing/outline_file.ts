// An outline out of a drawing of another program: the first polyline of an SVG or a DXF file.
import type {Point} from "../engine/protocol";
import {bounds} from "./viewport";

const most_corners = 200;

export function is_outline_file(file: File, svg_too: boolean): boolean {
  return /\.dxf$/i.test(file.name) || (svg_too && (/\.svg$/i.test(file.name) || file.type === "image/svg+xml"));
}
/** Corners in body coordinates, or nothing where the file has no polyline of three corners. */
export function outline_of_file(name: string, text: string, size: number): Point[] | null {
  const points = /\.dxf$/i.test(name) ? dxf_polyline(text) : svg_polyline(text);
  const corners = points && without_repeats(points);
  return corners && corners.length >= 3 ? fitted_to(reduced(corners), size) : null;
}

/** The longest LWPOLYLINE or POLYLINE, else the chain of LINEs. Arcs of polylines are taken as their chords. */
export function dxf_polyline(text: string): Point[] | null {
  const lines = text.split(/\r\n|\r|\n/),
    entities: {kind: string; points: Point[]}[] = [];
  let x = NaN;
  for (let i = 0; i + 1 < lines.length; i += 2) {
    const code = Number(lines[i]),
      value = lines[i + 1]!.trim(),
      last = entities[entities.length - 1];
    if (code === 0) entities.push({kind: value, points: []});
    else if (code === 10 || code === 11) x = Number(value);
    else if ((code === 20 || code === 21) && last) last.points.push([x, Number(value)]);
  }
  const lists = entities.filter((e) => e.kind === "LWPOLYLINE").map((e) => e.points);
  entities.forEach((e, i) => {
    if (e.kind !== "POLYLINE") return;
    const end = entities.findIndex((f, j) => j > i && f.kind !== "VERTEX");
    lists.push(entities.slice(i + 1, end < 0 ? undefined : end).flatMap((v) => v.points.slice(0, 1)));
  });
  const strokes = entities.filter((e) => e.kind === "LINE" && e.points.length === 2).flatMap((e) => e.points);
  if (strokes.length) lists.push(strokes);
  return (
    lists
      .filter((l) => l.every((p) => Number.isFinite(p[0]) && Number.isFinite(p[1])))
      .sort((a, b) => b.length - a.length)[0] ?? null
  );
}

/** The first polygon, polyline, rectangle or path; y turned up. */
export function svg_polyline(text: string): Point[] | null {
  const parsed = new DOMParser().parseFromString(text, "image/svg+xml"); // never shown, only read
  const shape = parsed.querySelector("polygon, polyline, path, rect");
  if (!shape) return null;
  const number = (name: string) => Number.parseFloat(shape.getAttribute(name) ?? "0") || 0;
  if (shape.localName === "rect") {
    const x = number("x"),
      y = number("y"),
      w = number("width"),
      h = number("height");
    return [
      [x, -y],
      [x, -y - h],
      [x + w, -y - h],
      [x + w, -y],
    ];
  }
  if (shape.localName === "path") return path_points(shape.getAttribute("d") ?? "");
  const values = (shape.getAttribute("points") ?? "").match(/-?[\d.]+(?:e[-+]?\d+)?/gi)?.map(Number) ?? [];
  return Array.from({length: values.length >> 1}, (_, i) => [values[2 * i]!, -values[2 * i + 1]!] as Point);
}
/** Corners exactly where there are only straight strokes, else evenly along the first closed stretch. */
function path_points(d: string): Point[] {
  const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
  path.setAttribute("d", d.split(/(?<=[zZ])/)[0]!);
  const length = path.getTotalLength();
  const exact = straight_points(d);
  if (exact) return exact;
  return Array.from({length: 96}, (_, i) => {
    const p = path.getPointAtLength((length * i) / 96);
    return [p.x, -p.y] as Point;
  });
}
export function straight_points(d: string): Point[] | null {
  const points: Point[] = [];
  let x = 0,
    y = 0;
  for (const [, command = "", rest = ""] of d.matchAll(/([a-zA-Z])([^a-zA-Z]*(?:e[-+]?\d+[^a-zA-Z]*)*)/g)) {
    const values = rest.match(/-?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?/gi)?.map(Number) ?? [];
    const relative = command === command.toLowerCase(),
      from = (at: number) => (relative ? at : 0);
    if (/[zZ]/.test(command)) return points;
    if (/[hH]/.test(command)) for (const v of values) points.push([(x = from(x) + v), -y]);
    else if (/[vV]/.test(command)) for (const v of values) points.push([x, -(y = from(y) + v)]);
    else if (/[mMlL]/.test(command)) {
      for (let i = 0; i + 1 < values.length; i += 2)
        points.push([(x = from(x) + values[i]!), -(y = from(y) + values[i + 1]!)]);
    } else return null;
  }
  return points;
}

function without_repeats(points: readonly Point[]): Point[] {
  const kept = points.filter(
    (p, i) => i === 0 || Math.hypot(p[0] - points[i - 1]![0], p[1] - points[i - 1]![1]) > 1e-9,
  );
  const [first] = kept,
    last = kept[kept.length - 1];
  return kept.length > 1 && first && last && Math.hypot(first[0] - last[0], first[1] - last[1]) <= 1e-9
    ? kept.slice(0, -1)
    : kept;
}
function reduced(points: Point[]): Point[] {
  const every = Math.ceil(points.length / most_corners);
  return points.filter((_, i) => i % every === 0);
}
/** Where the drawing's origin lies in or near the shape it is kept as the body's; a shape of quite another size is
 *  brought to the task's. */
function fitted_to(points: Point[], size: number): Point[] {
  const box = bounds(points)!,
    w = box.x[1] - box.x[0],
    h = box.y[1] - box.y[0],
    largest = Math.max(w, h);
  const factor = largest > 20 * size || largest < size / 20 ? size / largest : 1;
  const near = box.x[0] - w / 2 <= 0 && box.x[1] + w / 2 >= 0 && box.y[0] - h / 2 <= 0 && box.y[1] + h / 2 >= 0;
  const middle: Point = near ? [0, 0] : [(box.x[0] + box.x[1]) / 2, (box.y[0] + box.y[1]) / 2];
  const short = (value: number) => Number(value.toPrecision(9)) + 0;
  return points.map((p) => [short((p[0] - middle[0]) * factor), short((p[1] - middle[1]) * factor)]);
}
