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
/** What a canvas shows, as PNG on a ground. */
export function copied(canvas: HTMLCanvasElement, ground: string): Promise<Blob> {
  return png_of(canvas, canvas.width, canvas.height, ground);
}
function png_of(source: CanvasImageSource, width: number, height: number, ground: string | null = null): Promise<Blob> {
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [width, height];
  const context = canvas.getContext("2d")!;
  if (ground) {
    context.fillStyle = ground;
    context.fillRect(0, 0, width, height);
  }
  context.drawImage(source, 0, 0, width, height);
  return new Promise((resolve, reject) =>
    canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("no picture"))), "image/png"),
  );
}
