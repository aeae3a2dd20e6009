// Axes of maps as tests want them.
import type {Axis, AxisBlock} from "../src/contract/messages";

/** One branch over the whole axis, where place and τ are the same. */
export const straight_block: AxisBlock = {
  branch: 0,
  from: 0,
  to: 1,
  knots: [
    [0, 0],
    [1, 1],
  ],
};
export const straight_axis: Axis = {
  quantity: "curve_coordinate",
  ticks: null,
  order: 3,
  branches: [{name: "odd", from: 0, to: 1}],
  blocks: [straight_block],
};
