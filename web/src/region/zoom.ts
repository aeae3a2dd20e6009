// Parts of the region: zooming, panning and boxes in places of the two axes.
import {whole, type TauPair, type MapWindow} from "../contract/messages";

export const least_width = 1e-7;
type Span = readonly [number, number];

function width(span: Span): number {
  return span[1] - span[0];
}
function held(from: number, to: number): Span {
  const wide = Math.min(Math.max(to - from, least_width), 1);
  const start = Math.min(Math.max(from, 0), 1 - wide);
  return [start, start + wide];
}
function window_of(input: Span, output: Span): MapWindow {
  return width(input) > 1 - 1e-9 && width(output) > 1 - 1e-9 ? whole : {input, output};
}

/** The part `factor` times as wide, the given places (input, output) staying under the pointer. */
export function zoomed(window: MapWindow, at: TauPair, factor: number): MapWindow {
  const scaled = (span: Span, place: number): Span => {
    const ratio = Math.min(Math.max(width(span) * factor, least_width), 1) / width(span);
    return held(place - (place - span[0]) * ratio, place + (span[1] - place) * ratio);
  };
  return window_of(scaled(window.input, at[0]), scaled(window.output, at[1]));
}

/** Moved by shares of its own width. */
export function panned(window: MapWindow, input: number, output: number): MapWindow {
  const moved = (span: Span, share: number): Span => held(span[0] + share * width(span), span[1] + share * width(span));
  return window_of(moved(window.input, input), moved(window.output, output));
}

/** The part between two places (input, output). */
export function boxed(a: TauPair, b: TauPair): MapWindow {
  const span = (i: 0 | 1): Span => held(Math.min(a[i], b[i]), Math.max(a[i], b[i]));
  return window_of(span(0), span(1));
}

/** Moved as little as needed to show a place. */
export function showing(window: MapWindow, place: TauPair): MapWindow {
  const shifted = (span: Span, at: number): Span => {
    if (at >= span[0] && at <= span[1]) return span;
    const margin = 0.1 * width(span);
    return at < span[0] ? held(at - margin, at - margin + width(span)) : held(at + margin - width(span), at + margin);
  };
  const input = shifted(window.input, place[0]),
    output = shifted(window.output, place[1]);
  return input === window.input && output === window.output ? window : window_of(input, output);
}

export function magnification(window: MapWindow): number {
  return 1 / Math.sqrt(width(window.input) * width(window.output));
}
export function same_window(a: MapWindow, b: MapWindow): boolean {
  return (
    a === b ||
    (a.input[0] === b.input[0] &&
      a.input[1] === b.input[1] &&
      a.output[0] === b.output[0] &&
      a.output[1] === b.output[1])
  );
}
