// The linkage with the point that follows the path.
import type {Linkage, Point} from "../../contract/messages";
import {tracing_four_bar} from "../../figure/tracing";
import {row_state} from "../../state/drive";
import {reached_rows} from "../../figure/mechanism";

/** Where the point gets to on its way through the points. */
function way_of(linkage: Linkage): Point[] {
  const {drive} = linkage;
  if (!drive) return [];
  return reached_rows(linkage).map((row) => {
    const {x, y} = row_state(drive, row);
    return [x, y];
  });
}
export const path_four_bar = tracing_four_bar(({path}) => path ?? null, way_of);
