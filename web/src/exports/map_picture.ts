// The map for paper: by type, hatched where defects are, with the place of one linkage.
import type {Axes, MapAnswer, TauPair} from "../contract/messages";
import {hatch_tile} from "../region/hatching";
import {paint_types, put, sized_bitmap} from "../region/painter";
import {css, read_palette} from "../region/palette";

const pixels = 720;

/** Draws into the canvas what `map` shows; `place` by the axes' places. */
export function draw_map(canvas: HTMLCanvasElement, map: MapAnswer, axes: Axes, place: TauPair | null): void {
  const palette = read_palette();
  canvas.width = canvas.height = pixels;
  const context = canvas.getContext("2d")!;
  context.fillStyle = context.createPattern(hatch_tile(0, 1.5, palette), "repeat")!;
  context.fillRect(0, 0, pixels, pixels);
  const bitmap = sized_bitmap(null, map);
  paint_types(map, {palette, only_meeting: false, type_hover: null}, bitmap.words);
  put(bitmap);
  context.imageSmoothingEnabled = Math.min(map.rows, map.columns) > pixels;
  context.drawImage(bitmap.canvas, 0, 0, pixels, pixels);
  const at = (value: number, [from, to]: readonly [number, number]) => ((value - from) / (to - from)) * pixels;
  context.fillStyle = css(palette.paper);
  for (const {from} of axes.output.blocks.slice(1)) context.fillRect(at(from, map.window.output) - 3, 0, 6, pixels);
  for (const {from} of axes.input.blocks.slice(1))
    context.fillRect(0, pixels - at(from, map.window.input) - 3, pixels, 6);
  if (place) cross(context, at(place[1], map.window.output), pixels - at(place[0], map.window.input));
}
function cross(context: CanvasRenderingContext2D, x: number, y: number): void {
  const style = getComputedStyle(document.documentElement);
  context.lineWidth = 3;
  for (const [name, line] of [
    ["input", [0, y, pixels, y]],
    ["output", [x, 0, x, pixels]],
  ] as const) {
    context.strokeStyle = style.getPropertyValue(`--${name}`);
    context.beginPath();
    context.moveTo(line[0], line[1]);
    context.lineTo(line[2], line[3]);
    context.stroke();
  }
  context.strokeStyle = style.getPropertyValue("--ink");
  context.fillStyle = style.getPropertyValue("--paper");
  context.beginPath();
  context.arc(x, y, 10, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
}
