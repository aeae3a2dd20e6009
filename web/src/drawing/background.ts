// A picture behind the drawing: brought to a size that a problem file can carry.
import type {Point} from "../contract/messages";
import {placed, type Background} from "../state/problem";
import {to_user, type Viewport} from "./viewport";

const most_pixels = 1600,
  most_characters = 400_000;

export function is_picture(file: File): boolean {
  return /^image\/(png|jpeg|svg\+xml|webp)$/.test(file.type);
}
/** Only pictures that the file itself carries are shown. */
export function shown_image(background: Background | null | undefined): string | null {
  return background && /^data:image\/(png|jpeg|webp);base64,/.test(background.image) ? background.image : null;
}

/** The picture as a JPEG of at most 1600 px and about 400 kB, in the middle of the view; null where it cannot be read. */
export async function picture(file: File, view: Viewport): Promise<Background | null> {
  const image = await loaded(file);
  if (!image) return null;
  const aspect = image.naturalHeight / image.naturalWidth;
  const width = Math.min((0.8 * view.width) / view.scale, (0.8 * view.height) / view.scale / aspect);
  const [x, y] = to_user(view, [
    view.width / 2 - (width * view.scale) / 2,
    view.height / 2 + (width * aspect * view.scale) / 2,
  ]);
  const short = (value: number) => Number(value.toPrecision(6));
  return {image: small_jpeg(image), x: short(x), y: short(y), width: short(width), aspect, opacity: 0.5};
}
async function loaded(file: File): Promise<HTMLImageElement | null> {
  const image = new Image(),
    address = URL.createObjectURL(file);
  image.src = address;
  try {
    await image.decode();
    return image.naturalWidth > 0 && image.naturalHeight > 0 ? image : null;
  } catch {
    return null;
  } finally {
    URL.revokeObjectURL(address);
  }
}
function small_jpeg(image: HTMLImageElement): string {
  let size = Math.min(1, most_pixels / Math.max(image.naturalWidth, image.naturalHeight)),
    quality = 0.82,
    text = "";
  for (let tries = 0; tries < 6; ++tries) {
    const canvas = document.createElement("canvas"),
      pen = canvas.getContext("2d")!;
    canvas.width = Math.max(1, Math.round(image.naturalWidth * size));
    canvas.height = Math.max(1, Math.round(image.naturalHeight * size));
    pen.fillStyle = "#ffffff";
    pen.fillRect(0, 0, canvas.width, canvas.height);
    pen.drawImage(image, 0, 0, canvas.width, canvas.height);
    text = canvas.toDataURL("image/jpeg", quality);
    if (text.length <= most_characters) break;
    if (quality > 0.6) quality -= 0.15;
    else size *= 0.75;
  }
  return text;
}

export function center_of({x, y, width, aspect, angle_deg = 0}: Background): Point {
  return placed([width / 2, (width * aspect) / 2], {x, y, theta_deg: angle_deg});
}
/** Turned about its middle. */
export function turned(background: Background, angle_deg: number): Background {
  const {width, aspect} = background,
    middle = center_of(background);
  const [x, y] = placed([-width / 2, (-width * aspect) / 2], {x: middle[0], y: middle[1], theta_deg: angle_deg});
  return {...background, x, y, angle_deg};
}
/** Enlarged about its middle. */
export function widened(background: Background, width: number): Background {
  const middle = center_of(background),
    factor = width / background.width;
  return {
    ...background,
    width,
    x: middle[0] + (background.x - middle[0]) * factor,
    y: middle[1] + (background.y - middle[1]) * factor,
  };
}

/** The picture enlarged about the first of two of its points, so that they lie `length` apart. */
export function scaled(
  background: Background,
  marks: readonly (readonly [number, number])[],
  length: number,
): Background | null {
  const [a, b] = marks;
  if (!a || !b) return null;
  const now = Math.hypot(b[0] - a[0], b[1] - a[1]);
  if (!(now > 0) || !(length > 0) || !Number.isFinite(length)) return null;
  const factor = length / now;
  return {
    ...background,
    width: background.width * factor,
    x: a[0] + (background.x - a[0]) * factor,
    y: a[1] + (background.y - a[1]) * factor,
  };
}
