// What stands along a map axis: names of its blocks, ∞ marks, poles, nodes, in pixels.
import type {Axis, Special} from "../engine/protocol";
import {place_of} from "../state/axis";
import {t, type TextKey} from "../texts/texts.svelte";
import {pixel_of, type Scale} from "./scale";

const branch_texts: Record<string, TextKey> = {
  odd: "curve.odd", oval: "curve.oval", nodal: "curve.nodal", line: "curve.line", circle: "curve.circle_part", conic: "curve.conic",
  line_at_infinity: "curve.line_at_infinity", point: "curve.single_point", center_line: "curve.center_line",
};

export interface AxisBar {
  start: number;
  end: number;
  text: string;
}
export interface AxisMark {
  kind: "pole" | "node" | "infinity";
  at: number;
  text: string;
}

export function block_text(axis: Axis, index: number): string {
  const {branch} = axis.blocks[index], halves = axis.blocks.filter((block) => block.branch === branch);
  if (axis.branches.length === 1 && halves.length === 2) return t(halves[0] === axis.blocks[index] ? "region.first_half" : "region.second_half");
  const key = branch_texts[axis.branches[branch].name];
  return key ? t(key) : axis.branches[branch].name;
}
export function axis_bars(axis: Axis, scale: Scale): AxisBar[] {
  return scale.pieces.map(({start, end, block}) => ({start, end, text: axis.blocks[block] ? block_text(axis, block) : ""}));
}

function mark_text(special: Special): string {
  if (special.kind === "pole" && special.positions) return t("curve.pole", {i: special.positions[0], j: special.positions[1]});
  if (special.kind === "node") return t("curve.node");
  return t(special.kind === "center_at_infinity" ? "curve.slider_fixed" : "curve.slider_moving");
}
export function axis_marks(axis: Axis, specials: readonly Special[], scale: Scale): AxisMark[] {
  const marks: AxisMark[] = [];
  const first = scale.pieces[0], last = scale.pieces[scale.pieces.length - 1];
  for (const special of specials) {
    if (special.kind === "focus") continue;
    const kind = special.kind === "pole" || special.kind === "node" ? special.kind : "infinity";
    for (const tau of special.tau) {
      const place = place_of(axis, tau);
      if (place === null || place < first.from || place > last.to) continue;
      marks.push({kind, at: pixel_of(scale, place), text: mark_text(special)});
    }
  }
  return marks;
}
