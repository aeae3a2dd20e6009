// The strokes of an SVG file. The library reads and transforms paths; which shapes are drawn, and where, is told by the tree,
// which is only read and never shown.
import svgpath from "svgpath";
import type {Point} from "../../contract/messages";
import {flattened, Refused, Strokes, type Drawn} from "./strokes";

type Matrix = readonly [number, number, number, number, number, number];
const most_nested = 100;
const mm_of: Record<string, number> = {mm: 1, cm: 10, in: 25.4, pt: 25.4 / 72, pc: 25.4 / 6, q: 0.25};
const never_drawn = new Set(["defs", "symbol", "clipPath", "mask", "pattern", "marker", "metadata", "title", "desc"]);

export function read_svg(text: string): Drawn {
  const root = document_element(text),
    strokes = new Strokes();
  draw_children(root, [view_of(root)], strokes, root, 0);
  const [width, height] = sheet_of(root);
  return {strokes: strokes.list, unit_mm: unit_of(root), sheet: width > 0 && height > 0 ? [width, height] : null};
}
function document_element(text: string): Element {
  let root: Element | null;
  try {
    const read = new DOMParser().parseFromString(text, "image/svg+xml");
    root = read.getElementsByTagName("parsererror").length === 0 ? read.documentElement : null;
  } catch {
    root = null;
  }
  if (root?.localName !== "svg") throw new Refused("unreadable");
  return root;
}

// ---- frames ---------------------------------------------------------------------------------------------------------

