// What acts on a linkage, as the problem file has it: masses in kg, forces in N, points in the user's unit.
import {
  driver_laws,
  four_bar_joints,
  loaded_bodys,
  read_outs,
  type BodyMass,
  type CarriedPoint,
  type DriverMotion,
  type ExtraLoad,
  type GasSpring,
  type Gravity,
  type Handle,
  type LinkMass,
  type LinkMasses,
  type LoadCase,
  type Loads,
  type Pins,
  type ReadOut,
  type Spring,
} from "../../contract/problem";
import {is_number, is_object, is_pair} from "../../state/shape";
import type {Problem} from "../../state/problem";

export type {CarriedPoint, ExtraLoad, LoadCase, Loads, Spring};
/** A spring between two studs. */
export type LinearSpring = Extract<Spring, {kind: "gas" | "coil"}>;
type Gas = Extract<Spring, {kind: "gas"}>;

const most_members = 100,
  longest_name = 100;

/** Undefined: it is none. */
type Read = (value: unknown) => unknown;
const number: Read = (value) => (is_number(value) ? value : undefined);
const positive: Read = (value) => (is_number(value) && value > 0 ? value : undefined);
const not_negative: Read = (value) => (is_number(value) && value >= 0 ? value : undefined);
const point: Read = (value) => (is_pair(value) ? value : undefined);
const flag: Read = (value) => (typeof value === "boolean" ? value : undefined);
const name: Read = (value) => (typeof value === "string" ? value.slice(0, longest_name) : undefined);
const one_of =
  (names: readonly string[]): Read =>
  (value) =>
    names.find((name) => name === value);
const or_null =
  (read: Read): Read =>
  (value) =>
    value === null ? null : read(value);
const list =
  (read: Read): Read =>
  (value) =>
    Array.isArray(value)
      ? value
          .slice(0, most_members)
          .map(read)
          .filter((item) => item !== undefined)
      : undefined;
/** The members that are right; nothing without those that must be there. */
function object<T extends object>(members: Record<keyof T & string, Read>, ...needed: (keyof T & string)[]) {
  return (value: unknown): T | undefined => {
    if (!is_object(value)) return undefined;
    const read = Object.entries(value)
      .filter(([key]) => Object.hasOwn(members, key))
      .map(([key, member]) => [key, members[key as keyof T & string](member)] as const)
      .filter(([, member]) => member !== undefined);
    const found = Object.fromEntries(read);
    return needed.every((key) => Object.hasOwn(found, key)) ? (found as T) : undefined;
  };
}

