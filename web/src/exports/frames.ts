// Which driver angles an animation shows, and for how long each: there over the task in two seconds, a rest, and back.
import type {Drive} from "../contract/messages";
import {played_span} from "../transport/play";

export interface Frame {
  angle: number;
  ms: number;
}
export const frame_ms = 50,
  one_way_ms = 2000,
  rest_ms = 500;

/** A full turn goes round; any other stretch goes there and back. Times are whole hundredths of a second, as GIF counts. */
export function animation_frames(drive: Drive, whole: boolean): Frame[] {
  const [low, high] = played_span(drive, whole);
  const steps = (whole ? 2 : 1) * (one_way_ms / frame_ms);
  const angles = Array.from({length: steps + 1}, (_, i) => (i === steps ? high : low + ((high - low) * i) / steps));
  if (whole && drive.full_turn) return angles.slice(0, -1).map((angle) => ({angle, ms: frame_ms}));
  const there = angles.map((angle, i) => ({angle, ms: i === 0 || i === steps ? rest_ms : frame_ms}));
  const back = angles
    .slice(1, -1)
    .reverse()
    .map((angle) => ({angle, ms: frame_ms}));
  return [...there, ...back];
}
