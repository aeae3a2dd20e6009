// A body is turned through orientations about a point by a spherical four-bar.
import type {LinkageType} from "../../contract/messages";
import {form_names, form_of, read_orientation, read_vector} from "../../orientation/orientation";
import type {Vec3} from "../../sphere/vectors";
import {with_requirements, type Pin} from "../../state/problem";
import {is_number, is_object, present, read_list, type JsonObject} from "../../state/shape";
import {pattern_of} from "../../state/task";
import {significant} from "../../texts/numbers";
import {t} from "../../texts/texts.svelte";
import type {Beginning, NamedJoint, NamedLength, TaskKind} from "../kind";
import {planar_objectives, planar_properties, planar_requirements} from "../planar";
import {arc_making} from "../../analyses/tolerances/making";
import type {AxisName, Cone} from "./replies";
import {
  is_spherical,
  position_count,
  rate_keys,
  rates_of,
  turned,
  without_rates,
  type GivenAxes,
  type PrescribedOrientation,
  type SphericalTask,
} from "./task";

const most_orientations = 1000; // the engine takes five; what was typed is kept until it is set right

function read_prescribed(value: unknown): PrescribedOrientation | null {
  const orientation = read_orientation(value);
  if (!orientation || !is_object(value)) return null;
  const rates: [string, Vec3][] = [];
  for (const key of rate_keys) {
    const rate = read_vector(value[key]);
    if (!rate) break;
    rates.push([key, rate]);
  }
  return turned(Object.fromEntries(rates) as unknown as PrescribedOrientation, orientation);
}
function read_two(value: unknown): readonly [Vec3, Vec3] | null {
  const list = read_list(value, read_vector, 2);
  return list?.length === 2 ? [list[0]!, list[1]!] : null;
}
function read_given(value: unknown): GivenAxes | null {
  if (!is_object(value)) return null;
  const fixed_axes = read_two(value.fixed_axes),
    moving_axes = read_two(value.moving_axes);
  return fixed_axes ? {fixed_axes} : moving_axes && {moving_axes};
}
function read(value: JsonObject): SphericalTask | null {
  const orientations = read_list(value.orientations, read_prescribed, most_orientations);
  if (value.kind !== "motion" || value.mechanism !== "spherical_four_bar" || !orientations) return null;
  return {
    kind: "motion",
    mechanism: "spherical_four_bar",
    orientations,
    ...present({given: read_given(value.given)}),
  };
}

export function is_cone(value: unknown): value is Cone {
  return (
    is_object(value) &&
    read_vector(value.axis) !== null &&
    is_number(value.half_angle_deg) &&
    value.half_angle_deg > 0 &&
    value.half_angle_deg <= 90
  );
}

// ---- beginnings -----------------------------------------------------------------------------------------------------

const zyx = (...angles: Vec3[]) => angles.map((euler_deg) => ({euler_deg, sequence: "zyx"}));
/** Those that are there already, and on to as many as it takes. */
function turning(own: readonly PrescribedOrientation[]): Pick<Beginning, "make" | "turned"> {
  const task = (kept: readonly PrescribedOrientation[]): SphericalTask => ({
    kind: "motion",
    mechanism: "spherical_four_bar",
    orientations: [...kept, ...own.slice(kept.length)],
  });
  return {
    make: () => with_requirements({linkwright: 1, title: "", task: task([])}, {min_transmission_angle_deg: 30}),
    turned: {count: own.length, task},
  };
}
const beginnings: Beginning[] = [
  {
    id: "four_orientations",
    name: "new.four_orientations",
    about: "new.four_orientations_about",
    ...turning(zyx([0, 0, 5], [-22.7, -3.4, 24.8], [-50.2, -16.3, 53.3], [-88.2, -42, 87.3])),
  },
  {
    id: "five_orientations",
    name: "new.five_orientations",
    about: "new.five_orientations_about",
    ...turning(zyx([-4, -25, 5.5], [-2.5, -12, 4], [0, 0, 0], [3.5, 11, -4], [8, 20, -6])),
  },
];

// ---- a linkage ------------------------------------------------------------------------------------------------------

const links = ["ground", "input", "coupler", "output"] as const;
const link_colors = {ground: null, input: "input", coupler: "body", output: "output"} as const;
const axes: readonly AxisName[] = ["input_fixed", "input_moving", "output_fixed", "output_moving"];

function lengths({
  spherical,
}: {
  spherical?: {angles_deg: Record<(typeof links)[number], number>};
}): NamedLength[] | null {
  if (!spherical) return null;
  return links.map((link) => ({
    key: link,
    name: t(`num.${link}`),
    length: spherical.angles_deg[link],
    color: link_colors[link],
    ...(link === "input" ? {} : {term: "link_angle" as const}),
  }));
}
function joints({spherical}: {spherical?: Record<AxisName, Vec3>}): NamedJoint[] | null {
  if (!spherical) return null;
  return axes.map((axis) => {
    const on_ground = axis.endsWith("fixed");
    return {
      key: axis,
      name: t(on_ground ? "spherical.fixed_axis" : "spherical.moving_axis"),
      at: spherical[axis],
      on_ground,
      color: axis.startsWith("input") ? "input" : "output",
      term: on_ground ? ("fixed_axis" as const) : ("moving_axis" as const),
    };
  });
}

