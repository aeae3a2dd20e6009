// What the engine tells of special configurations has its words.
import {expect, it} from "vitest";
import {load_module} from "../engine/node";
import type {InstantReport, Point} from "../contract/messages";
import {known_text} from "../texts/texts.svelte";

const engine = load_module();

const bars = (input_circle: Point, output_circle: Point, output_center: Point = [4, 0]) => ({
  input_center: [0, 0],
  input_circle,
  output_center,
  output_circle,
});
it.each([
  ["coupler_parallel_to_frame", bars([1, 2], [3.5, 2])],
  ["parallel_side_links", bars([1, 1], [6, 2])],
  ["parallel_side_links_across_coupler", bars([0, 1], [4, 1], [4, -2])],
  ["parallelogram", bars([1, 2], [5, 2])],
  ["side_link_in_line_with_coupler", bars([1, 1], [3, 3])],
  ["side_link_on_frame_line", bars([1, 0], [3, 2])],
])("%s", async (code, pivots) => {
  const {instant} = JSON.parse((await engine).report("instant", JSON.stringify({pivots}))) as InstantReport;
  const notes = "degenerate" in instant ? [] : instant.notes;
  expect(notes.map((note) => note.code)).toEqual([code]);
  expect(known_text(`instant.${code}`)).not.toBeNull();
});
