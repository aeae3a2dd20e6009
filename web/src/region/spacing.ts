import {whole} from "../contract/messages";
import {with_options, type Options} from "../state/problem";
import type {Workbench} from "../state/workbench.svelte";
import {defaults} from "../state/defaults";

/** Spaces the axes otherwise. The linkages stay what they are, so their markers move. */
export function set_spacing(workbench: Workbench, spacing: NonNullable<Options["spacing"]>): void {
  if ((workbench.problem.options?.spacing ?? defaults.options.spacing) === spacing) return;
  workbench.window = whole;
  workbench.edit_document((document) => ({
    ...document,
    problem: with_options(document.problem, {spacing: spacing === defaults.options.spacing ? undefined : spacing}),
    picked: document.picked && {...document.picked, place: null},
    pins: document.pins.map((pin) => ({...pin, place: undefined})),
  }));
}
