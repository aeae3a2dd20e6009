// The links of the linkage in hand, to be printed.
import type {Linkage} from "../../engine/protocol";
import {task_rows} from "../../figure/mechanism";
import type {OwnFile} from "../view";
import {fitting_sizes, link_solids, shell_order, stl} from "./print";
import {all_rows, first_stand, stands} from "./space";

const every = 4; // states

function solids_of(linkage: Linkage): Blob {
  const {spherical, drive} = linkage;
  if (!spherical) throw new Error("no axes");
  const first = first_stand(spherical),
    sizes = fitting_sizes(first),
    states = drive ? stands(linkage, task_rows(drive) ?? all_rows(drive), every) : [first],
    {order} = shell_order(states, sizes);
  return new Blob([
    stl(Object.values(link_solids(first, order, sizes)).flat(), "Linkwright: links of a spherical four-bar"),
  ]);
}
export const spherical_files: readonly OwnFile[] = [
  {format: "stl", name: "export.stl", about: "export.stl_inside", extension: "stl", type: "model/stl", made: solids_of},
];
