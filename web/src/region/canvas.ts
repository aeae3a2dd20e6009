/** Gives a canvas so many device pixels, and tells how many. Setting a size empties a canvas: one that has it is left alone. */
export function size_canvas(
  canvas: Pick<HTMLCanvasElement, "width" | "height">,
  width: number,
  height: number,
  ratio: number,
): [wide: number, high: number] {
  const wide = Math.round(width * ratio),
    high = Math.round(height * ratio);
  if (canvas.width !== wide) canvas.width = wide;
  if (canvas.height !== high) canvas.height = high;
  return [wide, high];
}
