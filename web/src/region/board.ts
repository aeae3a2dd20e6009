// A map whose axes both have a few places only: its cells as a board, each with the linkage that stands there.
import {
  defect_bits,
  type Axes,
  type DyadPolygon,
  type MapAnswer,
  type Point,
  type Side,
  type TaskAnswer,
  type TauPair,
} from "../engine/protocol";
import {is_discrete} from "../state/axis";

export interface BoardCell {
  row: number;
  column: number;
  tau: TauPair;
  /** Centre and circle point of the input, then of the output, as in position 1. */
  pivots: readonly [Point, Point, Point, Point];
  defects: {order: boolean; branch: boolean; circuit: boolean};
  /** Of the property that the map shows. */
  value: number;
}

export function is_board({input, output}: Axes): boolean {
  return is_discrete(input) && is_discrete(output);
}

/** The cells that hold a four-bar. */
export function board_cells(task: TaskAnswer, map: MapAnswer): BoardCell[] {
  const cells: BoardCell[] = [];
  for (let row = 0; row < map.rows; ++row) {
    for (let column = 0; column < map.columns; ++column) {
      const at = row * map.columns + column,
        tau: TauPair = [map.input_tau[row]!, map.output_tau[column]!];
      const input = dyad_at(task, "input", tau),
        output = dyad_at(task, "output", tau),
        bits = map.defects[at]!;
      if (map.type[at]! >= 9 || !input || !output) continue;
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
): readonly [center: Point, circle: Point] | null {
  const own = task.axes[side].quantity !== "nothing",
    tau = (side === "input") === own ? input : output;
  const curves: DyadPolygon = side === "output" ? (task.output_curves ?? task.curves) : task.curves;
  const at = curves.tau.findIndex((other) => Math.floor(other) === Math.floor(tau));
  const center = finite(curves.center, at),
    circle = finite(curves.circle, at);
  return center && circle && [center, circle];
}
function finite(points: Float64Array, at: number): Point | null {
  const w = points[3 * at];
  return at < 0 || Math.abs(w!) < 1e-12 ? null : [points[3 * at + 1]! / w!, points[3 * at + 2]! / w!];
}
