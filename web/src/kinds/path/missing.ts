// What a path task lacks, or has too much of, before the engine is asked, and what a click on the drawing adds to it.
import {position_count} from "../../state/task";
import type {TextKey} from "../../texts/texts.svelte";
import type {Incomplete} from "../kind";
import {angle_counts, angle_key, form_of, type PathTask} from "./task";

/** Null: it is complete. */
export function incompleteness(task: PathTask): Incomplete | null {
  switch (form_of(task)) {
    case "angles":
      return counted(position_count(task.points), 4, 5, "state.too_few_points", "state.too_many_points", true);
    case "some":
      return of_some_angles(task);
    case "near":
      return of_near(task);
    default:
      return about_pivots(task);
  }
}
const few = (text: TextKey, n: number): Incomplete => ({state: "too_few", text, n}),
  many = (text: TextKey, n: number): Incomplete => ({state: "too_many", text, n});
/** `tells_count`: how many there are; otherwise how many are missing or too many. */
function counted(
  n: number,
  fewest: number,
  most: number,
  if_few: TextKey,
  if_many: TextKey,
  tells_count = false,
): Incomplete | null {
  if (n < fewest) return few(if_few, tells_count ? n : fewest - n);
  return n > most ? many(if_many, tells_count ? n : n - most) : null;
}

/** A path is fitted to three different points or more. */
function of_near({points}: PathTask): Incomplete | null {
  const different = new Set(points.map(({x, y}) => `${x} ${y}`)).size;
  return different < 3 ? few("state.path_few_near", 3 - different) : null;
}
/** Three positions with angles go with two without, four with one. */
function of_some_angles(task: PathTask): Incomplete | null {
  const {angled, plain} = angle_counts(task);
  if (!angled) return few("state.path_no_angles", plain);
  if (angled < 3) return few("state.path_few_angles", 3 - angled);
  if (angled > 4) return many("state.path_many_angles", angled - 4);
  return angled === 3
    ? counted(plain, 2, 2, "state.path_few_with_3", "state.path_many_with_3")
    : counted(plain, 1, 1, "state.path_few_with_4", "state.path_many_with_4");
}
function about_pivots(task: PathTask): Incomplete | null {
  const {angled, plain} = angle_counts(task);
  if (angle_key(task) === "theta_deg") return many("state.path_coupler_and_pivots", angled);
  if (angled && plain) return few("state.path_some_and_pivots", plain);
  if (angled) return counted(angled, 3, 3, "state.path_few_timed", "state.path_many_timed");
  if (form_of(task) === "pivot")
    return counted(plain, 5, 5, "state.too_few_points_pivot", "state.too_many_points_pivot");
  if (plain === 4) return few("state.path_four_points", 1);
  return counted(plain, 3, 5, "state.too_few_points_pivots", "state.too_many_points_pivots");
}

/** Whether a click adds a point, and one with an angle; null: the task lacks none. */
export function wanted_point(task: PathTask): "angled" | "plain" | null {
  const missing = incompleteness(task);
  if (missing?.state !== "too_few") return null;
  const {angled, plain} = angle_counts(task);
  switch (form_of(task)) {
    case "angles":
      return "angled";
    case "some":
      return angled < 3 ? (angled > 0 ? "angled" : plain < 5 ? "plain" : null) : "plain";
    case "near":
      return "plain";
    default:
      return angled && plain ? null : angled ? "angled" : "plain";
  }
}
