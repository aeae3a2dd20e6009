import {empty_figure, type Figure} from "../../src/figure/figure";
import {in_plane} from "../../src/figure/mechanism";
import type {Point} from "../../src/contract/messages";
import type {TaskView} from "../../src/kinds/view";
import Editor from "./Editor.svelte";
import Picture from "./Picture.svelte";
import Requirement from "./Requirement.svelte";
import Stage from "./Stage.svelte";

function gate(hinge: Point, tip: Point): Figure {
  const at_hinge = {name: "hinge", kind: "ground_pivot", role: "driver", at: hinge, joins: ["ground", "gate"]} as const;
  return {...empty_figure, bodies: [{name: "gate", role: "driver", corners: [hinge, tip]}], joints: [at_hinge]};
}
const nowhere = {center: null, circle: null},
  hinge: Point = [10, 20];

export const swing_view: TaskView = {
  mechanism: {
    driven: (_, {ax, ay, theta_deg}) => ({
      pose: {x: ax, y: ay, theta_deg},
      turned_deg: theta_deg,
      ends: {input: nowhere, output: nowhere},
      joints: [hinge, [ax, ay]],
    }),
    still: () => ({
      pose: {x: 0, y: 0, theta_deg: 0},
      turned_deg: 0,
      ends: {input: nowhere, output: nowhere},
      joints: [hinge],
    }),
    figure: (_, {joints: [from = hinge, to = hinge]}) => gate(from, to),
    visits: () => [],
    pivot_visits: () => [],
    carrier: () => null,
    pivots: () => [hinge],
    sketch: () => empty_figure,
    ghost: ({hinge}) => {
      const kept = in_plane(hinge);
      return kept ? gate(kept, kept) : empty_figure;
    },
    dimensions: () => [{name: "radius of the gate", value: 50}],
    plate_words: {body: (name) => name, pin: (name) => name},
  },
  Stage,
  Region: null,
  Requirement,
  Editor,
  Picture,
  plots: () => ["path"],
};
