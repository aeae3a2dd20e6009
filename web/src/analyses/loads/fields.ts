// What all groups of fields take, and what a number of the loads is told by: by its name and unit, one line after the other.
import type {Point} from "../../contract/messages";
import {driver_laws, type LinkMass, type LinkMasses} from "../../contract/problem";
import {t} from "../../texts/texts.svelte";
import {default_temperature_C, friction_of, usual_gravity, type CarriedPoint, type LinearSpring} from "./block";
import type {ExtraLoad, LoadCase, Loads, Spring} from "./block";
import {changed, with_case, with_extra, with_spring} from "./editing";

export interface Fields {
  loads: Loads;
  /** `merge`: steps that are one for undo. */
  put: (loads: Loads, merge?: string | null) => void;
  report: (sentence: string | null) => void;
}
export interface NumberLine<To = Loads> {
  key: string;
  name: string;
  value: number | null;
  unit: string;
  low?: number;
  high?: number;
  /** Of one step. */
  by?: number;
  /** Nothing is a value, too. */
  optional?: true;
  placeholder?: string;
  with_value(value: number | null): To;
}
const above_nothing = 1e-9;

/** x and y of a place; of one that is not given, both are nothing. */
export function place_lines<To = Loads>(
  names: readonly [x: string, y: string],
  unit: string,
  place: Point | undefined,
  with_place: (place: Point | undefined) => To,
): NumberLine<To>[] {
  const put = (axis: 0 | 1, value: number | null): To => {
    if (value === null && !place) return with_place(undefined);
    const [x, y] = place ?? [0, 0],
      at = value ?? 0;
    return with_place(axis === 0 ? [at, y] : [x, at]);
  };
  return ([0, 1] as const).map((axis) => ({
    key: "xy"[axis]!,
    name: names[axis],
    value: place?.[axis] ?? null,
    unit,
    with_value: (value) => put(axis, value),
  }));
}
const prefixed = <To>(prefix: string, lines: NumberLine<To>[]): NumberLine<To>[] =>
  lines.map((line) => ({...line, key: `${prefix}_${line.key}`}));

// ---- the body and the links -----------------------------------------------------------------------------------------

export function body_lines(loads: Loads, unit: string): NumberLine[] {
  const {body} = loads;
  return [
    {
      key: "mass",
      name: t("loads.mass"),
      value: body?.mass ?? null,
      unit: "kg",
      low: 0,
      optional: true,
      placeholder: "0",
      with_value: (mass) => changed(loads, {body: mass === null ? undefined : {...body, mass}}),
    },
    ...prefixed(
      "center",
      place_lines([t("loads.center_x"), t("loads.center_y")], unit, body?.center ?? [0, 0], (center) => ({
        ...loads,
        body: {mass: 0, ...body, center: center!},
      })),
    ),
  ];
}
type Side = keyof LinkMasses;
/** One number for all links; what is given otherwise stays until it is typed over. */
export function common_density_line(loads: Loads, sides: readonly Side[]): NumberLine {
  const density = (of: LinkMass | undefined) => (of && "kg_per_m" in of ? of.kg_per_m : of ? null : 0);
  const densities = sides.map((side) => density(loads.links?.[side])),
    common = densities.every((of) => of === densities[0]) ? (densities[0] ?? null) : null;
  return {
    key: "links",
    name: t("loads.links"),
    value: common || null,
    unit: "kg/m",
    low: 0,
    optional: true,
    placeholder: common === null ? t("loads.links_differ") : "0",
    with_value(kg_per_m) {
      const links = Object.fromEntries(sides.map((side) => [side, {kg_per_m: kg_per_m ?? 0}]));
      return changed(loads, {links: kg_per_m ? links : undefined});
    },
  };
}
export type Weighed = "nothing" | "kg_per_m" | "mass";
export function weighed_by(link: LinkMass | undefined): Weighed {
  if (!link) return "nothing";
  return "kg_per_m" in link ? "kg_per_m" : "mass";
}
export function with_link(loads: Loads, side: Side, link: LinkMass | undefined): Loads {
  const links = changed<LinkMasses>(loads.links ?? {}, {[side]: link});
  return changed(loads, {links: Object.keys(links).length ? links : undefined});
}
export function link_lines(loads: Loads, side: Side, unit: string): NumberLine[] {
  const link = loads.links?.[side];
  if (!link) return [];
  const by_length = "kg_per_m" in link,
    put = (change: Partial<LinkMass>) => with_link(loads, side, changed(link, change));
  return [
    {
      key: by_length ? "kg_per_m" : "mass",
      name: t(by_length ? "loads.per_length" : "loads.mass_of_link"),
      value: by_length ? link.kg_per_m : link.mass,
      unit: by_length ? "kg/m" : "kg",
      low: 0,
      with_value: (value) => put(by_length ? {kg_per_m: value ?? 0} : {mass: value ?? 0}),
    },
    ...prefixed(
      "center",
      place_lines([t("loads.along"), t("loads.across")], unit, link.center, (center) => put({center})).map((line) => ({
        ...line,
        optional: true as const,
        placeholder: t("loads.middle"),
        with_value: (value: number | null) => (value === null ? put({center: undefined}) : line.with_value(value)),
      })),
    ),
    inertia_line(link.inertia, (inertia) => put({inertia})),
  ];
}
function inertia_line(inertia: number | undefined, put: (inertia: number | undefined) => Loads): NumberLine {
  return {
    key: "inertia",
    name: t("loads.inertia"),
    value: inertia ?? null,
    unit: "kg·m²",
    low: 0,
    optional: true,
    placeholder: "0",
    with_value: (value) => put(value ?? undefined),
  };
}

