// What the linkages of the plane can be coloured by, required to be and optimised for, whatever they are to do.
import type {LinkageType, RequirementKey} from "../contract/messages";
import {default_max_length, defaults} from "../state/defaults";
import {length_levels} from "../state/problem";
import type {ObjectiveDescription, PropertyDescription, RequirementDescription} from "./kind";

const angle_span = (): [number, number] => [0, 90],
  angle_levels = () => [30, 45, 60, 75];

export const planar_types = [
  "crank_rocker",
  "rocker_crank",
  "double_crank",
  "double_rocker",
  "triple_rocker_ground",
  "triple_rocker_input",
  "triple_rocker_coupler",
  "triple_rocker_output",
  "change_point",
] as const satisfies readonly LinkageType[];

export const planar_properties = {
  min_transmission_angle_deg: {
    text: "region.by_transmission",
    short: "region.short_transmission",
    term: "transmission_angle",
    larger_is_better: true,
    requirement: "min_transmission_angle_deg",
    quantity: "angle",
    span: angle_span,
    levels: angle_levels,
  },
  link_ratio: {
    text: "region.by_ratio",
    short: "region.short_ratio",
    term: "link_ratio",
    larger_is_better: false,
    requirement: "max_link_ratio",
    quantity: "ratio",
    span: ({max_link_ratio}) => [1, Math.max(1.25 * (max_link_ratio ?? defaults.requirements.max_link_ratio), 4)],
    levels: ([, to]) => [2, 3, 5, 8, 12].filter((level) => level < to),
  },
  longest_link: {
    text: "region.by_size",
    short: "region.by_size",
    term: null,
    larger_is_better: false,
    requirement: "max_length",
    quantity: "length",
    span: ({max_length}, typical) => [0, 1.25 * (max_length ?? default_max_length * typical)],
    levels: length_levels,
  },
  min_transmission_angle_full_turn_deg: {
    text: "num.min_turn",
    short: "num.min_turn",
    term: "transmission_angle",
    larger_is_better: true,
    requirement: null,
    quantity: "angle",
    span: angle_span,
    levels: angle_levels,
  },
  driver_sweep_deg: {
    text: "num.sweep",
    short: "num.sweep",
    term: "driver_sweep",
    larger_is_better: true,
    requirement: null,
    quantity: "angle",
    span: () => [0, 360],
    levels: () => [45, 90, 135, 180, 270],
  },
} satisfies Record<string, PropertyDescription>;

export const planar_requirements = {
  types: {name: "req.types", short: "req.short.types", term: null, control: "types"},
  no_defects: {name: "defect.none", short: "req.short.no_defects", term: "no_defects", control: "no_defects"},
  min_transmission_angle_deg: {
    name: "req.min_transmission",
    short: "req.short.min_transmission_angle_deg",
    term: "transmission_angle",
    control: "transmission_angle",
  },
  max_link_ratio: {
    name: "req.max_ratio",
    short: "req.short.max_link_ratio",
    term: "link_ratio",
    control: "limit",
    bound: "most",
    quantity: "ratio",
    from: 1,
  },
  max_length: {
    name: "req.max_length",
    short: "req.short.max_length",
    term: null,
    control: "limit",
    bound: "most",
    quantity: "length",
    from: 0,
  },
  min_length: {
    name: "req.min_length",
    short: "req.short.min_length",
    term: null,
    control: "limit",
    bound: "least",
    quantity: "length",
    from: 0,
  },
  ground_pivots_within: {
    name: "req.ground_box",
    short: "req.short.ground_pivots_within",
    term: "fixed_pivot",
    control: "box",
    end: "center",
  },
  moving_pivots_within: {
    name: "req.moving_box",
    short: "req.short.moving_pivots_within",
    term: "moving_pivot",
    control: "box",
    end: "circle",
  },
} satisfies Partial<Record<RequirementKey, RequirementDescription>>;

export const planar_objectives = {
  min_transmission_angle: {name: "req.objective.min_transmission_angle", measure: "min_transmission_angle_deg"},
  link_ratio: {name: "req.objective.link_ratio", measure: "link_ratio"},
  size: {name: "req.objective.size", measure: "longest_link"},
} satisfies Record<string, ObjectiveDescription>;
