// Hatching of defect cells, in screen pixels: per cell it would make moiré.
import type {DefectKind} from "./painter";
import {css, type Palette} from "./palette";

const tile = 8; // CSS pixels

function tile_context(ratio: number, palette: Palette): [HTMLCanvasElement, CanvasRenderingContext2D] {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = Math.round(tile * ratio);
  const context = canvas.getContext("2d")!;
  context.scale(canvas.width / tile, canvas.width / tile);
  context.fillStyle = css(palette.defect);
  context.fillRect(0, 0, tile, tile);
  context.strokeStyle = context.fillStyle = css(palette.hatch);
  context.lineWidth = 1.4;
  return [canvas, context];
}
function strokes(context: CanvasRenderingContext2D, rising: boolean): void {
  context.beginPath();
  for (const shift of [-tile, 0, tile]) {
    context.moveTo(shift - 1, rising ? tile + 1 : -1);
    context.lineTo(shift + tile + 1, rising ? -1 : tile + 1);
  }
  context.stroke();
}
function dots(context: CanvasRenderingContext2D): void {
  context.beginPath();
  for (const [x, y] of [
    [2, 2],
    [6, 6],
  ] as const) {
    context.moveTo(x + 1.1, y);
    context.arc(x, y, 1.1, 0, 2 * Math.PI);
  }
  context.fill();
}

/** Tile for a kind of defect: circuit ////, branch \\\\, order ····; kind 0 serves them all. */
export function hatch_tile(kind: DefectKind, ratio: number, palette: Palette): HTMLCanvasElement {
  const [canvas, context] = tile_context(ratio, palette);
  if (kind === 1) dots(context);
  else strokes(context, kind !== 2);
  return canvas;
}