const spherical_types = [
  "crank_rocker",
  "rocker_crank",
  "double_crank",
  "double_rocker",
  "triple_rocker",
  "change_point",
] as const satisfies readonly LinkageType[];
const {min_transmission_angle_deg, min_transmission_angle_full_turn_deg, driver_sweep_deg} = planar_properties;

/** Branches of a cubic cone are not those of a plane curve. */
export const cone_texts: TaskKind["texts"] = {
  "curve.odd": "spherical.curve.odd",
  "curve.oval": "spherical.curve.oval",
  "curve.single_point": "spherical.curve.single_point",
};
export const spherical_kind: TaskKind<SphericalTask> = {
  name: "task.kind_spherical",
  without_lengths: true,
  keeps_form: true,
  is: is_spherical,
  read,
  orientations: ({orientations}) => orientations.map(without_rates),
  incompleteness(task) {
    const n = position_count(task);
    if (n === 0) return {state: "empty", text: "spherical.empty", n};
    if (n < 3) return {state: "too_few", text: "spherical.too_few", n};
    if (n > 5) return {state: "too_many", text: "spherical.too_many", n};
    return n === 3 && !task.given ? {state: "no_given", text: "spherical.no_given", n} : null;
  },
  stops: ({orientations}) => orientations.length,
  pattern: ({orientations}) => pattern_of(orientations.map((one) => ({derivatives: rates_of(one)}))),
  is_mixed: ({orientations}) => orientations.some((one) => rates_of(one).length > 0),
  /** The unit ball. */
  anchors: () => [
    [-1, -1],
    [1, 1],
  ],
  default_max_length: () => 1,
  map_of: (task) => `spherical ${position_count(task)} ${Object.keys(task.given ?? {}).join("")}`,
  properties: {
    min_transmission_angle_deg,
    min_link_angle_deg: {
      text: "region.by_link_angle",
      short: "region.short_link_angle",
      term: "link_angle",
      larger_is_better: true,
      requirement: "min_link_angle_deg",
      quantity: "angle",
      span: () => [0, 90],
      levels: () => [15, 30, 45, 60, 75],
    },
    min_transmission_angle_full_turn_deg: {...min_transmission_angle_full_turn_deg, short: "num.min_turn_short"},
    driver_sweep_deg,
  },
  types: spherical_types,
  requirements: {
    types: planar_requirements.types,
    no_defects: planar_requirements.no_defects,
    min_transmission_angle_deg: planar_requirements.min_transmission_angle_deg,
    min_link_angle_deg: {
      name: "req.min_link_angle",
      short: "req.short.min_link_angle_deg",
      term: "link_angle",
      control: "limit",
      bound: "least",
      quantity: "angle",
      from: 0,
    },
    max_link_angle_deg: {
      name: "req.max_link_angle",
      short: "req.short.max_link_angle_deg",
      term: "link_angle",
      control: "limit",
      bound: "most",
      quantity: "angle",
      from: 0,
    },
    fixed_axes_within: {
      name: "req.fixed_axes",
      short: "req.short.fixed_axes_within",
      term: "fixed_axis",
      control: "own",
      is_value: is_cone,
    },
    moving_axes_within: {
      name: "req.moving_axes",
      short: "req.short.moving_axes_within",
      term: "moving_axis",
      control: "own",
      is_value: is_cone,
    },
  },
  analysed: {tolerances: arc_making},
  objectives: {
    min_transmission_angle: planar_objectives.min_transmission_angle,
    link_angle: {name: "req.objective.link_angle", measure: "min_link_angle_deg"},
  },
  moved: (task) => task,
  table: ({orientations}) => ({
    head: [t("orientation.form"), ""],
    rows: orientations.map((one) => {
      const bare = without_rates(one),
        form = form_of(bare),
        sequence = "euler_deg" in bare ? ` ${bare.sequence}` : "";
      return [
        t(form_names[form]) + sequence,
        numbers_of(bare)
          .map((value) => significant(value, 6))
          .join(", "),
      ];
    }),
  }),
  texts: {
    ...cone_texts,
    "export.csv_inside": "spherical.csv_inside",
    "export.json_inside": "spherical.json_inside",
    "notice.common_component": "spherical.common_component",
    "notice.dependent_rows": "spherical.dependent_rows",
    "notice.ill_conditioned": "spherical.ill_conditioned",
    "notice.no_pair": "spherical.no_pair",
    "state.none_defect_free": "spherical.none_defect_free",
  },
  beginnings,
  kept_pivots: ({spherical}) => (spherical ? Object.fromEntries(axes.map((axis) => [axis, spherical[axis]])) : {}),
  filed_pivots,
  lengths,
  joints,
};

function filed_pivots(linkage: JsonObject): Pin["pivots"] {
  return Object.fromEntries(
    axes.map((axis) => {
      const [side, end] = axis.split("_") as ["input" | "output", "fixed" | "moving"],
        dyad = linkage[side];
      return [axis, is_object(dyad) ? read_vector(dyad[`${end}_axis`]) : null];
    }),
  );
}
function numbers_of(orientation: object): number[] {
  return Object.values(orientation).flatMap((value): number[] =>
    typeof value === "number" ? [value] : Array.isArray(value) ? (value.flat() as number[]) : [],
  );
}