// ---- gravity, pins, speed -------------------------------------------------------------------------------------------

export const motions = ["none", ...driver_laws] as const;
/** How the driver moves in time; a table is chosen where it is given. */
export function motion_of({motion}: Loads): (typeof motions)[number] | "table" {
  if (!motion) return "none";
  return "law" in motion ? motion.law : "table";
}
export function with_motion(loads: Loads, law: ReturnType<typeof motion_of>): Loads {
  if (law === "table") return loads;
  if (law === "none") return changed(loads, {motion: undefined});
  const {motion} = loads,
    duration_s = !motion ? 1 : "law" in motion ? motion.duration_s : (motion.table.at(-1)?.[0] ?? 1);
  return changed(loads, {motion: {law, duration_s}, rpm: undefined});
}
function motion_lines(loads: Loads): NumberLine[] {
  const {motion} = loads;
  if (!motion || !("law" in motion)) return [];
  const put = (change: object): Loads => ({...loads, motion: changed(motion, change)});
  const duration: NumberLine = {
    key: "law_duration",
    name: t("loads.law_duration"),
    value: motion.duration_s,
    unit: "s",
    low: 1e-6,
    high: 1e6,
    by: 0.1,
    with_value: (duration_s) => put({duration_s: duration_s ?? 1}),
  };
  if (motion.law !== "trapezoid") return [duration];
  return [
    duration,
    {
      key: "law_ramp",
      name: t("loads.law_ramp"),
      value: motion.ramp ?? null,
      unit: "",
      low: 0.001,
      high: 0.5,
      by: 0.05,
      optional: true,
      placeholder: "1/3",
      with_value: (ramp) => ({...loads, motion: changed(motion, {ramp: ramp ?? undefined})}),
    },
  ];
}

