import type {Drive, Linkage} from "../contract/messages";
import {at_row, type Configuration, type Mechanism} from "../figure/mechanism";
import {angle_of_row, row_count} from "../state/drive";
import {played_span} from "./play";

/** The linkage in each state of the task, or of the whole travel. */
export function shown_configurations(
  mechanism: Mechanism,
  linkage: Linkage,
  drive: Drive,
  whole: boolean,
): Configuration[] {
  const [low, high] = played_span(drive, whole);
  return Array.from({length: row_count(drive)}, (_, row) => row)
    .filter((row) => angle_of_row(drive, row) >= low && angle_of_row(drive, row) <= high)
    .map((row) => at_row(mechanism, linkage, drive, row));
}
