import type {AnalysisView} from "../../src/analyses/view";
import Block from "./Block.svelte";
import Layer from "./Layer.svelte";
import Legend from "./Legend.svelte";
import Missing from "./Missing.svelte";
import Printed from "./Printed.svelte";

export const noise_view: AnalysisView = {
  Block,
  missing: {speed: Missing},
  Layer,
  Legend,
  Printed,
  has_legend: () => true,
  line: ({type}) => ({text: `a loud ${type}`, but: null}),
  cards: {noise: () => import("./Card.svelte")},
  may_be_in_picture: () => true,
};
