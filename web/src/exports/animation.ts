// An animated GIF of a picture: made in pieces, so that the page stays alive and the user can stop it.
import type {Frame} from "./frames";
import {paint_picture, type Picture} from "./picture";

export interface Progress {
  /** Done so far, 0 to 1. */
  done(share: number): void;
  signal: AbortSignal;
}
const changed_only = 127; // palette index that leaves a pixel as the frame before had it

/** Lets the page do other things; throws when the user has stopped the work. Unlike timers, messages are not slowed down in
 *  a hidden tab. */
export async function breathe({signal}: Progress): Promise<void> {
  const {port1, port2} = new MessageChannel();
  await new Promise((resolve) => {
    port1.onmessage = resolve;
    port2.postMessage(null);
  });
  port1.close();
  signal.throwIfAborted();
}
export function canvas_for({
  width,
  height,
}: {
  width: number;
  height: number;
}): [HTMLCanvasElement, CanvasRenderingContext2D] {
  const canvas = document.createElement("canvas");
  canvas.width = width;
  canvas.height = height;
  return [canvas, canvas.getContext("2d", {willReadFrequently: true})!];
}

export async function animated_gif(picture: Picture, frames: readonly Frame[], progress: Progress): Promise<Blob> {
  const {GIFEncoder, applyPalette, quantize} = await import("gifenc");
  const {width, height} = picture,
    [, context] = canvas_for(picture);
  const pixels = (angle: number) => {
    paint_picture(context, picture, angle);
    return context.getImageData(0, 0, width, height).data;
  };
  // One palette for all frames: everything that is ever on show is there in the first, the middle and the last.
  const sample = (i: number) => pixels(frames[i]!.angle).slice();
  const first = sample(0),
    both = new Uint8ClampedArray(first.length * 2);
  both.set(first);
  both.set(sample(Math.floor(frames.length / 2)), first.length);
  const palette = quantize(both, changed_only);
  while (palette.length <= changed_only) palette.push([0, 0, 0]);
  const encoder = GIFEncoder();
  let before: Uint8Array | null = null;
  for (const [i, frame] of frames.entries()) {
    await breathe(progress);
    const index = applyPalette(pixels(frame.angle), palette.slice(0, changed_only));
    encoder.writeFrame(before ? only_changes(before, index) : index, width, height, {
      palette: i === 0 ? palette : undefined,
      delay: frame.ms,
      repeat: 0,
      transparent: i > 0,
      transparentIndex: changed_only,
      dispose: 1,
    });
    before = index;
    progress.done((i + 1) / frames.length);
  }
  encoder.finish();
  return new Blob([encoder.bytes() as Uint8Array<ArrayBuffer>], {type: "image/gif"});
}
export function only_changes(before: Uint8Array, now: Uint8Array): Uint8Array {
  return now.map((color, i) => (color === before[i] ? changed_only : color));
}
