// What a hand, or else the drive, has to do along the travel: the curves of all cases over one turn, or over the handle's way.
import type {LoadCurve, LoadsReply} from "../../contract/replies";
import type {LoadCaseReport, LoadPlace} from "../../contract/result";
import {extent} from "../../transport/plot";

type Values = readonly (number | null)[];
export interface EffortCase {
  name: string;
  open: Values;
  /** None where one curve says it all. */
  close: Values | null;
}
export const shown_forces = ["hand", "torque", "pin", "shaking"] as const;
export type Shown = (typeof shown_forces)[number];
export const abscissas = ["body", "path", "driver"] as const;
export type Over = (typeof abscissas)[number];
/** What was chosen, where there is that to show. */
export interface EffortChoice {
  of?: Shown | null;
  over?: Over | null;
}
export interface Effort {
  of: Shown;
  all_of: readonly Shown[];
  /** Which turn it is over, and with which sign, so that x rises; of the handle's way percents. */
  over: Over;
  all_over: readonly Over[];
  sense: 1 | -1;
  x: number[];
  /** Turn of the driver, station by station. */
  driver: number[];
  cases: EffortCase[];
  positions: {position: number; x: number}[];
  y: readonly [low: number, high: number];
}

const is_known = (values: Values): values is readonly number[] => values.every((value) => value !== null);
const has_some = (values: Values) => values.some((value) => value !== null);
function sense_of(values: readonly number[]): 1 | -1 | null {
  for (const sense of [1, -1] as const)
    if (values.every((value, i) => i === 0 || sense * value > sense * values[i - 1]!)) return sense;
  return null;
}
const of_place: Record<Over, (place: LoadPlace) => number | null> = {
  body: ({body_turn_deg}) => body_turn_deg,
  path: ({path}) => path && 100 * path,
  driver: ({driver_turn_deg}) => driver_turn_deg,
};
type Along = Pick<Effort, "over" | "sense" | "x">;
/** What keeps its sense: the body's turn before the handle's way before the driver's turn. */
function all_along({body_turn_deg, driver_turn_deg, path}: LoadCurve): Along[] {
  const all: Record<Over, Values> = {
    body: body_turn_deg,
    path: path.map((share) => share && 100 * share),
    driver: driver_turn_deg,
  };
  return abscissas.flatMap((over) => {
    const values = all[over],
      sense = is_known(values) ? sense_of(values) : null;
    return sense === null ? [] : [{over, sense, x: (values as readonly number[]).map((value) => sense * value + 0)}];
  });
}
function all_shown(curves: readonly LoadCurve[]): Shown[] {
  return shown_forces.filter((of) => curves.some((curve) => has_some(curve[of === "hand" ? "open" : of])));
}
function curve_of(curve: LoadCurve, of: Shown): EffortCase {
  const {name, open, close} = curve;
  return of === "hand" ? {name, open, close} : {name, open: curve[of], close: null};
}
export function effort_of({curves}: Pick<LoadsReply, "curves">, choice: EffortChoice = {}): Effort | null {
  const [first] = curves,
    ways = first ? all_along(first) : [],
    along = ways.find(({over}) => over === choice.over) ?? ways[0];
  if (!first || !along || along.x.length < 2 || !is_known(first.driver_turn_deg)) return null;
  const all_of = all_shown(curves),
    of = all_of.find((one) => one === choice.of) ?? all_of[0] ?? "pin",
    cases = curves.map((curve) => curve_of(curve, of));
  return {
    ...along,
    of,
    all_of,
    all_over: ways.map(({over}) => over),
    driver: [...first.driver_turn_deg],
    cases,
    positions: first.position.flatMap((position, i) => (position === null ? [] : [{position, x: along.x[i]!}])),
    y: extent([0, ...cases.flatMap(({open, close}) => [...open, ...(close ?? [])])], 0.08),
  };
}

/** Between two stations along a straight line; beyond the ends nothing. */
function between(from: readonly number[], to: Values, at: number): number | null {
  const rises = from.at(-1)! > from[0]!,
    order = (value: number) => (rises ? value : -value),
    after = from.findIndex((value) => order(value) >= order(at) - 1e-9);
  if (after < 0) return null;
  if (after === 0) return Math.abs(from[0]! - at) < 1e-6 ? to[0]! : null;
  const [a, b, low, high] = [from[after - 1]!, from[after]!, to[after - 1]!, to[after]!];
  return low === null || high === null ? null : low + ((at - a) / (b - a)) * (high - low);
}
/** Where on the plot the drive is. */
export function x_of_driver({driver, x}: Effort, angle_deg: number): number | null {
  return between(driver, x, angle_deg);
}
/** The drive's angle there, from its ends on the nearest. */
export function driver_at({driver, x}: Effort, at: number): number {
  const held = Math.min(Math.max(at, x[0]!), x.at(-1)!);
  return between(x, driver, held) ?? driver.at(-1)!;
}
/** Of a case, where the drive is. */
export function values_at(
  {driver, cases}: Effort,
  index: number,
  angle_deg: number,
): {open: number | null; close: number | null} {
  const {open, close} = cases[index]!;
  return {open: between(driver, open, angle_deg), close: close && between(driver, close, angle_deg)};
}

export interface EffortMark {
  kind: "rise" | "close" | "stable" | "unstable";
  x: number;
}
export interface EffortMarks {
  marks: EffortMark[];
  /** Where friction holds it. */
  rests: (readonly [from: number, to: number])[];
}
/** What a case does by itself, where the plot shows what moves it. */
export function marks_of({of, over, sense, x}: Effort, report: LoadCaseReport): EffortMarks {
  if (of === "pin" || of === "shaking") return {marks: [], rests: []};
  const x_of = (place: LoadPlace | null): number | null => {
    const at = place && of_place[over](place);
    return at === null ? null : sense * at + 0;
  };
  const mark = (kind: EffortMark["kind"], place: LoadPlace | null): EffortMark[] => {
    const at = x_of(place);
    return at === null ? [] : [{kind, x: at}];
  };
  const [begin, end] = [x[0]!, x.at(-1)!],
    is_inside = ({x: at}: EffortMark) => at > begin + 1e-9 && at < end - 1e-9; // else it does so all the way
  const moves = of === "hand" ? [...mark("rise", report.self_rise), ...mark("close", report.self_close)] : [];
  return {
    marks: [
      ...moves.filter(is_inside),
      ...report.equilibria.flatMap(({at, stable}) => mark(stable ? "stable" : "unstable", at)),
    ],
    rests: report.rests.flatMap(({from, to}) => {
      const [a, b] = [x_of(from), x_of(to)];
      return a === null || b === null ? [] : [[Math.min(a, b), Math.max(a, b)] as const];
    }),
  };
}

/** Beside the plot's own field, in pixels: the strips below it stand under the same x. */
export const plot_left = 46,
  plot_right = 12;
