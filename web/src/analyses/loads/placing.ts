// A gas spring that is looked for: its studs in two boxes, what it is and what it has to do, as the engine reads it.
import type {Box, PlacedSpring, Point, StudEnd} from "../../contract/messages";
import {extent_of} from "../../kinds/kind_dispatch";
import {round_step, type Problem} from "../../state/problem";
import {grouped, significant} from "../../texts/numbers";
import {notice_text, t} from "../../texts/texts.svelte";
import {friction_of, loads_of, type Loads, type Spring} from "./block";
import {changed, without_spring} from "./editing";
import type {Gas, NumberLine} from "./fields";
import {force_text} from "./read_outs";
import {suggested_spring} from "./suggested";

export const stud_ends: readonly StudEnd[] = ["ground", "body"];
/** Null: not given. */
export interface Wanted {
  name: string;
  count: number;
  ratio: number; // F2 / F1, both without friction
  friction: number;
  measured_at: number | null;
  max_F1: number;
  min_hold_open: number | null;
  min_stroke: number | null;
  end_margin: number | null;
  end_length: number | null;
  ground: Box;
  body: Box;
}
/** A spring of the loads by its place in their list, or one more. */
export type Choice = number | "new";

const usual_strongest = 1200, // N: what a rod of 10 mm usually is sold for
  reach = 0.15; // of the linkage's size

export function is_gas(spring: Spring | undefined): spring is Gas {
  return spring?.kind === "gas";
}
/** In the list's order. */
export function choices_of({springs = []}: Loads): Choice[] {
  return [...springs.flatMap((spring, i) => (is_gas(spring) ? [i] : [])), "new"];
}
/** With the spring that is chosen taken out: all others stay as they are. */
export function without_chosen(problem: Problem, choice: Choice): Problem {
  const loads = loads_of(problem);
  return loads && choice !== "new" ? {...problem, loads: without_spring(loads, choice)} : problem;
}

function box_about([x, y]: Point, size: number): Box {
  const step = round_step(size / 100),
    round = (value: number, to: number) => Number((Math.round(value / to) * to).toPrecision(12)) + 0;
  const half = round(reach * size, step),
    along = (middle: number) => [round(middle - half, step / 10), round(middle + half, step / 10)] as const;
  return {x: along(x), y: along(y)};
}
/** What is looked for unless something else is typed. */
export function usual_wanted(problem: Problem, choice: Choice): Wanted | null {
  const loads = loads_of(problem);
  if (!loads) return null;
  const given = choice === "new" ? undefined : loads.springs?.[choice],
    suggested = suggested_spring(problem) as Gas,
    gas = is_gas(given) ? given : suggested;
  const friction = friction_of(gas),
    size = extent_of(problem.task),
    at = (end: StudEnd) => [gas.from, gas.to].find(({on}) => on === end)?.at,
    [ground, body] = [at("ground"), at("body")];
  const studs = ground && body ? {ground, body} : {ground: suggested.from.at, body: suggested.to.at};
  return {
    name: gas.name ?? suggested.name ?? "",
    count: gas.count ?? 1,
    ratio: Number(((gas.F2 + friction) / (gas.F1 + friction)).toFixed(3)),
    friction,
    measured_at: gas.measured_at ?? null,
    max_F1: Math.max(usual_strongest, 2 * gas.F1),
    min_hold_open: problem.requirements?.min_hold_open ?? null,
    min_stroke: null,
    end_margin: null,
    end_length: null,
    ground: box_about(studs.ground, size),
    body: box_about(studs.body, size),
  };
}

/** BOXES.json. */
export function boxes_text({name, count, ratio, friction, measured_at, ground, body, ...rest}: Wanted): string {
  const given = (of: object) => Object.fromEntries(Object.entries(of).filter(([, value]) => value !== null));
  const spring = given({kind: "gas", name, count, F2_over_F1: ratio, friction, measured_at});
  return JSON.stringify({linkwright: 1, spring, ground, body, ...given(rest)});
}

// ---- fields ---------------------------------------------------------------------------------------------------------

/** `place`: as the engine calls it in what it says of mistakes. */
export type WantedLine = NumberLine<Partial<Wanted>> & {place: string};

