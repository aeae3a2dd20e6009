import {mount, unmount} from "svelte";
import OutlineChoice from "./OutlineChoice.svelte";
import type {OutlineShape} from "../../contract/replies";

/** The one that the user takes; nothing where the dialog is closed. Where there is only one, it is not asked for. */
export function chosen_shape(
  shapes: readonly OutlineShape[],
  name: string,
  unit: string,
): Promise<OutlineShape | null> {
  if (shapes.length <= 1) return Promise.resolve(shapes[0] ?? null);
  return new Promise((resolve) => {
    const dialog = mount(OutlineChoice, {
      target: document.body,
      props: {
        shapes,
        name,
        unit,
        done: (shape: OutlineShape | null) => {
          resolve(shape);
          void unmount(dialog);
        },
      },
    });
  });
}
