// The linkage with the point that runs straight.
import type {Linkage, Point} from "../../contract/messages";
import {tracing_four_bar} from "../../figure/tracing";
import {row_state} from "../../state/drive";

/** The point, and where it gets to while it runs straight. */
function stretch_of({straight_line: line, drive}: Linkage): Point[] {
  if (!line) return [];
  const [first, last] = drive?.task ?? [-1, -1];
  const ends = drive && first >= 0 && last >= 0 ? [first, last].map((row) => row_state(drive, row)) : [];
  return [line.point, ...ends.map(({x, y}): Point => [x, y])];
}

export const straight_four_bar = tracing_four_bar(({straight_line: line}) => line ?? null, stretch_of);
