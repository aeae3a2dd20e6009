// A spherical four-bar as it is drawn flat: in lists, comparisons, films and thumbnails, seen as the stage is at first.
import type {Linkage, Pivot, Point} from "../../contract/messages";
import {empty_figure, type Body, type Figure, type Joint, type Role} from "../../figure/figure";
import {four_bar_words} from "../../figure/four_bar";
import type {Configuration, Mechanism} from "../../figure/mechanism";
import {t} from "../../texts/texts.svelte";
import {circle, column, cross, dot, first_eye, great_circle, identity, unit, type Vec3} from "../../sphere/vectors";
import type {AxisName, SphericalBars} from "./replies";
import {first_stand, link_ends, stand_of_hinges, type Stand} from "./space";

const towards_eye = unit(first_eye),
  to_the_right = unit(cross([0, 0, 1], towards_eye)),
  up = cross(towards_eye, to_the_right);
function seen([...at]: Vec3): Point {
  return [dot(at, to_the_right), dot(at, up)];
}
const outline = circle(towards_eye).map(seen);

interface Standing extends Configuration {
  stand: Stand;
}
const nowhere = {center: null, circle: null};
const axis_names: readonly AxisName[] = ["input_fixed", "input_moving", "output_fixed", "output_moving"];

function standing(stand: Stand): Standing {
  const [x, y] = seen(column(stand.turn, 0));
  return {
    stand,
    pose: {x, y, theta_deg: 0},
    turned_deg: 0,
    ends: {input: nowhere, output: nowhere},
    joints: axis_names.map((name) => seen(stand[name])),
  };
}
function link(role: "input" | "coupler" | "output", stand: Stand): Body {
  const [from, to] = link_ends[role].map((name) => stand[name]) as [Vec3, Vec3];
  return {name: role, role, corners: [seen(from), seen(to)], along: great_circle(from, to).map(seen)};
}
function joint(name: AxisName, stand: Stand): Joint {
  const fixed = name.endsWith("fixed"),
    role: Role = name.startsWith("input") ? "input" : "output";
  return {
    name,
    kind: fixed ? "ground_pivot" : "moving_pivot",
    role,
    at: seen(stand[name]),
    joins: [fixed ? "ground" : "coupler", role],
  };
}
function drawn(stand: Stand): Figure {
  return {
    ...empty_figure,
    backdrop: [outline],
    bodies: [link("coupler", stand), link("input", stand), link("output", stand)],
    joints: axis_names.map((name) => joint(name, stand)),
  };
}
/** By its four axes, in the order of the list of the best. */
function by_axes(pivots: readonly (Pivot | null | undefined)[]): Figure {
  const [input_fixed, input_moving, output_fixed, output_moving, ...more] = pivots;
  if (more.length || !is_axis(input_fixed) || !is_axis(input_moving)) return empty_figure;
  if (!is_axis(output_fixed) || !is_axis(output_moving)) return empty_figure;
  return drawn({input_fixed, input_moving, output_fixed, output_moving, turn: identity});
}
export function is_axis(pivot: Pivot | null | undefined): pivot is Vec3 {
  return pivot?.length === 3;
}
const of_nothing: SphericalBars = {
  angles_deg: {ground: 0, input: 0, coupler: 0, output: 0},
  min_link_angle_deg: 0,
  triple_rocker: null,
  input_fixed: [0, 0, 1],
  input_moving: [0, 0, 1],
  output_fixed: [0, 0, 1],
  output_moving: [0, 0, 1],
};
const bars_of = ({spherical = of_nothing}: Linkage) => spherical;

export const spherical_four_bar: Mechanism = {
  driven: (linkage, _, hinges) => standing(stand_of_hinges(bars_of(linkage), hinges)),
  still: (linkage) => standing(first_stand(bars_of(linkage))),
  figure: (linkage, now) => (linkage.spherical ? drawn((now as Standing).stand) : empty_figure),
  visits: () => [],
  pivot_visits: () => [],
  carrier: () => null,
  pivots: (linkage) => standing(first_stand(bars_of(linkage))).joints.slice(),
  sketch: by_axes,
  end_of: (...axis) => axis,
  ghost: (pivots) => by_axes(axis_names.map((name) => pivots[name])),
  dimensions({spherical}) {
    if (!spherical) return [];
    const {angles_deg} = spherical,
      roles = {input: "input", coupler: "body", output: "output"} as const;
    return [
      {name: t("num.ground"), value: angles_deg.ground, is_angle: true},
      ...(["input", "coupler", "output"] as const).map((name) => ({
        name: t(`num.${name}`),
        value: angles_deg[name],
        is_angle: true as const,
        role: roles[name],
      })),
      ...axis_names.map((name) => ({
        name: t(name.endsWith("fixed") ? "spherical.fixed_axis" : "spherical.moving_axis"),
        value: spherical[name],
        role: name.startsWith("input") ? ("input" as const) : ("output" as const),
      })),
    ];
  },
  plate_words: four_bar_words,
};
