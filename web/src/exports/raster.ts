import {css_values} from "../state/css_values";

/** An SVG text as an image the browser has read. */
export async function svg_image(svg: string): Promise<HTMLImageElement> {
  const image = new Image();
  image.src = URL.createObjectURL(new Blob([svg], {type: "image/svg+xml"}));
  try {
    await image.decode();
  } finally {
    URL.revokeObjectURL(image.src);
  }
  return image;
}
/** The same as PNG, `times` as many pixels each way. */
export async function rasterised(svg: string, times: number): Promise<Blob> {
  const image = await svg_image(svg);
  return png_of(image, Math.round(times * image.naturalWidth), Math.round(times * image.naturalHeight));
}
const stage_canvas = () => document.querySelector<HTMLCanvasElement>(".solid canvas, canvas[data-picture]");
export function has_stage_picture(): boolean {
  return stage_canvas() !== null;
}
/** What the picture in space shows, as PNG on a ground, with the texts that lie over it. Rejects where there is none. */
export async function stage_picture(): Promise<Blob> {
  const canvas = stage_canvas();
  if (!canvas) throw new Error("no picture");
  const {paper} = css_values(document.documentElement, ["paper"]);
  return png_of(canvas, canvas.width, canvas.height, paper, (context) => write_labels(context, canvas));
}
function write_labels(context: CanvasRenderingContext2D, canvas: HTMLCanvasElement): void {
  const box = canvas.getBoundingClientRect(),
    scale = canvas.width / box.width;
  for (const label of canvas.parentElement?.querySelectorAll("[data-label]") ?? []) {
    const {left, top, width, height} = label.getBoundingClientRect(),
      {fontStyle, fontWeight, fontSize, fontFamily, color, backgroundColor} = getComputedStyle(label),
      at = [scale * (left + width / 2 - box.left), scale * (top + height / 2 - box.top)] as const;
    context.fillStyle = backgroundColor;
    context.beginPath();
    context.arc(...at, (scale * Math.min(width, height)) / 2, 0, 2 * Math.PI);
    context.fill();
    context.font = `${fontStyle} ${fontWeight} ${scale * parseFloat(fontSize)}px ${fontFamily}`;
    [context.textAlign, context.textBaseline, context.fillStyle] = ["center", "middle", color];
    context.fillText(label.textContent ?? "", ...at);
  }
}
function png_of(
  source: CanvasImageSource,
  width: number,
  height: number,
  ground: string | null = null,
  over: (context: CanvasRenderingContext2D) => void = () => {},
): Promise<Blob> {
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [width, height];
  const context = canvas.getContext("2d")!;
  if (ground) {
    context.fillStyle = ground;
    context.fillRect(0, 0, width, height);
  }
  context.drawImage(source, 0, 0, width, height);
  over(context);
  return new Promise((resolve, reject) =>
    canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("no picture"))), "image/png"),
  );
}