const number_of = (element: Element, name: string): number => Number.parseFloat(element.getAttribute(name) ?? "") || 0;
function numbers(text: string | null): number[] {
  return (text?.match(/[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?/gi) ?? []).map(Number);
}
function view_box(svg: Element): [number, number, number, number] | null {
  const [x, y, width, height] = numbers(svg.getAttribute("viewBox"));
  return x !== undefined && y !== undefined && width !== undefined && width > 0 && height !== undefined && height > 0
    ? [x, y, width, height]
    : null;
}
/** y turned up. The outermost frame keeps its own unit: what it is in millimetres is told apart. */
function view_of(root: Element): Matrix {
  const box = view_box(root);
  return [1, 0, 0, -1, box ? -box[0] : 0, box ? box[1] + box[3] : 0];
}
function sheet_of(root: Element): [number, number] {
  const box = view_box(root);
  return box ? [box[2], box[3]] : [number_of(root, "width"), number_of(root, "height")];
}
function unit_of(root: Element): number | null {
  const [, value, unit] = /^\s*([\d.eE+-]+)\s*([a-z]+)\s*$/i.exec(root.getAttribute("width") ?? "") ?? [],
    mm = mm_of[unit?.toLowerCase() ?? ""];
  const width = Number(value),
    box = view_box(root);
  if (mm === undefined || !(width > 0)) return null;
  return box ? (width * mm) / box[2] : 25.4 / 96;
}
/** Of an inner <svg>: where it lies in the outer one, and how much larger its unit is there. */
function inner_view(svg: Element): Matrix {
  const box = view_box(svg),
    [x, y, width, height] = [
      number_of(svg, "x"),
      number_of(svg, "y"),
      number_of(svg, "width"),
      number_of(svg, "height"),
    ];
  if (!box || !(width > 0) || !(height > 0)) return [1, 0, 0, 1, x, y];
  const scale = Math.min(width / box[2], height / box[3]);
  return [
    scale,
    0,
    0,
    scale,
    x + (width - scale * box[2]) / 2 - scale * box[0],
    y + (height - scale * box[3]) / 2 - scale * box[1],
  ];
}

// ---- shapes ---------------------------------------------------------------------------------------------------------

type Frame = Matrix | string; // of a transform attribute
/** `frames`: the innermost first, as a path takes them. */
function draw_children(of: Element, frames: readonly Frame[], strokes: Strokes, root: Element, nested: number): void {
  if (nested > most_nested) throw new Refused("huge");
  for (let child = of.firstChild; child; child = child.nextSibling)
    if (child.nodeType === 1) draw_element(child as Element, frames, strokes, root, nested);
}
function draw_element(
  element: Element,
  outer: readonly Frame[],
  strokes: Strokes,
  root: Element,
  nested: number,
): void {
  strokes.step();
  if (never_drawn.has(element.localName) || is_hidden(element)) return;
  const transform = element.getAttribute("transform"),
    frames = transform ? [transform, ...outer] : outer;
  if (element.localName === "g" || element.localName === "a" || element.localName === "switch")
    return draw_children(element, frames, strokes, root, nested + 1);
  if (element.localName === "svg")
    return draw_children(element, [inner_view(element), ...frames], strokes, root, nested + 1);
  if (element.localName === "use") return draw_use(element, frames, strokes, root, nested);
  const path = path_of(element);
  if (path) draw_path(path, frames, strokes);
}
function is_hidden(element: Element): boolean {
  const style = element.getAttribute("style") ?? "";
  return (
    element.getAttribute("display") === "none" ||
    element.getAttribute("visibility") === "hidden" ||
    /(?:^|;)\s*(?:display\s*:\s*none|visibility\s*:\s*hidden)/.test(style)
  );
}
function draw_use(use: Element, frames: readonly Frame[], strokes: Strokes, root: Element, nested: number): void {
  const address = use.getAttribute("href") ?? use.getAttribute("xlink:href") ?? "",
    used = address.startsWith("#") ? root.ownerDocument.getElementById(address.slice(1)) : null;
  if (!used) return;
  if (nested > most_nested) throw new Refused("huge"); // it may use itself
  const moved = [`translate(${number_of(use, "x")} ${number_of(use, "y")})`, ...frames];
  if (used.localName === "symbol") draw_children(used, moved, strokes, root, nested + 1);
  else draw_element(used, moved, strokes, root, nested + 1);
}

function path_of(element: Element): string | null {
  const number = (name: string) => number_of(element, name);
  switch (element.localName) {
    case "path":
      return element.getAttribute("d");
    case "rect":
      return rect_path(element);
    case "circle":
      return ellipse_path(number("cx"), number("cy"), number("r"), number("r"));
    case "ellipse":
      return ellipse_path(number("cx"), number("cy"), number("rx"), number("ry"));
    case "line":
      return `M${number("x1")} ${number("y1")}L${number("x2")} ${number("y2")}`;
    case "polyline":
    case "polygon": {
      const list = numbers(element.getAttribute("points")),
        even = list.slice(0, list.length - (list.length % 2));
      return even.length < 4 ? null : `M${even.join(" ")}${element.localName === "polygon" ? "Z" : ""}`;
    }
    default:
      return null;
  }
}
function ellipse_path(x: number, y: number, rx: number, ry: number): string | null {
  if (!(rx > 0) || !(ry > 0)) return null;
  return `M${x + rx} ${y}A${rx} ${ry} 0 0 1 ${x - rx} ${y}A${rx} ${ry} 0 0 1 ${x + rx} ${y}Z`;
}
function rect_path(rect: Element): string | null {
  const [x, y, w, h] = [
    number_of(rect, "x"),
    number_of(rect, "y"),
    number_of(rect, "width"),
    number_of(rect, "height"),
  ];
  if (!(w > 0) || !(h > 0)) return null;
  const rx = Math.min(number_of(rect, "rx") || number_of(rect, "ry"), w / 2),
    ry = Math.min(number_of(rect, "ry") || rx, h / 2);
  if (!(rx > 0) || !(ry > 0)) return `M${x} ${y}h${w}v${h}h${-w}Z`;
  const corner = (dx: number, dy: number) => `a${rx} ${ry} 0 0 1 ${dx} ${dy}`;
  return (
    `M${x + rx} ${y}h${w - 2 * rx}${corner(rx, ry)}v${h - 2 * ry}${corner(-rx, ry)}` +
    `h${2 * rx - w}${corner(-rx, -ry)}v${2 * ry - h}${corner(rx, -ry)}Z`
  );
}

// ---- paths ----------------------------------------------------------------------------------------------------------

function draw_path(d: string, frames: readonly Frame[], strokes: Strokes): void {
  let path = svgpath(d).unarc(); // first: a mirrored arc would turn the wrong way
  for (const frame of frames) path = typeof frame === "string" ? path.transform(frame) : path.matrix([...frame]);
  let points: Point[] = [];
  const end = (closed: boolean) => {
    strokes.add(points, closed);
    points = [];
  };
  const go = (...next: Point[]) => {
    strokes.step();
    points.push(...next);
  };
  path
    .abs()
    .unshort()
    .iterate((segment, _, x, y) => {
      const start: Point = [x, y];
      if (segment[0] !== "M" && points.length === 0) points.push(start); // after Z
      switch (segment[0]) {
        case "M":
          end(false);
          return go([segment[1], segment[2]]);
        case "L":
          return go([segment[1], segment[2]]);
        case "H":
          return go([segment[1], y]);
        case "V":
          return go([x, segment[1]]);
        case "C":
          return go(...bezier([start, [segment[1], segment[2]], [segment[3], segment[4]], [segment[5], segment[6]]]));
        case "Q":
          return go(...bezier([start, [segment[1], segment[2]], [segment[3], segment[4]]]));
        case "Z":
        case "z":
          return end(true);
      }
    });
  end(false);
}
/** Without its start. */
function bezier(controls: readonly Point[]): Point[] {
  const at = (t: number): Point => {
    let row = controls;
    while (row.length > 1)
      row = row.slice(1).map((b, i): Point => {
        const a = row[i] ?? b;
        return [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t];
      });
    return row[0] ?? [NaN, NaN];
  };
  return flattened(at, 0, 1).slice(1);
}