export function wanted_lines(wanted: Wanted, requirement: number | null): WantedLine[] {
  return [
    {
      key: "count",
      place: "spring.count",
      name: t("loads.count"),
      value: wanted.count,
      unit: "×",
      low: 1,
      high: 1000,
      by: 1,
      with_value: (value) => ({count: Math.max(Math.round(value ?? 1), 1)}),
    },
    {
      key: "ratio",
      place: "spring.F2_over_F1",
      name: t("loads.place_ratio"),
      value: wanted.ratio,
      unit: "",
      low: 1,
      high: 10,
      by: 0.01,
      with_value: (value) => ({ratio: value ?? 1}),
    },
    {
      key: "friction",
      place: "spring.friction",
      name: t("loads.friction"),
      value: wanted.friction,
      unit: "N",
      low: 0,
      by: 1,
      with_value: (value) => ({friction: value ?? 0}),
    },
    {
      key: "max_F1",
      place: "max_F1",
      name: t("loads.place_max_f1"),
      value: wanted.max_F1,
      unit: "N",
      low: 1e-9,
      by: 50,
      with_value: (value) => ({max_F1: value ?? usual_strongest}),
    },
    {
      key: "hold_open",
      place: "min_hold_open",
      name: t("loads.place_hold_open"),
      value: wanted.min_hold_open,
      unit: "N",
      optional: true,
      placeholder: requirement === null ? "–" : significant(requirement, 4),
      with_value: (min_hold_open) => ({min_hold_open}),
    },
  ];
}
export function length_lines(wanted: Wanted, unit: string): WantedLine[] {
  const line = (key: "min_stroke" | "end_margin" | "end_length", name: string, placeholder: string): WantedLine => ({
    key,
    place: key,
    name,
    value: wanted[key],
    unit,
    low: 0,
    optional: true,
    placeholder,
    with_value: (value) => ({[key]: value}),
  });
  return [
    line("min_stroke", t("loads.place_min_stroke"), "0"),
    line("end_margin", t("loads.place_end_margin"), "10 mm"),
    line("end_length", t("loads.place_end_length"), "0"),
  ];
}

// ---- what was found -------------------------------------------------------------------------------------------------

/** How good it is, and what is known of all other places. */
export function proof_text(placed: PlacedSpring, is_looking: boolean): string {
  const {spring, max_hand_force, at_stations, lower_bound, proven, places, why_not} = placed;
  if (!spring || max_hand_force === null)
    return why_not
      ? notice_text({...why_not, values: why_not.values ?? {}}, `loads.place_why_${why_not.code}`)
      : t("loads.place_nothing");
  const hand = hand_text(max_hand_force, at_stations),
    bound = lower_bound === null ? null : force_text(lower_bound);
  if (proven && bound !== null) {
    const share = at_stations ? Math.max(100 * (1 - lower_bound! / at_stations), 0) : 0;
    return t("loads.place_proved", {hand, bound, share: significant(share, 2)});
  }
  const n = grouped(places ?? 0),
    yet = t(is_looking ? "loads.place_not_yet" : "loads.place_not_proved");
  return bound === null ? t("loads.place_best", {hand, n, yet}) : t("loads.place_best_above", {hand, n, bound, yet});
}
/** The bound is below the force without the friction of pins, which is told where that is another. */
function hand_text(force: number, bare: number | null): string {
  const values = {force: force_text(force), bare: force_text(bare)};
  return bare === null || force - bare < 0.01 * force
    ? t("loads.place_hand", values)
    : t("loads.place_hand_both", values);
}
/** In the place of the one that was looked for, or as one more. */
export function with_placed(loads: Loads, choice: Choice, spring: Spring): Loads {
  const springs = [...(loads.springs ?? [])];
  if (choice === "new" || !springs[choice]) springs.push(spring);
  else springs[choice] = spring;
  return changed(loads, {springs});
}

// ---- the map of a stud ----------------------------------------------------------------------------------------------

/** Forces above are shown like this one: nine of ten cells are below. */
export function scale_of(force: readonly (number | null)[]): {low: number; high: number} | null {
  const known = force.filter((value) => value !== null).sort((a, b) => a - b);
  if (known.length === 0) return null;
  return {low: known[0]!, high: known[Math.floor(0.9 * (known.length - 1))]!};
}
export const levels = 16;
/** 0: the best. */
export function level_of(force: number, {low, high}: {low: number; high: number}): number {
  const share = high > low ? (force - low) / (high - low) : 0;
  return Math.min(Math.floor(share * levels), levels - 1);
}