/** Of what nobody has given, with what the engine takes instead. */
export function rare_lines(loads: Loads, unit: string): NumberLine[] {
  const {gravity = {}, body, pins, rpm} = loads,
    with_pins = (change: object) => changed(loads, {pins: {radius: 0, friction: 0, ...pins, ...change}});
  const of_gravity: NumberLine[] = gravity
    ? [
        {
          key: "gravity_direction",
          name: t("loads.gravity_direction"),
          value: gravity.direction_deg ?? -90,
          unit: "°",
          by: 5,
          with_value: (value) => ({...loads, gravity: {...gravity, direction_deg: value ?? -90}}),
        },
        {
          key: "gravity_acceleration",
          name: t("loads.gravity_acceleration"),
          value: gravity.acceleration ?? usual_gravity,
          unit: "m/s²",
          low: 0,
          with_value: (value) => ({...loads, gravity: {...gravity, acceleration: value ?? usual_gravity}}),
        },
      ]
    : [];
  return [
    ...of_gravity,
    {
      key: "pin_radius",
      name: t("loads.pin_radius"),
      value: pins?.radius || null,
      unit,
      low: 0,
      optional: true,
      placeholder: "0",
      with_value: (value) => (value || pins?.friction ? with_pins({radius: value ?? 0}) : without_pins(loads)),
    },
    {
      key: "pin_friction",
      name: t("loads.pin_friction"),
      value: pins?.friction || null,
      unit: "",
      low: 0,
      high: 2,
      by: 0.01,
      optional: true,
      placeholder: "0",
      with_value: (value) => (value || pins?.radius ? with_pins({friction: value ?? 0}) : without_pins(loads)),
    },
    ...motion_lines(loads),
    {
      key: "rpm",
      name: t("loads.rpm"),
      value: rpm ?? null,
      unit: t("loads.per_minute"),
      low: 0,
      high: 1e6,
      by: 1,
      optional: true,
      placeholder: t("loads.slowly"),
      with_value: (value) => changed(loads, {rpm: value ?? undefined, ...(value === null ? {} : {motion: undefined})}),
    },
    ...(body
      ? [
          {
            ...inertia_line(body.inertia, (inertia) => ({...loads, body: changed(body, {inertia})})),
            key: "body_inertia",
            name: t("loads.body_inertia"),
          },
        ]
      : []),
  ];
}
const without_pins = (loads: Loads): Loads => changed(loads, {pins: undefined});

// ---- extra loads ----------------------------------------------------------------------------------------------------

export function extra_lines(loads: Loads, index: number, extra: ExtraLoad, unit: string): NumberLine[] {
  const put = (change: object) => with_extra(loads, index, change),
    places = place_lines([t("loads.at_x"), t("loads.at_y")], unit, extra.at, (at) => put({at}));
  if ("mass" in extra) {
    const with_value = (mass: number | null) => put({mass: mass ?? 0});
    return [{key: "mass", name: t("loads.extra_mass"), value: extra.mass, unit: "kg", low: 0, with_value}, ...places];
  }
  const forces = place_lines([t("loads.force_x"), t("loads.force_y")], "N", extra.force, (force) => put({force}));
  return [...prefixed("force", forces), ...places];
}

// ---- springs --------------------------------------------------------------------------------------------------------

type Gas = Extract<Spring, {kind: "gas"}>;
type OfSpring = (spring: Spring, loads: Loads, index: number, unit: string) => NumberLine[];
const putting =
  <S extends Spring>(loads: Loads, index: number) =>
  (change: Partial<S>) =>
    with_spring(loads, index, change);

