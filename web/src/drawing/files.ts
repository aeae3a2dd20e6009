// Files dropped on the drawing or chosen from the menu.
import {poses_extent, with_view} from "../state/problem";
import {is_picture, picture} from "./background";
import type {Bench} from "./bench";
import {with_outline} from "./drags/outline_drags";
import {is_outline_file, read_outlines} from "./outline_file";
import {chosen_shape} from "./outlines/choice";

export function is_drawing_file(file: File): boolean {
  return is_outline_file(file, true) || is_picture(file);
}
/** A DXF is an outline, a PNG or JPEG a background; an SVG is an outline while the outline is edited. */
export async function take_file(bench: Bench, file: File): Promise<void> {
  const {workbench} = bench;
  if (is_outline_file(file, workbench.mode === "outline")) await take_outline(bench, file);
  else if (is_picture(file)) await take_picture(bench, file);
}
/** Where the drawing has several shapes, one is asked for. */
export async function take_outline({workbench, scene}: Bench, file: File): Promise<void> {
  const {name} = file,
    shapes = await read_outlines(workbench, file, 0.3 * poses_extent(scene.poses));
  if (typeof shapes === "string") return workbench.say("drawing.no_outline", {name, why: shapes});
  const shape = await chosen_shape(shapes, name, workbench.unit);
  if (!shape) return;
  scene.draft = null;
  workbench.edit((problem) => with_outline(problem, shape.outline));
}
export async function take_picture({workbench, scene}: Bench, file: File): Promise<void> {
  const background = file.size < 64e6 ? await picture(file, scene.view) : null;
  if (!background) return workbench.say("drawing.no_picture", {name: file.name});
  workbench.edit((problem) => with_view(problem, {background}));
  scene.marks = [];
  workbench.mode = "scale";
}
