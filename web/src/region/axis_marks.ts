// What stands along a map axis: names of its blocks, numbers, ∞ marks, poles, nodes, in pixels.
import type {Axis, AxisQuantity, Branch, Side, Special} from "../contract/messages";
import {is_discrete, place_of} from "../engine/axis";
import {significant} from "../texts/numbers";
import type {TermName} from "../terms/pictures";
import {t, type TextKey} from "../texts/texts.svelte";
import {round_step} from "../state/problem";
import {pixel_of, type Scale} from "./scale";
import {most_of} from "../state/ends";

const branch_texts: Record<string, TextKey> = {
  odd: "curve.odd",
  oval: "curve.oval",
  nodal: "curve.nodal",
  line: "curve.line",
  circle: "curve.circle_part",
  conic: "curve.conic",
  line_at_infinity: "curve.line_at_infinity",
  point: "curve.single_point",
  great_circle: "curve.great_circle",
  cone: "curve.cone",
  center_line: "curve.center_line",
  fixed_circle: "curve.fixed_circle",
  direct: "axis.direct",
  opposite: "axis.opposite",
};
const branch_terms: Record<string, TermName> = {odd: "branch_infinity", oval: "branch_closed", nodal: "node"};
const sheets: Record<string, string> = {sheet_1: "I", sheet_2: "II", sheet_1_opposite: "III", sheet_2_opposite: "IV"};
const unnamed = ["range", "arms"];
const quantity_texts: Partial<Record<AxisQuantity, TextKey>> = {
  side_direction: "axis.side_direction",
  side_length: "axis.side_length",
  output_scale: "axis.output_scale",
  pair_output: "axis.pair_output",
  link_direction: "axis.link_direction",
  link_ray: "axis.link_ray",
  point_ray: "axis.point_ray",
  pole_height: "axis.pole_height",
  pivot_height: "axis.pivot_height",
  frame_height: "axis.frame_height",
  pivot_distance: "axis.pivot_distance",
  output_arm: "axis.output_arm",
  link_length: "axis.link_length",
  crank_length: "axis.crank_length",
  point_arm: "axis.point_arm",
  crank_range: "axis.crank_range",
  center_x: "axis.center_x",
  center_y: "axis.center_y",
  circle_x: "axis.circle_x",
  circle_y: "axis.circle_y",
  center_on_line: "axis.center_on_line",
  circle_on_line: "axis.circle_on_line",
  arm_reach: "axis.arm_reach",
  arm_difference: "axis.arm_difference",
};
/** Of straight lines: what of several linkages at a place the layer's are. */
const layers: Record<string, TextKey> = {
  alpha: "axis.layer_alpha",
  alpha_plus_90: "axis.layer_alpha_plus_90",
  first: "axis.layer_first",
  second: "axis.layer_second",
  minimax: "axis.layer_minimax",
  near_minimax: "axis.layer_near_minimax",
  AB: "axis.layer_ab",
  AD: "axis.layer_ad",
  BD: "axis.layer_bd",
  DB: "axis.layer_bd",
};
export function has_layers({branches}: Axis): boolean {
  return branches.length > 1 && branches.every(({name}) => name in layers);
}

export interface AxisBar {
  start: number;
  end: number;
  text: string;
  /** What the text may take. */
  room: number;
  term: TermName | null;
}
export interface AxisMark {
  kind: "pole" | "node" | "infinity";
  at: number;
  text: string;
}

export interface AxisNumber {
  at: number;
  text: string;
}

/** `say`: a text of the frame as the kind of task says it (kind_dispatch.text_for). */
type Say = (key: TextKey) => TextKey;

export function block_text(axis: Axis, index: number, say: Say): string {
  const branch = axis.blocks[index]?.branch ?? -1,
    halves = axis.blocks.filter((block) => block.branch === branch),
    name = axis.branches[branch]?.name ?? "range";
  const layer = layers[name];
  if (layer && axis.branches.length > 1) return t(layer);
  if (axis.quantity === "nothing") return "";
  if (axis.quantity === "realisation") return t("axis.realisation", {n: branch + 1});
  if (is_discrete(axis)) return String(branch + 1);
  if (unnamed.includes(name) || name === axis.quantity) return "";
  if (sheets[name]) return t("axis.sheet", {n: sheets[name]});
  if (name.startsWith("direction_")) return t("axis.direction", {n: branch + 1});
  if (axis.branches.length === 1 && halves.length === 2)
    return t(halves[0] === axis.blocks[index] ? "region.first_half" : "region.second_half");
  const key = branch_texts[name];
  return key ? t(say(key)) : name;
}
/** A term of the frame explains the frame's own words only. */
function term_of({name}: Branch, say: Say): TermName | null {
  const key = branch_texts[name];
  return key && say(key) === key ? (branch_terms[name] ?? null) : null;
}
function branch_of(axis: Axis, block: number): Branch | undefined {
  return axis.branches[axis.blocks[block]?.branch ?? -1];
}
/** Each block with what its numbers are, if it has any, and its name. */
export function axis_bars(axis: Axis, side: Side, scale: Scale, unit: string, say: Say): AxisBar[] {
  const key = quantity_texts[axis.quantity],
    of = side === "input" ? "₁" : "₂";
  const quantity = key ? [t(key, {of, unit}).trim()] : [],
    step = axis.quantity === "layer" || axis.quantity === "fitted_curve" ? numbered_every(axis, scale) : 1;
  return scale.pieces.map(({start, end, block}) => {
    const name = (block + 1) % step === 0 ? block_text(axis, block, say) : "",
      branch = branch_of(axis, block);
    return {
      start,
      end,
      text: [...quantity, ...(name ? [name] : [])].join(" · "),
      room: (end - start) * step,
      term: branch ? term_of(branch, say) : null,
    };
  });
}