/** What everybody gives. */
export const spring_lines: OfSpring = (spring, loads, index, unit) => {
  const put = putting<Spring>(loads, index);
  const line = (key: string, name: string, value: number, of: string, low = 0, by?: number): NumberLine => ({
    key,
    name,
    value,
    unit: of,
    low,
    by,
    with_value: (typed) => put({[key]: typed ?? undefined}),
  });
  const count: NumberLine = {
    ...line("count", t("loads.count"), spring.count ?? 1, "×", 1, 1),
    high: 1000,
    with_value: (value) => put({count: Math.max(Math.round(value ?? 1), 1)}),
  };
  switch (spring.kind) {
    case "gas": {
      const {F1, F2, F3, F4, extended_length, stroke} = spring,
        force = (key: "F1" | "F2" | "F3" | "F4", name: string, value: number) =>
          line(key, name, value, "N", above_nothing, 5);
      return [
        count,
        force("F1", t("loads.f1"), F1),
        force("F2", t("loads.f2"), F2),
        ...(F3 === undefined ? [line("friction", t("loads.friction"), friction_of(spring), "N", 0, 1)] : []),
        ...(F3 === undefined ? [] : [force("F3", t("loads.f3"), F3)]),
        ...(F4 === undefined ? [] : [force("F4", t("loads.f4"), F4)]),
        line("extended_length", t("loads.extended_length"), extended_length, unit, above_nothing),
        line("stroke", t("loads.stroke"), stroke, unit, above_nothing),
      ];
    }
    case "coil":
      return [
        count,
        line("rate", t("loads.rate"), spring.rate, `N/${unit || "1"}`),
        line("free_length", t("loads.free_length"), spring.free_length, unit),
      ];
    case "torsion":
      return [
        count,
        line("rate_per_deg", t("loads.rate"), spring.rate_per_deg, "N·m/°"),
        line("torque_at_position_1", t("loads.torque_at_position_1"), spring.torque_at_position_1 ?? 0, "N·m", -1e9),
      ];
  }
};
/** Leaves the strength free: each linkage has the best one. */
function strength_lines({best_F1}: Gas, put: (change: Partial<Gas>) => Loads): NumberLine[] {
  const most: NumberLine = {
    key: "best_F1",
    name: t("loads.best_f1_most"),
    value: best_F1?.max_F1 ?? null,
    unit: "N",
    low: 1,
    by: 5,
    optional: true,
    placeholder: "–",
    with_value: (value) => put({best_F1: value ? {...best_F1, max_F1: value} : undefined}),
  };
  if (!best_F1) return [most];
  return [
    most,
    {
      key: "best_F1_hold_open",
      name: t("loads.place_hold_open"),
      value: best_F1.min_hold_open ?? null,
      unit: "N",
      low: -1e9,
      by: 1,
      optional: true,
      placeholder: "–",
      with_value: (value) => put({best_F1: {...best_F1, min_hold_open: value ?? undefined}}),
    },
  ];
}
/** What a sheet of a gas spring may tell beside. */
export function rare_gas_lines(gas: Gas, loads: Loads, index: number, unit: string): NumberLine[] {
  const put = putting<Gas>(loads, index);
  return [
    {
      key: "measured_at",
      name: t("loads.measured_at"),
      value: gas.measured_at ?? null,
      unit,
      low: 0,
      optional: true,
      placeholder: "5 mm",
      with_value: (value) => put({measured_at: value ?? undefined}),
    },
    {
      key: "rod_diameter",
      name: t("loads.rod_diameter"),
      value: gas.rod_diameter || null,
      unit: "mm",
      low: 0,
      high: 1000,
      by: 1,
      optional: true,
      placeholder: "–",
      with_value: (value) => put({rod_diameter: value || undefined}),
    },
    {
      key: "percent_per_10K",
      name: t("loads.percent_per_10K"),
      value: gas.percent_per_10K ?? null,
      unit: "%",
      low: 0,
      high: 20,
      by: 0.1,
      optional: true,
      placeholder: "3.41",
      with_value: (value) => put({percent_per_10K: value ?? undefined}),
    },
    ...strength_lines(gas, put),
  ];
}
/** As sheets tell friction: by one number, or by the forces of compressing. */
export function with_compressing(gas: Gas, given: boolean): Partial<Gas> {
  const friction = friction_of(gas);
  if (!given) return {F3: undefined, F4: undefined, friction};
  return {friction: undefined, F3: gas.F1 + 2 * friction, F4: gas.F2 + 2 * friction};
}
export function stud_lines(stud: CarriedPoint, unit: string): NumberLine<CarriedPoint>[] {
  return place_lines(["x", "y"], unit, stud.at, (at) => ({...stud, at: at!}));
}
export type {Gas, LinearSpring, Side};

// ---- cases ----------------------------------------------------------------------------------------------------------

export function case_lines(loads: Loads, index: number, of: LoadCase): NumberLine[] {
  const put = (change: Partial<LoadCase>) => with_case(loads, index, change);
  return [
    {
      key: "temperature",
      name: t("loads.temperature"),
      value: of.temperature_C ?? default_temperature_C,
      unit: "°C",
      low: -273,
      high: 1000,
      by: 5,
      with_value: (value) => put({temperature_C: value ?? undefined}),
    },
    {
      key: "slope",
      name: t("loads.slope"),
      value: of.slope_deg ?? 0,
      unit: "°",
      low: -180,
      high: 180,
      by: 1,
      with_value: (value) => put({slope_deg: value || undefined}),
    },
    {
      key: "percent",
      name: t("loads.percent"),
      value: of.spring_percent ?? 100,
      unit: "%",
      low: 0,
      high: 1000,
      by: 5,
      with_value: (value) => put({spring_percent: value === 100 || value === null ? undefined : value}),
    },
  ];
}
export function exponent_line(loads: Loads, index: number, of: LoadCase): NumberLine {
  return {
    key: "exponent",
    name: t("loads.gas_exponent"),
    value: of.gas_exponent ?? 1,
    unit: "",
    low: 1,
    high: 1.67,
    by: 0.05,
    with_value: (value) => with_case(loads, index, {gas_exponent: value === 1 || value === null ? undefined : value}),
  };
}
