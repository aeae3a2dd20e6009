// A film of a picture, MP4 or WebM: frame by frame through the browser's own encoder, as fast as that goes.
import type {VideoCodec} from "mediabunny";
import type {Drive} from "../contract/messages";
import {played_span} from "../transport/play";
import {breathe, canvas_for, type Progress} from "./animation";
import type {FilmForm} from "./film_form.svelte";
import {one_way_ms, rest_ms} from "./frames";
import {paint_picture, type Picture} from "./picture";

export const containers = ["mp4", "webm"] as const;
export type Container = (typeof containers)[number];
export const film_types: Record<Container, string> = {mp4: "video/mp4", webm: "video/webm"};
const codecs: Record<Container, readonly VideoCodec[]> = {mp4: ["avc", "vp9", "av1"], webm: ["vp9", "vp8"]};

/** Why a film cannot be made; keys of the texts, after "export.". */
export type Hindrance = "film_insecure" | "film_no_encoder" | "film_no_codec";

/** Browsers hide the encoder from pages that come over plain HTTP from another machine. */
export function film_hindrance(): Hindrance | null {
  if (typeof VideoEncoder !== "undefined") return null;
  return globalThis.isSecureContext === false ? "film_insecure" : "film_no_encoder";
}
/** The first codec of a kind of film that this browser encodes at this size; in MP4 one besides H.264 only if it plays it. */
export async function film_codec(container: Container, {width, height, rate}: FilmForm): Promise<VideoCodec | null> {
  if (film_hindrance()) return null;
  const {canEncodeVideo, QUALITY_HIGH} = await import("mediabunny");
  for (const codec of codecs[container])
    if (
      (await canEncodeVideo(codec, {width, height, frameRate: rate, quality: QUALITY_HIGH})) &&
      (container !== "mp4" || codec === "avc" || plays_in_mp4(codec))
    )
      return codec;
  return null;
}
function plays_in_mp4(codec: VideoCodec): boolean {
  const name = codec === "vp9" ? "vp09.00.31.08" : "av01.0.05M.08";
  return document.createElement("video").canPlayType(`video/mp4; codecs="${name}"`) === "probably";
}

/** Driver angles of the frames of one loop: a turn where the driver goes round, else there and back with a rest at each end. */
export function film_angles(drive: Drive, whole: boolean, rate: number): number[] {
  const [low, high] = played_span(drive, whole),
    one_way = Math.round((rate * (whole ? 2 : 1) * one_way_ms) / 1000),
    rest = Math.round((rate * rest_ms) / 1000);
  const between = (count: number) => Array.from({length: count}, (_, i) => low + ((high - low) * i) / count);
  if (whole && drive.full_turn) return between(one_way);
  const there = between(one_way),
    back = there.map((angle) => low + high - angle);
  return [...Array<number>(rest).fill(low), ...there, ...Array<number>(rest).fill(high), ...back];
}

/** `scale`: pixels of the film to a pixel of the picture. */
export async function film(
  picture: Picture,
  angles: readonly number[],
  scale: number,
  container: Container,
  form: FilmForm,
  progress: Progress,
): Promise<Blob> {
  const codec = await film_codec(container, form);
  if (!codec) throw new Error("no encoder");
  const {BufferTarget, CanvasSource, Mp4OutputFormat, Output, QUALITY_HIGH, WebMOutputFormat} =
    await import("mediabunny");
  const [canvas, context] = canvas_for(form);
  context.setTransform(scale, 0, 0, scale, 0, 0);
  const source = new CanvasSource(canvas, {codec, quality: QUALITY_HIGH}),
    format = container === "mp4" ? new Mp4OutputFormat({fastStart: "in-memory"}) : new WebMOutputFormat(),
    output = new Output({format, target: new BufferTarget()});
  output.addVideoTrack(source, {frameRate: form.rate});
  try {
    await output.start();
    for (const [i, angle] of angles.entries()) {
      paint_picture(context, picture, angle);
      await source.add(i / form.rate, 1 / form.rate);
      await breathe(progress);
      progress.done((i + 1) / angles.length);
    }
    await output.finalize();
  } catch (error) {
    await output.cancel();
    throw error;
  }
  const bytes = output.target.buffer;
  if (!bytes) throw new Error("no film");
  return new Blob([bytes], {type: film_types[container]});
}
