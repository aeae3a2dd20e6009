// Bodies to start from, sized to the task. The moving frame's origin lies where one would measure from.
import type {Point} from "../contract/messages";
import {multiple} from "./snapping";

export const preset_names = ["rectangle", "door", "lid", "bucket", "wing"] as const;
export type PresetName = (typeof preset_names)[number];

// One unit long.
const shapes: Record<PresetName, readonly Point[]> = {
  rectangle: [
    [-0.5, -0.17],
    [0.5, -0.17],
    [0.5, 0.17],
    [-0.5, 0.17],
  ],
  door: [
    [0, -0.03],
    [1, -0.03],
    [1, 0.03],
    [0.92, 0.07],
    [0.08, 0.07],
    [0, 0.03],
  ],
  lid: [
    [-0.06, -0.22],
    [0, 0],
    [0.26, 0.62],
    [0.35, 0.78],
    [0.4, 0.76],
    [0.32, 0.56],
    [0.06, -0.02],
    [0.02, -0.22],
  ],
  bucket: [
    [-0.5, 0.3],
    [-0.42, -0.12],
    [-0.2, -0.3],
    [0.2, -0.3],
    [0.5, 0.02],
    [0.44, 0.06],
    [0.16, -0.22],
    [-0.17, -0.22],
    [-0.34, -0.08],
    [-0.42, 0.3],
  ],
  wing: [
    [-0.3, 0],
    [-0.26, 0.06],
    [-0.1, 0.1],
    [0.2, 0.08],
    [0.7, 0],
    [0.2, -0.02],
    [-0.15, -0.05],
  ],
};

export function preset(name: PresetName, size: number): Point[] {
  const unit = 10 ** (Math.floor(Math.log10(size)) - 2);
  return shapes[name].map(([x, y]) => [multiple(x * size, unit), multiple(y * size, unit)]);
}
