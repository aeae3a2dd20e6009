// Places on the map's axes and curve coordinates, as the engine's axis tells them.
import type {Axis, AxisBlock, Branch, TauPair} from "../engine/protocol";

function interpolated(knots: readonly (readonly [number, number])[], value: number, from: 0 | 1): number {
  const to = from === 0 ? 1 : 0;
  const rising = knots[knots.length - 1][from] > knots[0][from];
  let low = 0, high = knots.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (knots[middle][from] <= value === rising) low = middle;
    else high = middle;
  }
  const a = knots[low], b = knots[high];
  const share = b[from] === a[from] ? 0 : (value - a[from]) / (b[from] - a[from]);
  return a[to] + share * (b[to] - a[to]);
}

function wrapped(tau: number, branch: Branch): number {
  const length = branch.to - branch.from;
  if (!(length > 0)) return branch.from;
  const turns = (tau - branch.from) / length;
  const rest = (turns - Math.floor(turns)) * length;
  return rest >= length ? branch.from : branch.from + rest;
}

export function block_at(axis: Axis, place: number): AxisBlock {
  return axis.blocks.find((block) => place < block.to) ?? axis.blocks[axis.blocks.length - 1];
}

/** τ at a place of the axis, on its branch. */
export function tau_at(axis: Axis, place: number): number {
  const inside = Math.min(Math.max(place, 0), 1);
  const block = block_at(axis, inside);
  return wrapped(interpolated(block.knots, inside, 0), axis.branches[block.branch]);
}

/** Place of τ on the axis; nothing where no block shows it. */
export function place_of(axis: Axis, tau: number): number | null {
  for (const block of axis.blocks) {
    const branch = axis.branches[block.branch];
    if (tau < branch.from - 1e-12 || tau > branch.to + 1e-12) continue;
    const length = branch.to - branch.from;
    const ends = [block.knots[0][1], block.knots[block.knots.length - 1][1]];
    const low = Math.min(...ends), high = Math.max(...ends);
    for (const turns of [0, 1, -1, 2, -2]) {
      const unwrapped = tau + turns * length;
      if (unwrapped >= low - 1e-12 && unwrapped <= high + 1e-12) {
        return Math.min(Math.max(interpolated(block.knots, unwrapped, 1), block.from), block.to);
      }
    }
  }
  return null;
}
/** Where a pair stands on the map. */
export function places_of(axis: Axis, tau: TauPair): TauPair | null {
  const input = place_of(axis, tau[0]), output = place_of(axis, tau[1]);
  return input === null || output === null ? null : [input, output];
}
