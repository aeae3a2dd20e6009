import type {Component} from "svelte";
import {four_bar} from "../../figure/four_bar";
import type {Mechanism} from "../../figure/mechanism";
import {six_bar} from "../six_bar/figure";
import {with_point} from "../../figure/tracing";
import {spherical_four_bar} from "../spherical/figure";
import SphericalStage from "../spherical/Stage.svelte";
import type {TaskView} from "../view";
import Editor from "./Editor.svelte";
import {given_handles} from "./handles";
import Numbers from "./Numbers.svelte";
import Picture from "./Picture.svelte";
import {point_plots} from "./rates";

const common = {
  Editor,
  Numbers,
  Region: null,
  Picture: Picture as Component<{id: string}>,
  not_written: {result: "linkage.no_result"},
} as const;

/** The point that is looked at, unless it is the input's moving pivot, as where none is given. */
const pointed_four_bar: Mechanism = {
  ...four_bar,
  guides_a_point: true,
  figure(linkage, now, outline) {
    const {x, y} = now.pose,
      [ax, ay] = now.ends.input.circle ?? [x, y],
      is_own = Math.hypot(x - ax, y - ay) > 1e-9 * (linkage.longest ?? 1);
    return with_point(four_bar.figure(linkage, now, outline), is_own ? [x, y] : null);
  },
};
export const four_bar_view: TaskView = {
  ...common,
  handles: given_handles,
  mechanism: pointed_four_bar,
  plots: () => ["transmission", "output", ...point_plots, "velocity", "advantage", "path"],
};
export const six_bar_view: TaskView = {
  ...common,
  handles: given_handles,
  mechanism: {...six_bar, guides_a_point: true},
  plots: () => ["transmission", "coupler", ...point_plots, "path"],
};
export const spherical_view: TaskView = {
  ...common,
  mechanism: spherical_four_bar,
  Stage: SphericalStage,
  not_written: {...common.not_written, dxf: "spherical.no_dxf", plates: "spherical.no_dxf"},
  plots: () => ["transmission", "output", "velocity", "advantage"],
};
