// A pivot that slides along its curve: which place of the curve a pointer means.
import type {Point} from "../contract/messages";
import {
  nearest,
  next_in,
  previous_in,
  run_of,
  sample_at,
  spot_at,
  through_infinity,
  type CurveName,
  type CurveSamples,
  type Run,
  type Spot,
} from "./curve_samples";
import type {Viewport} from "./viewport";

/** Outside of the window: the stretch of curve that lies beyond the edge where the pivot left. */
export interface Beyond {
  run: Run;
  index: number;
  forward: boolean;
  count: number; // segments until the curve is back in the window
}
const jump_px = 24; // another stretch must be so much nearer before the pivot jumps to it
const neighbourhood = 0.12; // of the branch
const beyond_px = 160; // the pointer's way outside that takes the pivot through infinity to the other side

/** How far outside of the window a point lies. */
export function overshoot(view: Viewport, at: Point): number {
  return Math.hypot(Math.max(-at[0], at[0] - view.width, 0), Math.max(-at[1], at[1] - view.height, 0));
}
function in_window(view: Viewport, p: Point | null): boolean {
  return p !== null && overshoot(view, p) === 0;
}

/** The next place of a pivot that was at `from`. */
export function slid(samples: CurveSamples, curve: CurveName, view: Viewport, at: Point, from: Spot): Spot {
  const run = run_of(samples, from.index);
  const anywhere = nearest(samples, curve, view, at);
  if (!run || !anywhere) return from;
  const size = run.to - run.from,
    most = Math.max(size * neighbourhood, 3);
  const near = nearest(samples, curve, view, at, (r, a) => {
    const apart = Math.abs(a - from.index);
    return r === run && Math.min(apart, size - apart) <= most;
  });
  return near && near.distance <= anywhere.distance + jump_px ? near : anywhere;
}

/** Where the curve leaves the window beside a pointer that has left it. */
export function beyond_edge(
  samples: CurveSamples,
  curve: CurveName,
  view: Viewport,
  at: Point,
  from: Spot,
): Beyond | null {
  const edge: Point = [Math.min(Math.max(at[0], 0), view.width), Math.min(Math.max(at[1], 0), view.height)];
  const start = slid(samples, curve, view, edge, from),
    run = run_of(samples, start.index);
  if (!run) return null;
  const ways = [true, false].map((forward) => {
    const step = (i: number) => (forward ? next_in(run, i) : previous_in(run, i));
    let index = start.index,
      guard = run.to - run.from;
    while (guard-- > 0 && in_window(view, sample_at(samples, curve, index, view))) index = step(index);
    const last = sample_at(samples, curve, forward ? previous_in(run, index) : next_in(run, index), view);
    let count = 0;
    for (let i = index; count < run.to - run.from && !in_window(view, sample_at(samples, curve, i, view)); i = step(i))
      ++count;
    return {
      run,
      index,
      forward,
      count,
      distance: last && guard > 0 ? Math.hypot(last[0] - edge[0], last[1] - edge[1]) : Infinity,
    };
  });
  const [best] = ways.sort((a, b) => a.distance - b.distance);
  return best && best.distance < 60 && best.count < run.to - run.from ? best : null;
}
/** The place that an overshoot means on the stretch beyond. */
export function beyond_spot(samples: CurveSamples, curve: CurveName, beyond: Beyond, over: number): Spot {
  const {run, forward} = beyond,
    size = run.to - run.from;
  const steps = Math.min(over / beyond_px, 1) * beyond.count;
  const offset = beyond.index - run.from + (forward ? steps : -steps);
  const wrapped = ((offset % size) + size) % size,
    whole = Math.min(Math.floor(wrapped), size - 1);
  return spot_at(samples, curve, run, run.from + whole, wrapped - whole);
}

/** A step of so many pixels along the curve (for the arrow keys); across infinity it goes on at the next sample. */
export function stepped(samples: CurveSamples, curve: CurveName, view: Viewport, from: Spot, pixels: number): Spot {
  const run = run_of(samples, from.index);
  if (!run) return from;
  let {index, share} = from,
    left = Math.abs(pixels);
  const forward = pixels > 0;
  for (let guard = run.to - run.from; guard > 0; --guard) {
    const p = sample_at(samples, curve, index, view),
      q = sample_at(samples, curve, next_in(run, index), view);
    const length =
      p && q && !through_infinity(samples, curve, index, next_in(run, index))
        ? Math.hypot(q[0] - p[0], q[1] - p[1])
        : 0;
    const room = (forward ? 1 - share : share) * length;
    if (room > left) return spot_at(samples, curve, run, index, share + ((forward ? 1 : -1) * left) / length);
    left -= room;
    index = forward ? next_in(run, index) : previous_in(run, index);
    share = forward ? 0 : 1;
  }
  return from;
}