type AllOf<T> = {[K in T extends unknown ? keyof T : never]: unknown};
const carried_point = object<CarriedPoint>({on: one_of(loaded_bodys), at: point}, "on", "at");
const body_mass = object<BodyMass>({mass: not_negative, center: point, inertia: not_negative}, "mass");
const read_link_mass = object<AllOf<LinkMass>>({
  kg_per_m: not_negative,
  mass: not_negative,
  center: point,
  inertia: not_negative,
});
const link_mass: Read = (value) => {
  const read = read_link_mass(value);
  return read && ("mass" in read || "kg_per_m" in read) ? read : undefined;
};
const read_extra = object<AllOf<ExtraLoad>>(
  {
    name,
    on: one_of(loaded_bodys),
    at: point,
    mass: not_negative,
    force: point,
    frame: one_of(["fixed", "body"]),
    always: flag,
  },
  "name",
  "on",
  "at",
);
const extra_load: Read = (value) => {
  const read = read_extra(value);
  return read && ("mass" in read || "force" in read) ? read : undefined;
};
const fixed_direction = object<{fixed_deg: number}>({fixed_deg: number}, "fixed_deg");
const handle = object<Handle>(
  {point, direction: (value) => one_of(["tangential", "vertical"])(value) ?? fixed_direction(value)},
  "point",
);
const of_spring = {name, count: positive, kind: one_of(["gas", "coil", "torsion"])};
const between = {...of_spring, from: carried_point, to: carried_point};
const free_strength = object<NonNullable<Gas["best_F1"]>>(
  {min_F1: not_negative, max_F1: positive, min_hold_open: number},
  "max_F1",
);
const springs: Record<Spring["kind"], Read> = {
  gas: object<Gas>(
    {
      ...between,
      extended_length: positive,
      stroke: positive,
      measured_at: not_negative,
      F1: positive,
      F2: positive,
      F3: positive,
      F4: positive,
      friction: not_negative,
      rod_diameter: not_negative,
      percent_per_10K: or_null(number),
      best_F1: free_strength,
    },
    ...(["kind", "from", "to", "extended_length", "stroke", "F1", "F2"] as const),
  ),
  coil: object<Extract<Spring, {kind: "coil"}>>(
    {
      ...between,
      rate: not_negative,
      free_length: not_negative,
      acts: one_of(["both", "tension", "compression"]),
    },
    ...(["kind", "from", "to", "rate", "free_length"] as const),
  ),
  torsion: object<Extract<Spring, {kind: "torsion"}>>(
    {...of_spring, joint: one_of(four_bar_joints), rate_per_deg: number, torque_at_position_1: number},
    ...(["kind", "joint", "rate_per_deg"] as const),
  ),
};
const spring: Read = (value) => {
  const kind = is_object(value) && (Object.keys(springs) as Spring["kind"][]).find((name) => name === value.kind);
  return kind ? springs[kind](value) : undefined;
};
const cylinder = object<{cylinder: unknown}>(
  {cylinder: object<{from: CarriedPoint; to: CarriedPoint}>({from: carried_point, to: carried_point}, "from", "to")},
  "cylinder",
);
const load_case = object<LoadCase>(
  {
    name,
    temperature_C: number,
    slope_deg: number,
    extra: list(name),
    spring_percent: not_negative,
    gas_exponent: positive,
    for: list(one_of(read_outs)),
  },
  "name",
);
const read_motion = object<AllOf<DriverMotion>>({
  law: one_of(driver_laws),
  duration_s: positive,
  ramp: positive,
  table: list(point),
});
const motion: Read = (value) => {
  const read = read_motion(value);
  return read && ("table" in read || ("law" in read && "duration_s" in read)) ? read : undefined;
};
const loads = object<Loads>({
  gravity: or_null(object<Gravity>({direction_deg: number, acceleration: not_negative})),
  body: body_mass,
  links: object<LinkMasses>({input: link_mass, coupler: link_mass, output: link_mass}),
  extra: list(extra_load),
  handle,
  springs: list(spring),
  pins: object<Pins>({radius: not_negative, friction: not_negative}, "radius", "friction"),
  drive: (value) => one_of(["hand", "input", "output"])(value) ?? cylinder(value),
  rpm: or_null(number),
  motion,
  cases: list(load_case),
  stations: positive,
});
/** From outside, member by member; the engine says in detail what is wrong. */
export function read_loads(value: unknown): Loads | null {
  return loads(value) ?? null;
}

declare module "../../state/problem" {
  interface Problem {
    loads?: Loads;
  }
}
export function loads_of({loads}: Pick<Problem, "loads">): Loads | null {
  return loads ?? null;
}

// ---- what is given --------------------------------------------------------------------------------------------------

export const is_between_studs = (spring: Spring): spring is LinearSpring => spring.kind !== "torsion";
export const default_temperature_C = 20,
  usual_gravity = 9.81;
const default_cases: readonly LoadCase[] = [{name: "room"}]; // as the engine has it
export function cases_of({cases}: Loads): readonly LoadCase[] {
  return cases?.length ? cases : default_cases;
}
/** Whether a case counts where the worst of a read-out is sought. */
export function counts_for(of: LoadCase, read_out: ReadOut): boolean {
  return !of.for?.length || of.for.includes(read_out);
}
export type DriveKind = "hand" | "input" | "output" | "cylinder";
export function drive_of({drive = "hand"}: Loads): DriveKind {
  return typeof drive === "object" ? "cylinder" : drive;
}
/** What is told of loads only with more of them. */
export function has_of(loads: Loads, needs: string): boolean {
  switch (needs) {
    case "loads":
      return true;
    case "hand":
      return loads.handle !== undefined;
    case "free":
      return loads.springs?.some((one) => one.kind === "gas" && one.best_F1 !== undefined) ?? false;
    case "crank":
      return drive_of(loads) === "input" || drive_of(loads) === "output";
    default:
      return needs === "cylinder" && drive_of(loads) === "cylinder";
  }
}
/** Half of the difference of compressing and extending, near the extended end. */
export function friction_of({F1, F3, friction}: GasSpring): number {
  return friction ?? (F3 === undefined ? 0 : (F3 - F1) / 2);
}