/** Of a few linkages, numbered: each so many-th, as there is room. */
function numbered_every({branches}: Axis, {pieces}: Scale): number {
  const width = pieces[0] ? pieces[0].end - pieces[0].start : 0,
    digits = String(branches.length).length;
  return [1, 2, 5, 10, 20].find((step) => step * width > digits * digit_px) ?? 50;
}
const digit_px = 7;

const number_px = 34,
  every = [1, 2, 3, 4, 6, 12];

const angles: readonly AxisQuantity[] = [
  "side_direction",
  "pair_output",
  "link_direction",
  "link_ray",
  "point_ray",
  "crank_range",
];
export function is_angle(quantity: AxisQuantity): boolean {
  return angles.includes(quantity);
}
function number_text(quantity: AxisQuantity, value: number): string {
  if (is_angle(quantity)) return `${significant(value, 3)}°`;
  return quantity === "output_scale" ? `×${significant(value, 2)}` : significant(value, 3);
}
type Tick = readonly [tau: number, value: number];

/** Round values where the engine's ticks of a branch lie evenly, a step for each so many pixels; else those ticks. */
function round_ticks(ticks: readonly Tick[], {from, to}: Branch, pixels: number): readonly Tick[] {
  const first = ticks[0],
    last = ticks.at(-1);
  if (!first || !last || first === last) return ticks;
  const slope = (last[1] - first[1]) / (last[0] - first[0]),
    value_at = (tau: number) => first[1] + slope * (tau - first[0]);
  const [low, high] = slope > 0 ? [value_at(from), value_at(to)] : [value_at(to), value_at(from)];
  const is_even = ticks.every(([tau, value]) => Math.abs(value_at(tau) - value) <= 1e-6 * (high - low));
  if (!is_even || !(high > low)) return ticks;
  const step = round_step(((high - low) * number_px) / pixels),
    begin = Math.ceil(low / step - 1e-9);
  const values = Array.from({length: Math.floor(high / step + 1e-9) - begin + 1}, (_, i) =>
    Number(((begin + i) * step).toPrecision(9)),
  );
  return values
    .map((value): Tick => [Math.max(first[0] + (value - first[1]) / slope, from), value])
    .sort(([a], [b]) => a - b);
}

/** The engine's ticks, as many of each block as there is room for: where an axis leaves out what has no dyads, some lie
 *  close together. */
export function axis_numbers(axis: Axis, scale: Scale): AxisNumber[] {
  const is_length = !is_angle(axis.quantity) && axis.quantity !== "output_scale";
  return scale.pieces.flatMap(({block, from, to, start, end}) => {
    const branch = branch_of(axis, block);
    const told = (axis.ticks ?? []).filter(([tau]) => branch && tau >= branch.from && tau < branch.to);
    const own = (branch && is_length ? round_ticks(told, branch, Math.abs(end - start)) : told).flatMap(
      ([tau, value], index) => {
        const place = place_of(axis, tau);
        return place !== null && place >= from && place < to
          ? [{index, at: pixel_of(scale, place), text: number_text(axis.quantity, value)}]
          : [];
      },
    );
    const widest = Math.max(most_of(own.slice(1).map(({at}, i) => at - own[i]!.at)), 0) || Infinity;
    const step = every.find((k) => k * widest >= number_px) ?? own.length;
    let last = -Infinity;
    return own.filter(({index, at}) => {
      const fits = index % step === 0 && at - last >= number_px && at <= end - number_px / 2;
      if (fits) last = at;
      return fits;
    });
  });
}

function mark_text(special: Special): string {
  if (special.kind === "pole" && special.positions)
    return t("curve.pole", {i: special.positions[0], j: special.positions[1]});
  if (special.kind === "node") return t("curve.node");
  return t(special.kind === "center_at_infinity" ? "curve.slider_fixed" : "curve.slider_moving");
}
export function axis_marks(axis: Axis, specials: readonly Special[], scale: Scale): AxisMark[] {
  const marks: AxisMark[] = [];
  const first = scale.pieces[0],
    last = scale.pieces[scale.pieces.length - 1];
  for (const special of specials) {
    if (special.kind === "focus") continue;
    const kind = special.kind === "pole" || special.kind === "node" ? special.kind : "infinity";
    for (const tau of special.tau) {
      const place = place_of(axis, tau);
      if (place === null || place < first!.from || place > last!.to) continue;
      marks.push({kind, at: pixel_of(scale, place), text: mark_text(special)});
    }
  }
  return marks;
}
