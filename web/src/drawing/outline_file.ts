// An outline out of a drawing of another program, SVG or DXF: which shapes it has, and one of them as the body.
import type {Point} from "../contract/messages";
import {Refused, type Drawn, type Refusal} from "./outlines/strokes";
import {shapes_of, simplified, type Shape} from "./outlines/shapes";
import {bounds} from "./viewport";

const most_bytes = 16e6;

export interface Shapes {
  /** One at least. */
  shapes: readonly Shape[];
  /** Millimetres to a unit of the file, where it says. */
  unit_mm: number | null;
}
export function is_outline_file(file: File, svg_too: boolean): boolean {
  return /\.dxf$/i.test(file.name) || (svg_too && (/\.svg$/i.test(file.name) || file.type === "image/svg+xml"));
}
export async function read_outlines(file: File): Promise<Shapes | Refusal> {
  return file.size > most_bytes ? "huge" : outlines_in(file.name, await file.text());
}
export async function outlines_in(name: string, text: string): Promise<Shapes | Refusal> {
  try {
    const drawn = await drawn_in(name, text),
      shapes = shapes_of(drawn);
    return shapes.length ? {shapes, unit_mm: drawn.unit_mm} : "none";
  } catch (error) {
    if (error instanceof Refused) return error.why;
    if (error instanceof RangeError) return "huge"; // nested deeper than the stack
    throw error;
  }
}
/** The libraries come only when they are wanted. */
async function drawn_in(name: string, text: string): Promise<Drawn> {
  if (/\.dxf$/i.test(name)) return (await import("./outlines/dxf")).read_dxf(text);
  return (await import("./outlines/svg")).read_svg(text);
}

/** The names that the program knows, in small letters (length_unit.cpp). */
const unit_names: readonly [number, string][] = [
  [1e-3, "µm μm um micron microns micrometre micrometres micrometer micrometers 微米"],
  [1, "mm millimetre millimetres millimeter millimeters 毫米"],
  [10, "cm centimetre centimetres centimeter centimeters 厘米"],
  [100, "dm decimetre decimetres decimeter decimeters 分米"],
  [1000, "m metre metres meter meters 米"],
  [1e6, "km kilometre kilometres kilometer kilometers 千米"],
  [25.4e-6, "µin μin uin microinch microinches"],
  [0.0254, "mil mils thou"],
  [25.4, 'in inch inches " ″ ” 英寸'],
  [304.8, "ft foot feet ' ′ ’ 英尺"],
  [914.4, "yd yard yards 码"],
  [1609344, "mi mile miles 英里"],
];
/** Millimetres to a unit by its name; nothing where it is not known. */
export function mm_of_unit(unit: string): number | undefined {
  const name = unit.trim().toLowerCase().replace(/\.$/, "");
  return unit_names.find(([, names]) => names.split(" ").includes(name))?.[0];
}
/** Units of the task to a unit of the file; 1 where one of the two is not known. */
export function unit_factor(unit_mm: number | null, unit: string): number {
  const task_mm = mm_of_unit(unit);
  return unit_mm === null || task_mm === undefined ? 1 : unit_mm / task_mm;
}

/** Corners in body coordinates. Where the drawing's origin lies in or near the shape it is kept as the body's; a shape of
 *  quite another size is brought to the task's. */
export function body_of({points}: Shape, factor: number, size: number): Point[] {
  const box = bounds(points),
    [w, h] = box ? [box.x[1] - box.x[0], box.y[1] - box.y[0]] : [0, 0];
  if (!box) return [];
  const largest = factor * Math.max(w, h),
    scale = largest > 20 * size || largest < size / 20 ? (factor * size) / largest : factor;
  const near = box.x[0] - w / 2 <= 0 && box.x[1] + w / 2 >= 0 && box.y[0] - h / 2 <= 0 && box.y[1] + h / 2 >= 0;
  const [mx, my] = near ? [0, 0] : [(box.x[0] + box.x[1]) / 2, (box.y[0] + box.y[1]) / 2];
  const short = (value: number) => Number(value.toPrecision(9)) + 0;
  return simplified(points).map(([x, y]) => [short((x - mx) * scale), short((y - my) * scale)]);
}
