// Places on the map's axes and curve coordinates, as the engine's axis tells them.
import {
  axis_quantities,
  whole,
  type Axes,
  type Axis,
  type AxisBlock,
  type AxisQuantity,
  type Branch,
  type Picked,
  type Point,
  type Side,
  type TaskAnswer,
  type TauPair,
  type MapWindow,
} from "../contract/messages";

function interpolated(knots: readonly (readonly [number, number])[], value: number, from: 0 | 1): number {
  const to = from === 0 ? 1 : 0;
  const rising = knots[knots.length - 1]![from] > knots[0]![from];
  let low = 0,
    high = knots.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (knots[middle]![from] <= value === rising) low = middle;
    else high = middle;
  }
  const a = knots[low],
    b = knots[high];
  const share = b![from] === a![from] ? 0 : (value - a![from]) / (b![from] - a![from]);
  return a![to] + share * (b![to] - a![to]);
}

function wrapped(tau: number, branch: Branch): number {
  const length = branch.to - branch.from;
  if (!(length > 0)) return branch.from;
  const turns = (tau - branch.from) / length;
  const rest = (turns - Math.floor(turns)) * length;
  return rest >= length ? branch.from : branch.from + rest;
}

/** Nothing on an axis without grounded links. */
export function block_at(axis: Axis, place: number): AxisBlock | null {
  return axis.blocks.find((block) => place < block.to) ?? axis.blocks.at(-1) ?? null;
}

/** Whether the dyads lie along Burmester's curves; where there are none, the engine says what they lie along instead. */
export function has_burmester_curve({curves}: TaskAnswer): boolean {
  return !(axis_quantities as readonly string[]).includes(curves.kind);
}

/** Every place of a block is the same: one row or column of the map to each. */
export function is_discrete({quantity}: Axis): boolean {
  return discrete.includes(quantity);
}
const discrete: readonly AxisQuantity[] = ["burmester_point", "nothing", "layer", "fitted_curve", "realisation"];
/** The side along whose axis a grounded link moves: where its own leaves nothing to choose, the other's. */
export function moving_side(axes: Axes, side: Side): Side {
  const other = side === "input" ? "output" : "input";
  return axes[side].quantity === "nothing" && axes[other].quantity !== "nothing" ? other : side;
}
/** A pair with the coordinate along which a grounded link moves exchanged. */
export function with_side({axes}: Pick<TaskAnswer, "axes">, tau: TauPair, side: Side, value: number): TauPair {
  return moving_side(axes, side) === "input" ? [value, tau[1]] : [tau[0], value];
}
export function coordinate_of({axes}: Pick<TaskAnswer, "axes">, tau: TauPair, side: Side): number {
  return tau[moving_side(axes, side) === "input" ? 0 : 1];
}
/** Many places along the input's axis and one along the output's, or a list of linkages along the output's alone. */
export function is_ribbon(axes: Axes): boolean {
  return is_column(axes) || (axes.input.quantity === "nothing" && axes.output.quantity === "layer");
}
/** A ribbon that stands upright, as the map has it. */
export function is_column({input, output}: Axes): boolean {
  return output.quantity === "nothing" && !is_discrete(input);
}
function middle_tau({from, to}: Branch): number {
  return (from + to) / 2;
}
/** What stands for all places of a block, on an axis of a few; otherwise the place itself. */
export function held_place(axis: Axis, place: number): number {
  const block = is_discrete(axis) ? block_at(axis, place) : null;
  return block ? (block.from + block.to) / 2 : place;
}
/** So many cells of `cell` on; on an axis of a few places to the next. */
export function stepped_place(axis: Axis, place: number, cells: number, cell: number): number {
  const block = is_discrete(axis) ? block_at(axis, place) : null;
  if (!block) return Math.min(Math.max(place + cells * cell, 0), 1);
  const at = axis.blocks.indexOf(block),
    to = Math.min(Math.max(at + Math.sign(cells), 0), axis.blocks.length - 1);
  return held_place(axis, axis.blocks[to]!.from);
}

/** An axis of a few places is shown whole. */
export function held_window(axes: Axes, window: MapWindow): MapWindow {
  const held = (side: Side) => (is_discrete(axes[side]) ? whole[side] : window[side]);
  const [input, output] = [held("input"), held("output")];
  return [...input, ...output].join() === [...whole.input, ...whole.output].join() ? whole : {input, output};
}
/** τ as the engine names it: of an axis of a few places the middle of the branch. */
export function held_tau(axes: Axes, tau: TauPair): TauPair {
  const held = (axis: Axis, value: number) => {
    const branch = is_discrete(axis) ? axis.branches.find(({from, to}) => value >= from && value <= to) : undefined;
    return branch ? middle_tau(branch) : value;
  };
  return [held(axes.input, tau[0]), held(axes.output, tau[1])];
}

