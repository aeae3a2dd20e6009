// Numbers that stand on the drawing.
import {fixed} from "../texts/numbers";

/** As many decimals as the step has, or as one pixel is worth. */
export function length_note(value: number, step: number, unit: string): string {
  const decimals = Math.min(Math.max(-Math.floor(Math.log10(step) + 1e-9), 0), 9);
  const short = fixed(value, decimals + 1)
    .replace(/(\.\d*?)0+$/, "$1")
    .replace(/\.$/, "");
  return unit ? `${short} ${unit}` : short;
}
export function angle_note(value: number): string {
  return `${fixed(value, 3)
    .replace(/(\.\d*?)0+$/, "$1")
    .replace(/\.$/, "")}°`;
}
export function point_note(point: readonly [number, number], step: number, unit: string): string {
  return `x ${length_note(point[0], step, "")}  y ${length_note(point[1], step, unit)}`;
}
