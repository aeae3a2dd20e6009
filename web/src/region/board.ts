// A map whose axes both have a few places only: its cells as a board, each with the linkage that stands there.
import {
  defect_bits,
  degenerate,
  type Axes,
  type DyadPolygon,
  type MapAnswer,
  type Pivot,
  type Side,
  type TaskAnswer,
  type TauPair,
} from "../contract/messages";
import {is_discrete, is_ribbon} from "../engine/axis";

export interface BoardCell {
  row: number;
  column: number;
  tau: TauPair;
  /** Centre and circle point of the input, then of the output, as in position 1. */
  pivots: readonly [Pivot, Pivot, Pivot, Pivot];
  defects: {order: boolean; branch: boolean; circuit: boolean};
  /** Of the property that the map shows. */
  value: number;
}

export function is_board(axes: Axes): boolean {
  return is_discrete(axes.input) && is_discrete(axes.output) && !is_ribbon(axes);
}

/** The cells that hold a four-bar. */
export function board_cells(task: TaskAnswer, map: MapAnswer, end_of: EndOf = finite): BoardCell[] {
  const cells: BoardCell[] = [];
  for (let row = 0; row < map.rows; ++row) {
    for (let column = 0; column < map.columns; ++column) {
      const at = row * map.columns + column,
        tau: TauPair = [map.input_tau[row]!, map.output_tau[column]!];
      const input = dyad_at(task, "input", tau, end_of),
        output = dyad_at(task, "output", tau, end_of),
        bits = map.defects[at]!;
      if (map.type[at]! === degenerate || !input || !output) continue;
      const defects = {
        order: (bits & defect_bits.order) !== 0,
        branch: (bits & defect_bits.branch) !== 0,
        circuit: (bits & defect_bits.circuit) !== 0,
      };
      cells.push({row, column, tau, pivots: [...input, ...output], defects, value: map.value[at]!});
    }
  }
  return cells;
}

/** A side whose own axis leaves nothing to choose goes with the other's. */
function dyad_at(
  task: TaskAnswer,
  side: Side,
  [input, output]: TauPair,
  end_of: EndOf,
): readonly [center: Pivot, circle: Pivot] | null {
  const {quantity, branches} = task.axes[side],
    own = quantity !== "nothing" || branches.length > 1,
    tau = (side === "input") === own ? input : output;
  const curves: DyadPolygon = side === "output" ? (task.output_curves ?? task.curves) : task.curves;
  const at = curves.tau.findIndex((other) => Math.floor(other) === Math.floor(tau));
  if (at < 0) return null;
  const end = (ends: Float64Array) => end_of(ends[3 * at]!, ends[3 * at + 1]!, ends[3 * at + 2]!),
    center = end(curves.center),
    circle = end(curves.circle);
  return center && circle && [center, circle];
}
/** A joint by the three numbers that a curve has of it. */
export type EndOf = (...numbers: readonly [number, number, number]) => Pivot | null;
function finite(w: number, x: number, y: number): Pivot | null {
  return Math.abs(w) < 1e-12 ? null : [x / w, y / w];
}
