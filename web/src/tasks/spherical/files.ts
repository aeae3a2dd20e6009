// The links of the linkage in hand, to be printed, and whether they can move when they are.
import type {Linkage} from "../../engine/protocol";
import {task_rows} from "../../figure/mechanism";
import {angle_of_row} from "../../state/drive";
import {least_of, most_of} from "../../state/ends";
import {fixed, grouped} from "../../texts/numbers";
import {t} from "../../texts/texts.svelte";
import type {FileReport, OwnFile} from "../view";
import {laid_out, type Clash, type Layout} from "./layers";
import {fitting_sizes, link_solids, pins, shells, stl} from "./print";
import {all_rows, first_stand, stands} from "./space";

const layouts = new WeakMap<Linkage, Layout>();
function layout_of(linkage: Linkage): Layout {
  const {spherical, drive} = linkage;
  if (!spherical) throw new Error("no axes");
  const known = layouts.get(linkage);
  if (known) return known;
  const first = first_stand(spherical),
    states = drive ? stands(linkage, all_rows(drive)) : [first],
    found = laid_out(states, drive && task_rows(drive), fitting_sizes(first));
  layouts.set(linkage, found);
  return found;
}
function solids_of(linkage: Linkage): Blob {
  const {order, sizes} = layout_of(linkage),
    links = Object.values(link_solids(first_stand(linkage.spherical!), order, sizes)).flat(),
    beside = most_of(links.map(([x]) => x)),
    floor = least_of(links.map(([, , z]) => z));
  return new Blob([
    stl([...links, ...pins(order, sizes, beside, floor)], "Linkwright: links of a spherical four-bar, and their pins"),
  ]);
}

/** Of the pair that collides in most states. */
function worst_of(clashes: readonly Clash[]): Clash[] {
  const pairs = new Map<string, Clash[]>();
  for (const clash of clashes) {
    const key = clash.links.toSorted().join();
    pairs.set(key, [...(pairs.get(key) ?? []), clash]);
  }
  return [...pairs.values()].reduce((worst, pair) => (pair.length > worst.length ? pair : worst));
}
function report(linkage: Linkage): FileReport | null {
  const {drive} = linkage;
  if (!drive) return null;
  const {order, sizes, clashes} = layout_of(linkage),
    [first, last] = task_rows(drive) ?? all_rows(drive),
    in_task = clashes.filter(({state}) => state >= first && state <= last),
    radius = fixed(shells(order, sizes)[order.at(-1)!].outer, 0);
  if (clashes.length === 0) return {text: t("spherical.print_free", {radius, n: grouped(all_rows(drive)[1] + 1)})};
  const worst = worst_of(in_task.length ? in_task : clashes),
    [a, b] = worst[0]!.links.map((link) => t(`num.${link}`)) as [string, string],
    angles = worst.map(({state}) => angle_of_row(drive, state));
  const range = {from: fixed(least_of(angles), 0), to: fixed(most_of(angles), 0)};
  if (in_task.length === 0) return {text: t("spherical.print_task_free", {radius, a, b, ...range})};
  return {text: t("spherical.print_collide", {radius, a, b, ...range}), is_warning: true};
}
export const spherical_files: readonly OwnFile[] = [
  {
    format: "stl",
    name: "export.stl",
    about: "export.stl_inside",
    extension: "stl",
    type: "model/stl",
    made: solids_of,
    report,
  },
];
