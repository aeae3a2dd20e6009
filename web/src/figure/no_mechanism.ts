// Of kinds of tasks that have no linkages: nothing is put together, nothing is drawn.
import {empty_figure} from "./figure";
import type {Mechanism} from "./mechanism";

const nowhere = {center: null, circle: null};
const nothing = () => ({
  pose: {x: 0, y: 0, theta_deg: 0},
  turned_deg: 0,
  ends: {input: nowhere, output: nowhere},
  joints: [],
});
export const no_mechanism: Mechanism = {
  driven: nothing,
  still: nothing,
  figure: () => empty_figure,
  visits: () => [],
  pivot_visits: () => [],
  carrier: () => null,
  pivots: () => [],
  sketch: () => empty_figure,
  ghost: () => empty_figure,
  dimensions: () => [],
  plate_words: {body: (name) => name, pin: (name) => name},
};
