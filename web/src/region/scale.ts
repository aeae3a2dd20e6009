// Places along a map axis and pixels along its edge: the one spot that knows of the gaps between blocks.

export const gap_px = 4;

export interface Stretch {
  from: number;
  to: number; // places
}
/** A visible part of a block. */
export interface Piece extends Stretch {
  block: number;
  start: number;
  end: number; // pixels
}
export interface Scale {
  size: number;
  pieces: Piece[];
  per_place: number; // pixels
}

export function make_scale(blocks: readonly Stretch[], window: readonly [number, number], size: number): Scale {
  const seen = blocks
    .map((block, index) => ({block: index, from: Math.max(block.from, window[0]), to: Math.min(block.to, window[1])}))
    .filter((piece) => piece.to > piece.from);
  const shown = seen.length > 0 ? seen : [{block: 0, from: window[0], to: window[1]}];
  const per_place = (size - gap_px * (shown.length - 1)) / shown.reduce((sum, piece) => sum + piece.to - piece.from, 0);
  let start = 0;
  const pieces = shown.map((piece) => {
    const end = start + (piece.to - piece.from) * per_place;
    const placed = {...piece, start, end};
    start = end + gap_px;
    return placed;
  });
  return {size, pieces, per_place};
}

/** Pixels from the axis' lower end; running on beyond the window. */
export function pixel_of(scale: Scale, place: number): number {
  const piece = scale.pieces.find((p) => place < p.to) ?? scale.pieces.at(-1);
  return piece === undefined ? 0 : piece.start + (place - piece.from) * scale.per_place;
}

/** Place under a pixel; in a gap the nearer edge, outside the axis its end. */
export function place_at(scale: Scale, pixel: number): number {
  const {pieces} = scale;
  let nearest = pieces[0],
    distance = Infinity;
  for (const piece of pieces) {
    const off = pixel < piece.start ? piece.start - pixel : pixel > piece.end ? pixel - piece.end : 0;
    if (off < distance) [nearest, distance] = [piece, off];
  }
  if (!nearest) return 0;
  const inside = Math.min(Math.max(pixel, nearest.start), nearest.end);
  const place = nearest.from + (inside - nearest.start) / scale.per_place;
  return Math.min(Math.max(place, nearest.from), last_within(nearest, pieces));
}

/** The upper end of a block is the lower end of the next one: a place on it would be drawn across the gap. */
function last_within(piece: Piece, pieces: Piece[]): number {
  const last = piece === pieces[pieces.length - 1];
  return last ? piece.to : piece.to - 1e-9 * (piece.to - piece.from);
}
