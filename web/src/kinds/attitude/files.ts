// What is known of an attitude, as the program writes it, and the picture of it.
import {stage_picture} from "../../exports/raster";
import type {Workbench} from "../../state/workbench.svelte";
import type {TaskFile} from "../view";
import {desk_of} from "./desk.svelte";
import type {AttitudeReply} from "./reply";

function report(of: "convert" | "screw" | "rates"): TaskFile {
  return {
    format: of,
    name: `attitude.report_${of}`,
    about: `attitude.report_${of}_inside`,
    ending: `-${of}.json`,
    made: async (workbench) => new Blob([written(workbench, of)], {type: "application/json"}),
  };
}
function written(workbench: Workbench, of: keyof AttitudeReply): string {
  const {reply} = desk_of(workbench);
  if (!reply) throw new Error("no answer yet");
  return `${JSON.stringify(reply[of], null, 2)}\n`;
}
export const attitude_files: readonly TaskFile[] = [
  report("convert"),
  report("screw"),
  report("rates"),
  {format: "png", name: "export.png", about: "attitude.png_inside", ending: ".png", made: stage_picture},
];
