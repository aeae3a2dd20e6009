// Given pivots and lines of pivots: what three positions, and lines what four, give beside the poses.
import type {Linkage, Point, Side} from "../../contract/messages";
import {is_number, is_object, is_pair} from "../../state/shape";
import type {Given, Line, PivotKind, PivotLines, PivotOnLine, SinglePivots} from "./task";

export const sides = ["input", "output"] as const;
export const pivot_kinds = ["ground", "moving"] as const;

export interface GivenPivot {
  kind: PivotKind;
  point: Point;
}
/** By link; at least one. */
export type GivenPivots = Partial<Record<Side, GivenPivot>>;
export type Lines = Partial<Record<PivotKind, Line>>;

/** The pivots that are given, in whatever form; null: other things are. */
export function pivots_of(given: Given | null): GivenPivots | null {
  if (!given) return null;
  for (const kind of pivot_kinds) {
    const both = (given as Partial<Record<string, Record<Side, Point>>>)[`${kind}_pivots`];
    if (both) return {input: {kind, point: both.input}, output: {kind, point: both.output}};
  }
  const found: GivenPivots = {};
  for (const side of sides)
    for (const kind of pivot_kinds) {
      const point = (given as SinglePivots)[`${side}_${kind}_pivot`];
      if (point) found[side] = {kind, point};
    }
  return found.input || found.output ? found : null;
}
/** As the file has them. */
export function given_pivots({input, output}: GivenPivots): Given {
  if (input && output && input.kind === output.kind) {
    const both = {input: input.point, output: output.point};
    return input.kind === "ground" ? {ground_pivots: both} : {moving_pivots: both};
  }
  return {
    ...(input ? {[`input_${input.kind}_pivot`]: input.point} : {}),
    ...(output ? {[`output_${output.kind}_pivot`]: output.point} : {}),
  } as SinglePivots;
}
export function lines_of(given: Given | null): Lines | null {
  const {ground_pivot_on: ground, moving_pivot_on: moving} = (given ?? {}) as PivotLines;
  return ground || moving ? {...(ground ? {ground} : {}), ...(moving ? {moving} : {})} : null;
}
export function given_lines({ground, moving}: Lines): Given {
  return {...(ground ? {ground_pivot_on: ground} : {}), ...(moving ? {moving_pivot_on: moving} : {})};
}

/** Both pivots by name, or as a list, the input's first. */
function read_both(value: unknown): Record<Side, Point> | null {
  if (Array.isArray(value))
    return value.length === 2 && is_pair(value[0]) && is_pair(value[1]) ? {input: value[0], output: value[1]} : null;
  return is_object(value) && is_pair(value.input) && is_pair(value.output)
    ? {input: value.input, output: value.output}
    : null;
}
export function read_pivots(value: Record<string, unknown>): Given | null {
  const [ground, moving] = [read_both(value.ground_pivots), read_both(value.moving_pivots)];
  if (ground) return {ground_pivots: ground};
  if (moving) return {moving_pivots: moving};
  const found: GivenPivots = {};
  for (const side of sides)
    for (const kind of pivot_kinds) {
      const point = value[`${side}_${kind}_pivot`];
      if (is_pair(point)) found[side] ??= {kind, point};
    }
  return found.input || found.output ? given_pivots(found) : null;
}
export function read_line(value: unknown): Line | null {
  return is_object(value) && is_pair(value.point) && is_number(value.direction_deg)
    ? {point: value.point, direction_deg: value.direction_deg}
    : null;
}
export function read_lines(value: Record<string, unknown>): Given | null {
  const ground = read_line(value.ground_pivot_on),
    moving = read_line(value.moving_pivot_on);
  return ground || moving ? given_lines({...(ground ? {ground} : {}), ...(moving ? {moving} : {})}) : null;
}
export function read_pivot_on(value: unknown): PivotOnLine[] | null {
  if (!Array.isArray(value)) return null;
  const found = value.flatMap((item: unknown): PivotOnLine[] => {
    const line = is_object(item) ? read_line(item.line) : null;
    return is_object(item) &&
      line &&
      (item.which === "input" || item.which === "output") &&
      (item.pivot === "ground" || item.pivot === "moving")
      ? [{which: item.which, pivot: item.pivot, line}]
      : [];
  });
  return found.length ? found : null;
}

/** The point at this place along a line, from its own. */
export function on_line({point: [x, y], direction_deg}: Line, along: number): Point {
  const angle = (direction_deg * Math.PI) / 180;
  return [x + along * Math.cos(angle), y + along * Math.sin(angle)];
}
export function turned_line({point, direction_deg}: Line, moved: (p: Point) => Point): Line {
  const from = moved(point),
    to = moved(on_line({point, direction_deg}, 1));
  return {point: from, direction_deg: clean((Math.atan2(to[1] - from[1], to[0] - from[0]) * 180) / Math.PI)};
}
/** The same on a drawing that was moved. */
export function moved_given(given: Given, moved: (p: Point) => Point): Given {
  const pivots = pivots_of(given),
    lines = lines_of(given);
  if (pivots) {
    const there = Object.entries(pivots).map(([side, {kind, point}]) => [side, {kind, point: moved(point)}]);
    return given_pivots(Object.fromEntries(there) as GivenPivots);
  }
  if (lines) {
    const there = Object.entries(lines).map(([kind, line]) => [kind, turned_line(line, moved)]);
    return given_lines(Object.fromEntries(there) as Lines);
  }
  return "instant_center" in given ? {...given, instant_center: moved(given.instant_center)} : given;
}

const clean = (value: number): number => Number(value.toPrecision(9));
/** Where a linkage has its pivot of a kind, in round numbers. */
export function pivot_of(hand: Linkage | null, side: Side, kind: PivotKind, around: Point): Point {
  const found = hand?.[side][kind === "ground" ? "center" : "circle"] ?? around;
  return found.map((value) => Number(value.toPrecision(4))) as unknown as Point;
}