/** τ at a place of the axis, on its branch; none on an axis without grounded links. */
export function tau_at(axis: Axis, place: number): number | null {
  const inside = Math.min(Math.max(place, 0), 1),
    block = block_at(axis, inside);
  if (!block) return null;
  const branch = axis.branches[block.branch];
  return is_discrete(axis) ? middle_tau(branch!) : wrapped(interpolated(block.knots, inside, 0), branch!);
}
export function tau_of_places(axes: Axes, place: TauPair): TauPair | null {
  const input = tau_at(axes.input, place[0]),
    output = tau_at(axes.output, place[1]);
  return input === null || output === null ? null : [input, output];
}

/** Where several linkages stand at a place, which of them τ names: 0 the best there, k the one with τ in [k, k + 1). */
function layer_of({layers}: Axis, tau: number): number {
  return layers ? Math.max(Math.floor(tau), 0) : 0;
}
/** τ on the branches of the axis, whichever of the linkages there it names. */
export function on_branches(axis: Axis, tau: number): number {
  return tau - layer_of(axis, tau);
}
/** τ that has come from `before`, in its layer. */
export function in_layer_of(axis: Axis, before: number, tau: number): number {
  return tau + layer_of(axis, before);
}

/** Along a whole line, as the engine lays it out: middle + spread · tan π(τ − ½). */
export function on_line(axis: Axis, tau: number): number {
  const {middle, spread} = line_of(axis);
  return middle + spread * Math.tan(Math.PI * (on_branches(axis, tau) - 0.5));
}
/** τ of a place of the line. */
export function tau_on_line(axis: Axis, value: number): number {
  const {middle, spread} = line_of(axis);
  return 0.5 + Math.atan((value - middle) / spread) / Math.PI;
}
function line_of({ticks}: Axis): {middle: number; spread: number} {
  const at = (share: number) => (ticks ?? []).find(([tau]) => Math.abs(tau - share) < 1e-9)?.[1] ?? 0,
    middle = at(0.5);
  return {middle, spread: at(0.75) - middle};
}
/** Of a map over the plane: which side's axis runs along x and which along y, of which pivots. */
export interface PlaneAxes {
  x: Side;
  y: Side;
  end: "center" | "circle";
}
/** Nothing where the map is of something else. */
export function plane_axes({input, output}: Axes): PlaneAxes | null {
  for (const end of ["center", "circle"] as const) {
    if (input.quantity === `${end}_x` && output.quantity === `${end}_y`) return {x: "input", y: "output", end};
    if (input.quantity === `${end}_y` && output.quantity === `${end}_x`) return {x: "output", y: "input", end};
  }
  return null;
}
/** The pair whose pivot lies at a point of the plane. */
export function tau_of_point(axes: Axes, plane: PlaneAxes, [x, y]: Point): TauPair {
  const tau = {[plane.x]: tau_on_line(axes[plane.x], x), [plane.y]: tau_on_line(axes[plane.y], y)};
  return [tau.input!, tau.output!];
}

/** Place of τ on the axis; nothing where no block shows it. */
export function place_of(axis: Axis, named: number): number | null {
  const tau = on_branches(axis, named);
  for (const block of axis.blocks) {
    const branch = axis.branches[block.branch];
    if (tau < branch!.from - 1e-12 || tau > branch!.to + 1e-12) continue;
    const length = branch!.to - branch!.from;
    const first = block.knots[0]![1],
      last = block.knots.at(-1)![1];
    const low = Math.min(first, last),
      high = Math.max(first, last);
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
export function places_of(axes: Axes, tau: TauPair): TauPair | null {
  const input = place_of(axes.input, tau[0]),
    output = place_of(axes.output, tau[1]);
  return input === null || output === null ? null : [held_place(axes.input, input), held_place(axes.output, output)];
}

/** Of the nearest paths, the best first: what is picked keeps its number, however many there are. */
function is_ranked({input}: Axes): boolean {
  return input.quantity === "fitted_curve";
}
/** On the axes of another answer what is picked keeps its place, and τ follows; without a place it gets that of its τ.
 *  Nothing where τ is none of these axes: the engine would take it for another. */
export function settled(axes: Axes, picked: Picked): Picked | null {
  const kept = is_ranked(axes) ? null : picked.place,
    place = kept ?? places_of(axes, picked.tau);
  if (!place) return null;
  const moved = kept && tau_of_places(axes, kept),
    tau = moved ? kept_tau(picked.tau, [in_layer_of(axes.input, picked.tau[0], moved[0]), moved[1]]) : picked.tau;
  const stays = picked.place !== null && place[0] === picked.place[0] && place[1] === picked.place[1];
  return tau === picked.tau && stays ? picked : {tau, place};
}
/** τ as it was where its place has not moved it: undo restores a linkage to the last bit. */
function kept_tau(before: TauPair, now: TauPair): TauPair {
  return Math.hypot(before[0] - now[0], before[1] - now[1]) < 1e-9 ? before : now;
}
